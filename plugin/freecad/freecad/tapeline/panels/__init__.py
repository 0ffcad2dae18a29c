# SPDX-License-Identifier: GPL-3.0-or-later
"""Task panels, one a command. They take plain data from the document, compute off the window's thread, and change the
document only on OK or Apply, in one step of undo."""
