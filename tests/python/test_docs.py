# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of docs/python.md run and print what the page says."""

import contextlib
import io
import os
import re
import shutil
import tempfile
import unittest

import shapes


class Docs(unittest.TestCase):
    def test_the_examples_of_the_page_print_what_it_says(self):
        page = (shapes.SOURCE / "docs/python.md").read_text()
        examples = re.findall(r"```python\n(.*?)```(?:(?:\n\nPrints)?\n\n```\n(.*?)```)?", page, re.S)
        self.assertGreater(len(examples), 6)
        with tempfile.TemporaryDirectory() as folder:
            os.makedirs(folder + "/resources/models")
            shutil.copy(shapes.SOURCE / "resources/models/panel.step", folder + "/resources/models")
            before = os.getcwd()
            self.addCleanup(os.chdir, before)
            os.chdir(folder)
            names = {}
            for code, wanted in examples:
                printed = io.StringIO()
                with contextlib.redirect_stdout(printed):
                    exec(compile(code, "docs/python.md", "exec"), names)
                self.assertEqual(printed.getvalue(), wanted, code)
            os.chdir(before)


if __name__ == "__main__":
    unittest.main()
