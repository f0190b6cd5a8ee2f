#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The check of systems finds headers that not every system has, and only those."""

import pathlib
import tempfile
import unittest

from systems import faults


def found(files):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        return list(faults(root))


class Systems(unittest.TestCase):
    def test_a_header_of_a_system_is_refused(self):
        for header in ("unistd.h", "fcntl.h", "sys/stat.h", "dlfcn.h", "pthread.h", "poll.h", "termios.h", "signal.h", "sched.h",
                       "linux/videodev2.h", "spawn.h", "dirent.h", "malloc.h", "elf.h", "seccomp.h", "windows.h", "winsock2.h"):
            self.assertEqual(found({"core/a.cpp": f"#include <{header}>\n"}),
                             [f"core/a.cpp: includes <{header}>, which not every system has; use a port, such as"
                              " core/files/open_file.hpp, or put it into a_posix.cpp"])

    def test_under_a_condition_too(self):
        self.assertEqual(len(found({"app/b/c.hpp": "#if defined(__linux__)\n#  include <poll.h>\n#endif\n"})), 1)

    def test_each_file_is_told_once_with_all_its_headers(self):
        [sentence] = found({"audio/a.hpp": "#include <poll.h>\n#include <vector>\n#include <unistd.h>\n"})
        self.assertIn("<poll.h>, <unistd.h>", sentence)

    def test_where_the_name_says_so_it_may_stand(self):
        for name in ("core/a_posix.cpp", "core/a_linux.hpp", "device/b/c_windows.cpp", "app/d_macos.mm", "device/windows/a.hpp"):
            self.assertEqual(found({name: "#include <unistd.h>\n"}), [])
        for name in ("core/posix.cpp", "core/posix_a.cpp", "core/a_unix.cpp", "core/compositix/a.cpp"):
            self.assertEqual(len(found({name: "#include <unistd.h>\n"})), 1)

    def test_what_every_system_has_may_be_included(self):
        text = "#include <csignal>\n#include <stdint.h>\n#include <turbojpeg.h>\n#include \"core/files/link.hpp\"\n#include <archive.h>\n"
        self.assertEqual(found({"core/a.cpp": text}), [])

    def test_tests_are_not_looked_at(self):
        self.assertEqual(found({"tests/a.cpp": "#include <unistd.h>\n"}), [])


if __name__ == "__main__":
    unittest.main()
