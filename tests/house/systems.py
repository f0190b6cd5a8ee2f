#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Keeps what only some systems have where its name says so: a header of POSIX, Linux, macOS or Windows stands in a file of
the house whose name ends in _posix, _linux, _macos or _windows, or in a folder of such a name. The rest uses ports, such as
core/files/open_file.hpp.

Tests are not looked at. Usage: systems.py ROOT
"""

import pathlib
import re
import sys

ROOMS = ["app", "core", "device", "audio", "faces"]
SOURCES = {".cpp", ".hpp", ".c", ".h", ".inc", ".mm"}
SYSTEMS = ["posix", "linux", "macos", "windows"]
# POSIX.1-2017, chapter 13, without what is C's as well; then Linux's and glibc's, macOS's, and Windows's.
HEADERS = re.compile(
    r"aio|cpio|dirent|dlfcn|fcntl|fmtmsg|fnmatch|ftw|glob|grp|iconv|langinfo|libgen|monetary|mqueue|ndbm|netdb|nl_types|poll"
    r"|pthread|pwd|regex|sched|search|semaphore|signal|spawn|strings|stropts|syslog|tar|termios|trace|ulimit|unistd|utime"
    r"|utmpx|wordexp|(?:arpa|net|netinet|sys)/\w+"
    r"|alloca|byteswap|elf|endian|err|error|execinfo|features|getopt|gnu/\w+|link|malloc|mntent|pty|ucontext|utmp"
    r"|(?:linux|asm|asm-generic)/\w+|seccomp"
    r"|(?:mach|mach-o|libkern|xpc|CoreFoundation|IOKit)/[\w/]+|libproc|Availability(?:Macros)?|TargetConditionals"
    r"|windows|win\w+|shlobj|shlobj_core|shellapi|setupapi|cfgmgr32|hidsdi|hidpi|io|direct|process|initguid|objbase|knownfolders"
    r"|avrt|tlhelp32|psapi|dbghelp|fileapi|handleapi|synchapi", re.IGNORECASE)
INCLUDE = re.compile(r"^\s*#\s*(?:include|import)\s+[<\"]([^>\"]+)\.h[>\"]", re.M)


def says_its_system(path):
    """Whether the name of a file, or of a folder it lies in, says for which systems it is."""
    return any(path.stem.endswith(f"_{system}") for system in SYSTEMS) or any(part in SYSTEMS for part in path.parts[:-1])


def headers_of_systems(text):
    return [f"{name}.h" for name in INCLUDE.findall(text) if HEADERS.fullmatch(name)]


def faults(root):
    """Sentences, one for each file that does not keep to it."""
    for room in ROOMS:
        for path in sorted(path for path in (root / room).rglob("*") if path.suffix in SOURCES):
            name = path.relative_to(root)
            found = headers_of_systems(path.read_text(encoding="utf-8"))
            if found and not says_its_system(name):
                yield (f"{name.as_posix()}: includes <{'>, <'.join(found)}>, which not every system has; use a port, such as"
                       f" core/files/open_file.hpp, or put it into {name.stem}_posix{name.suffix}")


def main():
    root = pathlib.Path(sys.argv[1])
    count = 0
    for sentence in faults(root):
        print(sentence)
        count += 1
    return 1 if count or not (root / "core").is_dir() else 0


if __name__ == "__main__":
    sys.exit(main())
