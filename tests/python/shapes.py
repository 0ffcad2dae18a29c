# SPDX-License-Identifier: GPL-3.0-or-later
"""Models that the tests share."""

import os
import pathlib
import subprocess

import numpy as np

import tapeline

SOURCE = pathlib.Path(__file__).resolve().parents[2]
COMMAND = os.environ.get("TAPELINE_COMMAND", str(SOURCE / "build/dev/bin/tapeline"))
LAW = [0, 10, 25, 30, 25, 10, 0]


def crease_panel(nx=32, ny=24, jitter=0.0):
    """800 x 600 mm, bent by 12 degrees along y = 0: vertices (n, 3) and triangles (m, 3). Vertices off crease and border
    are shifted by up to `jitter` of a cell."""
    x, y = np.meshgrid(np.linspace(-400, 400, nx + 1), np.linspace(-300, 300, ny + 1))
    random = np.random.default_rng(1)
    inside = (np.abs(x) < 399) & (np.abs(y) < 299) & (np.abs(y) > 1)
    x = x + inside * jitter * 800 / nx * random.uniform(-1, 1, x.shape)
    y = y + inside * jitter * 600 / ny * random.uniform(-1, 1, y.shape)
    z = np.where(y > 0, -np.tan(np.radians(12)) * y, 0)
    vertices = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    corner = np.arange((nx + 1) * ny).reshape(ny, nx + 1)[:, :-1].ravel()
    a, b, c, d = corner, corner + 1, corner + nx + 2, corner + nx + 1
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return vertices, faces


def panel(nx=32, ny=24):
    """The panel as a model, and the middle of its line."""
    model = tapeline.Model.from_arrays(*crease_panel(nx, ny))
    return model, model.feature_lines()[0].part("20%", "80%")


def run_command(*arguments):
    """Runs the command; fails with what it said."""
    done = subprocess.run([COMMAND, *map(str, arguments), "--quiet"], capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return done.stdout
