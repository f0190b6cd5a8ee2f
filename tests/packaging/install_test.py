# SPDX-License-Identifier: Apache-2.0
"""How packaging/lib.sh installs packages: behind another program, without rights, without a network.

install_test.py LIB    packaging/lib.sh. apt-get, dpkg, sudo and id are stand-ins that behave as those of Debian 12 were seen to.
"""

from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

LIB = pathlib.Path(sys.argv.pop()).resolve()

# As apt 2.6.1 said it, in a container whose locks another process held.
FRONTEND = ("E: Could not get lock /var/lib/dpkg/lock-frontend. It is held by process 714 (unattended-upgr)\n"
            "E: Unable to acquire the dpkg frontend lock (/var/lib/dpkg/lock-frontend), is another process using it?\n")
LISTS = ("E: Could not get lock /var/lib/apt/lists/lock. It is held by process 715 (apt-get)\n"
         "E: Unable to lock directory /var/lib/apt/lists/\n")
ARCHIVES = ("E: Could not get lock /var/cache/apt/archives/lock. It is held by process 716 (apt-get)\n"
            "E: Unable to lock directory /var/cache/apt/archives/\n")
INTERRUPTED = "E: dpkg was interrupted, you must manually run 'dpkg --configure -a' to correct the problem. \n"

# Each call of apt-get takes the first file of $ANSWERS/VERB.N: its first line is the exit status, the rest goes to stderr.
APT_GET = r"""#!/bin/bash
for verb in "$@"; do case "$verb" in update | install) break ;; esac; done
echo "apt-get $verb" >>"$ANSWERS/calls"
for answer in "$ANSWERS/$verb".*; do
    [ -e "$answer" ] || break
    sed 1d "$answer" >&2
    status=$(head -n 1 "$answer")
    rm "$answer"
    exit "$status"
done
[ "$verb" != install ] || touch "$ANSWERS/installed"
"""
DPKG_QUERY = r"""#!/bin/bash
[ -e "$ANSWERS/installed" ] && printf installed
"""
OTHERS = {
    "apt-get": APT_GET,
    "dpkg-query": DPKG_QUERY,
    "dpkg": '#!/bin/bash\necho "dpkg $*" >>"$ANSWERS/calls"\n',
    "ccache": '#!/bin/bash\necho "$ANSWERS/cache"\n',
}


