#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The manual and what a shell completes, as they are installed: without a warning, and of the options that there are."""
import os
import re
import subprocess
import sys
import unittest

from installed import ROOT, Installed, needs

needs("man", "groff")
COMPLETION = "/usr/share/bash-completion/bash_completion"
if not os.path.exists(COMPLETION):
    needs("bash-completion")


def verbs(answer):
    """The verbs that --help lists."""
    return re.findall(r"^  ([a-z][a-z-]*) +\S", answer, re.M)


class Manual(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.installed = Installed()

    def page(self, component, name):
        """The page as a person reads it, in one line."""
        file = self.installed.parts[component] / "share/man" / name
        shown = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", file], capture_output=True, text=True,
                               env={**os.environ, "MANWIDTH": "100", "LC_ALL": "C.UTF-8", "MANOPT": ""})
        self.assertEqual((shown.returncode, shown.stderr), (0, ""), name)
        return " ".join(shown.stdout.replace("\u2010\n", "").split())

    def completed(self, component, line):
        """What bash offers for the last word of a command line."""
        parts = self.installed.parts[component]
        script = (f"source {COMPLETION}; PATH={parts}/bin:$PATH; source {parts}/share/bash-completion/completions/{component}\n"
                  f"COMP_LINE={line!r}; COMP_POINT=${{#COMP_LINE}}; read -ra COMP_WORDS <<<\"$COMP_LINE\"\n"
                  "[[ $COMP_LINE == *' ' ]] && COMP_WORDS+=('')\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1)); COMPREPLY=()\n"
                  f"_{component.replace('-', '_')} 2>/dev/null; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
        done = subprocess.run(["bash", "--norc", "-c", script], capture_output=True, text=True, cwd=ROOT)
        self.assertEqual(done.stderr, "")
        return set(done.stdout.split())

    def test_the_program_s_page_has_every_option_and_key(self):
        page = self.page("touchphoto", "man1/touchphoto.1")
        said = subprocess.run([self.installed.parts["touchphoto"] / "bin/touchphoto", "--help"], capture_output=True,
                              text=True, env={**os.environ, "QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8"}).stdout
        options = set(re.findall(r"^  (?:-\w, )?(--[a-z-]+)", said, re.M))
        self.assertIn("--page", options)
        self.assertEqual({option for option in options if option not in page}, set())
        self.assertIn("Space, T guided tour", page)
        self.assertEqual(options - {"--help-all"}, self.completed("touchphoto", "touchphoto --"))

    def test_the_shell_s_page_has_every_verb_with_its_options(self):
        page = self.page("touchphoto-lab", "man1/touchphoto-lab.1")
        for verb in verbs(self.installed.run("touchphoto-lab", "--help").stdout):
            said = self.installed.run("touchphoto-lab", verb, "--help").stdout
            for option in re.findall(r"^  (?:-\w, )?(--[a-z-]+)", said, re.M):
                self.assertIn(option, page, verb)
        self.assertIn("which expression a finger can tell", page.lower())
        self.assertNotIn("`", page)

    def test_the_helpers_pages_say_who_starts_them(self):
        for helper in ("touchphoto-force-guard", "touchphoto-decoder"):
            page = self.page("touchphoto", f"man8/{helper}.8")
            self.assertIn("started by TouchPhoto", page)
            self.assertIn(f"{helper} --version", page)

    def test_a_shell_completes_verbs_and_their_options(self):
        self.assertEqual(self.completed("touchphoto-lab", "touchphoto-lab "),
                         {*verbs(self.installed.run("touchphoto-lab", "--help").stdout), "--help", "--version"})
        self.assertEqual(self.completed("touchphoto-lab", "touchphoto-lab fac"), {"faces"})
        self.assertIn("import", self.completed("touchphoto-lab", "touchphoto-lab album "))
        self.assertEqual(self.completed("touchphoto-lab", "touchphoto-lab faces --over"), {"--overlay"})
        self.assertEqual(self.completed("touchphoto-lab", "touchphoto-lab album scan --look"), {"--look-only"})
        self.assertIn("README.md", self.completed("touchphoto-lab", "touchphoto-lab album scan READ"))

    def test_a_shell_completes_pages(self):
        self.assertEqual(self.completed("touchphoto", "touchphoto --page c"), {"care", "capture"})
        self.assertEqual(self.completed("touchphoto", "touchphoto resources/samples/anna_sa"),
                         {"resources/samples/anna_sad.jpg"})


if __name__ == "__main__":
    sys.exit(unittest.main())
