#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes what Qt's moc would write of a test, for the stand-in: the list of its cases. Usage: cases_of.py TEST.cpp OUT.moc"""

import pathlib
import re
import sys

CLASS = re.compile(r"^class (\w+)[^;{]*: public QObject \{\n(.*?)^\};", re.M | re.S)
SLOTS = re.compile(r"^private slots:\n(.*?)(?=^(?:private|public|protected)[^\n]*:|\Z)", re.M | re.S)
CASE = re.compile(r"^    void (\w+)\(\)", re.M)


def listing(text):
    lines = []
    for name, body in CLASS.findall(text):
        lines.append(f"void {name}::add_cases(std::vector<tp_stand_in::Case>& cases) {{")
        for slots in SLOTS.findall(body):
            for case in CASE.findall(slots):
                lines.append(f'    cases.push_back({{"{case}", [](QObject& test) {{ static_cast<{name}&>(test).{case}(); }}}});')
        lines.append("}")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    pathlib.Path(sys.argv[2]).write_text(listing(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")), encoding="utf-8")
