#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes what Qt's moc would write of a test, for the stand-in: the list of its cases. Usage: cases_of.py TEST OUT.moc
Of a header, OUT includes it."""

import pathlib
import re
import sys

NAMESPACE = re.compile(r"^namespace ([\w:]+) \{$", re.M)
CLASS = re.compile(r"^class (\w+)[^;{]*: public ([\w:]+) \{\n(.*?)^\};", re.M | re.S)
SLOTS = re.compile(r"^private slots:\n(.*?)(?=^(?:private|public|protected)[^\n]*:|\Z)", re.M | re.S)
CASE = re.compile(r"^    void (\w+)\(\)", re.M)


def listing(text, within=""):
    lines = []
    for name, base, body in CLASS.findall(text):
        if "Q_OBJECT" not in body:
            continue
        lines.append(f"void {within}{name}::add_cases(std::vector<tp_stand_in::Case>& cases) {{")
        if base != "QObject":
            lines.append(f"    {base}::add_cases(cases);")
        for slots in SLOTS.findall(body):
            for case in CASE.findall(slots):
                lines.append(f'    cases.push_back({{"{case}", [](QObject& test) {{ static_cast<{within}{name}&>(test).{case}(); }}}});')
        lines.append("}")
    return "\n".join(lines) + "\n"


def moc_of(source):
    text = source.read_text(encoding="utf-8")
    namespace = NAMESPACE.search(text)
    cases = listing(text, f"{namespace[1]}::" if namespace else "")
    return f'#include "{source}"\n{cases}' if source.suffix == ".hpp" else cases


if __name__ == "__main__":
    pathlib.Path(sys.argv[2]).write_text(moc_of(pathlib.Path(sys.argv[1])), encoding="utf-8")
