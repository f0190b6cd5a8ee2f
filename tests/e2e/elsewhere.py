# SPDX-License-Identifier: Apache-2.0
"""The clone works from any folder: the house checks, packaging/run and a virtual machine, from below /tmp, from a path with a
space, quotes and a letter that is not ASCII, and through a symbolic link.

elsewhere.py SOURCES BUILD VM_TEST    ends in 77 where this system lets nobody mount a folder in a second place

The finished build is mounted in a second place, in a namespace of its own; nothing is built again. The tests are CTest's own
entries with the folder in their commands replaced.
"""

from __future__ import annotations

import os
import pathlib
import re
import subprocess
import sys
import tempfile

SKIPPED = 77
FOLDER = "x y's \"ä\""


def enter_namespace() -> int:
    """Runs this script again where it may mount; its exit status."""
    unshare = ["unshare", "--mount", "--propagation", "private", *(["--map-root-user"] if os.getuid() != 0 else [])]
    with tempfile.TemporaryDirectory() as folder:
        tried = subprocess.run([*unshare, "mount", "--bind", folder, folder], capture_output=True, text=True, check=False)
    if tried.returncode != 0:
        print(f"SKIP: no folder can be mounted in a second place here: {tried.stderr.strip()}")
        return SKIPPED
    return subprocess.run([*unshare, sys.executable, __file__, *sys.argv[1:]],
                          env={**os.environ, "TP_IN_NAMESPACE": "1"}, check=False).returncode


def quoted(path: pathlib.Path) -> str:
    """As CTest's files write it."""
    return str(path).replace("\\", "\\\\").replace('"', '\\"')


def run_tests(build: pathlib.Path, sources: pathlib.Path, place: pathlib.Path, names: str) -> int:
    """CTest over those tests of the build, from `place` in place of `sources`; its exit status."""
    entries = ""
    for folder in ("house", "e2e", "vm"):
        text = (build / "tests" / folder / "CTestTestfile.cmake").read_text(encoding="utf-8")
        entries += re.sub(rf"{re.escape(quoted(sources))}(?=[/\"])", lambda _: quoted(place), text)
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "CTestTestfile.cmake").write_text(entries, encoding="utf-8")
        ran = subprocess.run(["ctest", "--test-dir", folder, "-R", names, "--output-on-failure", "--no-tests=error"], text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    print(ran.stdout)
    for name in re.findall(r"(\S+) \.+\*\*\*Skipped", ran.stdout):
        print(f"SKIP   : elsewhere() {name} is skipped there, too")
    return ran.returncode


def main() -> int:
    if "TP_IN_NAMESPACE" not in os.environ:
        return enter_namespace()
    sources, build = (pathlib.Path(name) for name in sys.argv[1:3])
    vm_test = sys.argv[3]
    # Not removed with what is in it: it holds the clone itself while that is mounted there.
    work = pathlib.Path(tempfile.mkdtemp(dir="/tmp"))
    place = work / FOLDER / "touchphoto"
    place.mkdir(parents=True)
    link = work / "link"
    link.symlink_to(place)
    subprocess.run(["mount", "--bind", sources, place], check=True)
    try:
        status = run_tests(build, sources, place, r"^(house\..*|e2e\.run_headless)$")
        return run_tests(build, sources, link, f"^{re.escape(vm_test)}$") or status
    finally:
        subprocess.run(["umount", "--lazy", place], check=False)
        link.unlink()
        for empty in (place, place.parent, work):
            empty.rmdir()


if __name__ == "__main__":
    sys.exit(main())
