# SPDX-License-Identifier: MIT
"""The `planish` command beside the package, and a place of its own for each test."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMMAND = ROOT / "build/native/planish"
SHARED = ROOT.parent / "shared/meshes"


class InFolder(unittest.TestCase):
    """Every test runs in an empty folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="planish-python-")
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    def command(self, *words, code=0):
        """Runs the command; its message if the exit code is as expected."""
        run = subprocess.run([COMMAND, *words], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, code, run.stderr)
        return run.stderr
