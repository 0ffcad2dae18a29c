# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands in menu and toolbar, one a file; each opens a panel, or does its one thing."""
