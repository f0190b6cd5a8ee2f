#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the summary of a test run, which stands alone: each stage with its time, each failed test with the command that runs
it again, each skipped test with its reason. The last line is CTest's own for the last tests that ran.

summary.py RESULTS STATUS STAGE…

RESULTS holds `stages` (a line for each stage that began: seconds since 1970, name), `left_out` (a line for each stage that
cannot run here: name, tab, reason) and, of each test run, PRESET.xml (CTest's
JUnit report) and PRESET.log (its output). STATUS is the exit status of the run; STAGE… are all stages in their order.
"""

from __future__ import annotations

import pathlib
import re
import sys
import time
import xml.etree.ElementTree as ElementTree

LONGEST_REASON = 200


def duration(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 120 else f"{seconds / 60:.0f} min"


def reason(output: str) -> str:
    """Why a test was skipped, in its own words: a Qt Test's SKIP lines, else the last line that it printed."""
    cases = re.findall(r"^SKIP   : \S+ (.*)$", output, re.MULTILINE)
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    words = "; ".join(dict.fromkeys(cases)) or (lines[-1] if lines else "gives no reason")
    return words if len(words) <= LONGEST_REASON else words[:LONGEST_REASON - 1] + "…"


def tests_of(report: pathlib.Path, preset: str) -> list[str]:
    """The lines of one CTest run."""
    counts = {"run": 0, "fail": 0, "notrun": 0}
    failed, skipped, partly = [], [], []
    for case in ElementTree.parse(report).getroot().iter("testcase"):
        name, status = case.get("name", ""), case.get("status", "")
        counts[status] = counts.get(status, 0) + 1
        output = case.findtext("system-out") or ""
        again = f"ctest --preset {preset} -R '^{re.escape(name)}$'"
        if status == "fail":
            failed.append(f"  failed: {name}: {again}")
        elif status == "notrun" and case.find("skipped") is not None and "SKIP_RETURN_CODE" in case.find("skipped").get("message", ""):
            skipped.append(f"  skipped: {name}: {reason(output)}")
        elif status != "run":
            failed.append(f"  not run: {name}: {again}")
        elif re.search(r"^SKIP   :", output, re.MULTILINE):
            partly.append(f"  partly skipped: {name}: {reason(output)}")
    total = sum(counts.values())
    head = f"  {counts['run']} passed, {len(failed)} failed, {len(skipped)} skipped of {total} tests"
    return [head, *failed, *skipped, *partly]


def summary(results: pathlib.Path, status: int, stages: list[str], now: float) -> list[str]:
    began = {}
    if (results / "stages").exists():
        for line in (results / "stages").read_text(encoding="utf-8").splitlines():
            second, _, name = line.partition(" ")
            began[name] = float(second)
    left_out = {}
    if (results / "left_out").exists():
        left_out = dict(line.split("\t", 1) for line in (results / "left_out").read_text(encoding="utf-8").splitlines())
    lines = []
    names = list(began)
    for stage in stages:
        if stage in left_out:
            lines.append(f"{stage}: skipped: {left_out[stage]}")
            continue
        if stage not in began:
            lines.append(f"{stage}: not reached")
            continue
        last = stage == names[-1]
        ended = now if last else began[names[names.index(stage) + 1]]
        verdict = "passed" if status == 0 or not last else "FAILED"
        lines.append(f"{stage}: {verdict} in {duration(ended - began[stage])}")
        preset = stage.removesuffix(" tests")
        report = results / f"{preset}.xml"
        if stage.endswith(" tests") and report.exists():
            lines += tests_of(report, preset)
    if names:
        lines.append(f"All: {'passed' if status == 0 else 'FAILED'} in {duration(now - min(began.values()))}")
    logs = sorted(results.glob("*.log"), key=lambda log: log.stat().st_mtime)
    if logs:
        of_ctest = re.findall(r"^\d+% tests passed, .*$", logs[-1].read_text(encoding="utf-8", errors="replace"), re.MULTILINE)
        lines += of_ctest[-1:]
    return lines


def main() -> int:
    if len(sys.argv) < 4:
        print(__doc__, file=sys.stderr)
        return 2
    print("\n== Summary")
    print("\n".join(summary(pathlib.Path(sys.argv[1]), int(sys.argv[2]), sys.argv[3:], time.time())), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
