# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets pip build the Python module: CMake makes the package, setuptools packs it. TAPELINE_BUILD names a build folder to
use or make; without it there is a fresh one."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parent
BASE = "build/pip"  # what setuptools leaves behind, out of the source tree


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        build = pathlib.Path(os.environ.get("TAPELINE_BUILD") or self.build_temp).resolve()
        if not (build / "CMakeCache.txt").exists():
            self.cmake("-S", SOURCE, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DTAPELINE_TESTS=OFF",
                       f"-DPython_EXECUTABLE={sys.executable}")
        self.cmake("--build", build, "--target", "tapeline_python")
        package = pathlib.Path(self.get_ext_fullpath(ext.name)).parent
        shutil.copytree(build / "python/tapeline", package, dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("__pycache__"))

    @staticmethod
    def cmake(*arguments):
        subprocess.run(["cmake", *map(str, arguments)], check=True)


(SOURCE / BASE).mkdir(parents=True, exist_ok=True)
version = re.search(r"VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text().partition("project(")[2]).group(1)
setup(version=version, packages=[], py_modules=[], ext_modules=[Extension("tapeline._tapeline", sources=[])],
      cmdclass={"build_ext": CMakeBuild}, options={"build": {"build_base": BASE}, "egg_info": {"egg_base": BASE}})
