# SPDX-License-Identifier: Apache-2.0
"""A tree that `cmake --install` makes of a finished build, for tests: the program and the shell's part, each alone."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

BUILD = pathlib.Path(sys.argv.pop())
ROOT = pathlib.Path(sys.argv.pop())
NAME = "org.touchphoto.TouchPhoto"
SKIPPED = 77


def needs(*tools):
    """Ends the test as skipped where a tool is not there."""
    for tool in tools:
        if shutil.which(tool) is None:
            print(f"needs {tool}: packaging/packages/test.txt names the packages")
            sys.exit(SKIPPED)


class Installed:
    """Below `parts[component]` lies what belongs to /usr."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        self.parts = {}
        for component in ("touchphoto", "touchphoto-lab"):
            top = pathlib.Path(self.folder.name) / component
            subprocess.run(["cmake", "--install", BUILD, "--prefix", "/usr", "--component", component],
                           env={**os.environ, "DESTDIR": str(top)}, check=True, stdout=subprocess.DEVNULL)
            self.parts[component] = top / "usr"

    def run(self, component, *words, path="bin"):
        """The installed program, with nobody's home and no display."""
        program = self.parts[component] / path / (component if path == "bin" else words[0])
        words = words if path == "bin" else words[1:]
        home = pathlib.Path(self.folder.name) / "home"
        home.mkdir(exist_ok=True)
        return subprocess.run([program, *words], capture_output=True, text=True, encoding="utf-8", cwd=home,
                              env={"HOME": str(home), "PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"})
