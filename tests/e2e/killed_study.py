#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The whole program is killed at random moments while a participant names shapes by keys: what had been kept is there, at most the
trial that ran is lost; the next start says so, and does that trial again.

killed_study.py PROGRAM LAB    ends in 77 where something is missing; TP_MOMENTS=200 tries as many moments
"""
import glob
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import threading
import time

import desk
from album import preferences

LONGEST_S = 6.0  # from consent to the kill
LOST = "A trial was running when the program ended; it is done again."


class Study:
    def __init__(self, lab, folder):
        self.lab, self.folder = lab, os.path.join(folder, "Documents", "TouchPhoto studies", "primitives")
        self.participant = 1

    def table(self):
        """Its bytes up to the last whole line."""
        path = os.path.join(self.folder, f"participant-{self.participant:03}.csv")
        if not os.path.exists(path):
            return b""
        with open(path, "rb") as file:
            return file.read().rpartition(b"\n")[0]

    def last_participant(self):
        """The highest number of those who have a whole line under the columns; 0: nobody has."""
        tables = pathlib.Path(self.folder).glob("participant-*.csv")
        return max((int(table.stem[-3:]) for table in tables if table.read_bytes().count(b"\n") > 1), default=0)

    def trials(self):
        return len(self.table().splitlines()[1:])

    def noted(self):
        """The number of the trial that was noted as running; 0: none."""
        path = os.path.join(self.folder, "running.txt")
        if not os.path.exists(path):
            return 0
        with open(path, encoding="ascii") as file:
            participant, trial = re.match(r"participant-(\d+)-trial-(\d+)\.csv\.gz\n$", file.read()).groups()
        return int(trial) if int(participant) == self.participant else 0

    def faults(self):
        if not os.path.exists(os.path.join(self.folder, "protocol.study")):
            return []  # killed before it began
        done = subprocess.run([self.lab, "study", "check", self.folder], capture_output=True, text=True)
        lines = [line for line in done.stdout.splitlines() if " trials of " not in line and line != "There are no trials yet."]
        assert (done.returncode == 0) == (not lines), done
        # A machine with much else to do looks at the finger more seldom, which is no matter of kills.
        return [line for line in lines if " samples; in the trial's time there are " not in line]


def sits_down(page, listener, study):
    """From the start of the program to the trial that comes; what was said then."""
    page.await_name("Start with participant …")
    desk.awaited(lambda: any(node.getState().contains(page.atspi.STATE_FOCUSED) for node in page.shown()
                             if node.getRole() != page.atspi.ROLE_FRAME))
    page.keys("2")
    listener.await_words("Naming shapes of three sizes")
    page.await_name(f"Start with participant {1 + study.last_participant()}")
    page.keys("n", *str(study.participant), "Return")
    page.await_name(f"Start with participant {study.participant}")
    page.await_name(f"Participant {study.participant} …")  # the folder has been looked at
    page.keys("s")
    listener.await_words("You are asked to take part in a study")
    page.keys("Return")


def hears_where_the_study_is(listener):
    end = time.monotonic() + desk.PATIENCE
    while not any("Press Space to start." in heard for heard in listener.heard):
        assert time.monotonic() < end, f"no trial was offered; heard {listener.heard}"
        listener.listen()
    return " ".join(listener.heard)


def names_shapes(page, running, moment):
    """Until the program is killed, so many seconds from now; stops for a look after each."""
    kill = threading.Timer(moment, running.kill)
    kill.start()
    while running.poll() is None:
        page.keys("space", "Right")
        time.sleep(0.3)
        page.keys("space", "1")
        yield
    kill.join()


def journey(program, lab, folder, moments):
    listener, study = desk.Listener(quick=True), Study(lab, folder)
    environment = preferences(folder, asked=True, voice="screen_reader", language="en")
    chance, lost, told_lost = random.Random(20261126), False, 0
    for number in range(moments + 1):
        listener.heard.clear()
        study.participant = 1 + max(0, number - 1) // 2  # of whom nobody comes to the end
        page = desk.Page()
        running = subprocess.Popen([program, "--page", "study"], env=environment)
        try:
            sits_down(page, listener, study)
            before, done = study.table(), study.trials()
            if number == moments:  # the last day is an undisturbed one
                said = hears_where_the_study_is(listener)
                page.keys("space", "Right", "space", "1")
                desk.awaited(lambda: study.trials() == done + 1)
                page.keys("Escape", "Escape")
                listener.await_words("Everything is kept.")
            else:
                if number > 0:
                    said = hears_where_the_study_is(listener)
                for _ in names_shapes(page, running, chance.uniform(0.0, LONGEST_S)):
                    assert study.table().startswith(before), "a trial that was kept has changed"
                    before = study.table()
        finally:
            running.kill() if number < moments else running.terminate()
            running.wait(timeout=20)
        if number > 0:
            assert (LOST in said) == lost, f"lost: {lost}; said: {said}"
            told_lost += lost
        assert study.table().startswith(before), "a trial that was kept is gone"
        lost = study.noted() > study.trials()
        assert study.noted() in (0, study.trials(), study.trials() + 1), (study.noted(), study.trials())
        for fault in study.faults():
            assert any(part in fault for part in (LOST, "was being written when", "belongs to no trial that was kept")), fault
        print(f"moment {number}: {study.trials()} trials, {'one lost' if lost else 'none lost'}", flush=True)
    # A path without a line is of a trial that its participant, who did not come again, would have done again.
    wrong = [fault for fault in study.faults()
             if "belongs to no trial that was kept" not in fault or f"participant-{study.participant:03}-" in fault]
    assert wrong == [], wrong
    assert told_lost > 0, "no kill met a trial"
    paths = glob.glob(os.path.join(study.folder, "paths", f"participant-{study.participant:03}-*.csv.gz"))
    assert len(paths) == study.trials() > 0, (len(paths), study.trials())


def inner(program, lab):
    with desk.Desk(), tempfile.TemporaryDirectory() as folder:
        journey(program, lab, folder, int(os.environ.get("TP_MOMENTS", "8")))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    patience = 240 + 15 * int(os.environ.get("TP_MOMENTS", "8"))
    sys.exit(desk.verdict(inner, *sys.argv[1:]) if desk.is_at_a_desk() else desk.at_a_desk(__file__, "xdotool", seconds=patience))
