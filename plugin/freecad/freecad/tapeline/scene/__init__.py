# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn in the 3D view beside document objects: labels, handles, tints and overlays, by Coin's scene graph."""