class Install(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top = pathlib.Path(folder.name)
        (self.top / "packaging/packages").mkdir(parents=True)
        shutil.copy(LIB, self.top / "packaging/lib.sh")
        (self.top / "packaging/packages/build.txt").write_text("# a list\ncmake\nccache # twice as fast\n", encoding="utf-8")
        self.answers = self.top / "answers"
        self.answers.mkdir()
        self.programs = self.top / "bin"
        self.programs.mkdir()
        for name, script in OTHERS.items():
            self.program(name, script)
        self.user(0)
        for name in ("bash", "env", "sed", "tr", "cat", "grep", "wc", "mktemp", "rm", "sleep", "head", "touch", "mkdir"):
            (self.programs / name).symlink_to(shutil.which(name))

    def program(self, name: str, script: str) -> None:
        (self.programs / name).write_text(script, encoding="utf-8")
        (self.programs / name).chmod(0o755)

    def user(self, number: int) -> None:
        self.program("id", f"#!/bin/bash\necho {number}\n")

    def answer(self, verb: str, *answers: tuple[int, str]) -> None:
        for number, (status, said) in enumerate(answers):
            (self.answers / f"{verb}.{number}").write_text(f"{status}\n{said}", encoding="utf-8")

    def install(self) -> subprocess.CompletedProcess[str]:
        return subprocess.run(["bash", "-c", 'set -euo pipefail; root=$1; . "$root/packaging/lib.sh"; install_packages build; echo done',
                               "install", self.top],
                              env={"PATH": str(self.programs), "ANSWERS": str(self.answers), "TOUCHPHOTO_LOCK_POLL_S": "0",
                                   "TOUCHPHOTO_LOCK_WAIT_S": "60", "TMPDIR": os.environ.get("TMPDIR", "/tmp")},
                              capture_output=True, text=True, check=False)

    def calls(self) -> list[str]:
        calls = self.answers / "calls"
        return calls.read_text(encoding="utf-8").splitlines() if calls.exists() else []

    def test_what_is_missing_is_installed(self) -> None:
        ran = self.install()
        self.assertEqual((ran.returncode, ran.stdout), (0, "done\n"), ran.stderr)
        self.assertEqual(self.calls(), ["apt-get update", "apt-get install"])
        self.assertIn("Installing 2 Debian packages: cmake ccache", ran.stderr)

    def test_nothing_is_asked_where_nothing_is_missing(self) -> None:
        (self.answers / "installed").touch()
        self.user(1000)  # and there is no sudo
        ran = self.install()
        self.assertEqual((ran.returncode, ran.stdout), (0, "done\n"), ran.stderr)
        self.assertEqual(self.calls(), [])

    def test_another_program_that_holds_a_lock_is_waited_for_and_named(self) -> None:
        self.answer("update", (0, LISTS), (100, LISTS))  # apt-get update ends in 0 or 100 there
        self.answer("install", (100, FRONTEND), (100, ARCHIVES), (100, FRONTEND))
        ran = self.install()
        self.assertEqual((ran.returncode, ran.stdout), (0, "done\n"), ran.stderr)
        self.assertEqual(self.calls(), 3 * ["apt-get update"] + 4 * ["apt-get install"])
        self.assertIn("held by process 715 (apt-get)", ran.stderr)
        self.assertIn("held by process 714 (unattended-upgr)", ran.stderr)
        self.assertEqual(ran.stderr.count("Waiting up to"), 2)

    def test_a_lock_that_is_held_for_ever_ends_in_a_sentence(self) -> None:
        self.answer("update", *[(100, LISTS)] * 100)
        ran = self.install()
        self.assertEqual((ran.returncode, ran.stdout), (1, ""), ran.stderr)
        self.assertIn("Another program still uses the package manager after 1 minutes. Run this again", ran.stderr)

    def test_an_installation_that_was_interrupted_is_completed(self) -> None:
        self.answer("install", (100, INTERRUPTED))
        ran = self.install()
        self.assertEqual((ran.returncode, ran.stdout), (0, "done\n"), ran.stderr)
        self.assertEqual(self.calls(), ["apt-get update", "apt-get install", "dpkg --configure -a", "apt-get install"])

    def test_another_failure_ends_at_once_with_its_reason(self) -> None:
        self.answer("install", (100, "E: Failed to fetch http://deb.debian.org/x Temporary failure resolving\n"))
        ran = self.install()
        self.assertEqual((ran.returncode, ran.stdout), (1, ""), ran.stderr)
        self.assertIn("Temporary failure resolving", ran.stderr)
        self.assertIn("it continues where it stopped", ran.stderr)
        self.assertEqual(self.calls(), ["apt-get update", "apt-get install"])

    def test_an_ordinary_user_without_sudo_is_told_what_to_ask_for(self) -> None:
        self.user(1000)
        ran = self.install()
        self.assertEqual((ran.returncode, ran.stdout), (1, ""), ran.stderr)
        self.assertIn("no sudo. Ask an administrator to run: apt-get install --no-install-recommends cmake ccache\n", ran.stderr)
        self.assertEqual(self.calls(), [])

    def test_a_user_whom_sudo_refuses_is_told_the_same(self) -> None:
        self.user(1000)
        self.program("sudo", "#!/bin/bash\necho 'anna is not in the sudoers file.' >&2\nexit 1\n")
        ran = self.install()
        self.assertEqual(ran.returncode, 1)
        self.assertIn("sudo does not let this user install them. Ask an administrator", ran.stderr)
        self.assertEqual(self.calls(), [])

    def test_an_ordinary_user_installs_through_sudo(self) -> None:
        self.user(1000)
        self.program("sudo", '#!/bin/bash\n[ "$1" = -v ] && exit 0\necho sudo >>"$ANSWERS/calls"\nexec "$@"\n')
        ran = self.install()
        self.assertEqual((ran.returncode, ran.stdout), (0, "done\n"), ran.stderr)
        self.assertEqual(self.calls(), ["sudo", "apt-get update", "sudo", "apt-get install"])

    def test_a_system_without_apt_is_told_so(self) -> None:
        (self.programs / "apt-get").unlink()
        ran = self.install()
        self.assertEqual(ran.returncode, 1)
        self.assertIn("This is not a Debian system.", ran.stderr)

    def test_a_cache_that_cannot_be_written_is_replaced_by_one_in_the_build_folder(self) -> None:
        (self.answers / "installed").touch()
        (self.answers / "cache").touch()  # a file, where a folder must be
        script = 'set -euo pipefail; root=$1; . "$root/packaging/lib.sh"; install_packages build; echo "$CCACHE_DIR"'
        ran = subprocess.run(["bash", "-c", script, "cache", self.top],
                             env={"PATH": str(self.programs), "ANSWERS": str(self.answers)}, capture_output=True, text=True, check=False)
        self.assertEqual(ran.stdout.strip(), str(self.top / "build/ccache"), ran.stderr)
        self.assertTrue((self.top / "build/ccache").is_dir())

    def test_a_signal_ends_a_script_with_its_own_status(self) -> None:
        for signal, status in (("HUP", 129), ("INT", 130), ("TERM", 143)):
            script = f'set -euo pipefail; root=$1; . "$root/packaging/lib.sh"; trap \'echo "ended in $?"\' EXIT; kill -{signal} $$'
            ran = subprocess.run(["bash", "-c", script, "signal", self.top], env={"PATH": str(self.programs)}, capture_output=True,
                                 text=True, check=False)
            self.assertEqual((ran.returncode, ran.stdout), (status, f"ended in {status}\n"), ran.stderr)
            self.assertIn("the same command continues from here", ran.stderr)


if __name__ == "__main__":
    unittest.main()
