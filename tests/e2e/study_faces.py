#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A participant feels sixteen faces and names how they look, by keys and by what the program says; the faces come from a folder
that the researcher chooses. Then the report has them.

study_faces.py PROGRAM LAB DRAW_PORTRAITS    ends in 77 where something is missing
"""
import csv
import os
import subprocess
import sys
import tempfile

import desk
from study import start

TITLE = "Naming the expressions of faces"
TRAINING, TRIALS = 4, 16  # of resources/studies/expressions.study
EXPRESSIONS = ("smiling", "surprised", "sad", "angry")  # in the order of their keys


class Sitting:
    def __init__(self, page, listener, folder):
        self.page, self.listener = page, listener
        self.study = os.path.join(folder, "Documents", "TouchPhoto studies", "expressions")

    def hears(self, *sentences):
        self.listener.await_words(*sentences)
        for sentence in sentences:
            print("heard:", sentence)

    def rows(self):
        table = os.path.join(self.study, "participant-001.csv")
        if not os.path.exists(table):
            return []
        with open(table, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def opens_the_experiment(self):
        self.page.await_name("7: Studies…")
        desk.awaited(lambda: any(node.getState().contains(self.page.atspi.STATE_FOCUSED) for node in self.page.shown()
                                 if node.getRole() != self.page.atspi.ROLE_FRAME))
        self.page.keys("7")
        self.hears("Studies. ")
        self.page.keys("3")
        self.hears(TITLE)
        self.page.keys("s")
        self.hears("This experiment needs faces. Choose a folder")

    def chooses(self, folder):
        self.page.keys("g")
        self.hears("Folder ")
        self.page.press(folder + "…", self.page.atspi.ROLE_LIST_ITEM)
        self.hears("Folder " + folder)
        self.page.press("Choose this folder")
        self.hears("The faces are ")

    def agrees(self):
        self.page.await_name("Start with participant 1")
        self.page.keys("s")
        self.hears("You are asked to take part in a study: " + TITLE)
        self.page.keys("Return")

    def feels_and_names(self, trial, answer):
        before = len(self.rows())
        self.listener.await_words(trial)
        self.page.keys("space", "Right", "Down", "Left", "space")
        self.listener.await_words("How did the face look?")
        self.page.keys(str(1 + EXPRESSIONS.index(answer)))
        desk.awaited(lambda: len(self.rows()) == before + 1)


def inner(program, lab, draw):
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        crowd = os.path.join(folder, "Faces")
        subprocess.run([sys.executable, draw, "--crowd", "5", "--seed", "5", "--contours-only", "--out", crowd], check=True)
        listener = desk.Listener(quick=True)
        with start(program, folder, "en"):
            sitting = Sitting(desk.Page(), listener, folder)
            sitting.opens_the_experiment()
            sitting.chooses("Faces")
            sitting.agrees()
            for number in range(1, TRAINING + 1):
                sitting.feels_and_names(f"Training {number} of {TRAINING}", EXPRESSIONS[number % 4])
            for number in range(1, TRIALS + 1):
                sitting.feels_and_names(f"Trial {number} of {TRIALS}", EXPRESSIONS[number % 4])
            sitting.hears("That was the last trial.")
            sitting.page.keys("space")
            sitting.hears("The study has ended for participant 1.")
        counted = [row for row in sitting.rows() if row["training"] == "no"]
        shown = sorted((row["expression"], row["face"]) for row in counted)
        assert shown == sorted((which, str(face)) for which in EXPRESSIONS for face in range(1, 5)), shown
        assert all(row["correct"] == ("yes" if row["answer"] == row["expression"] else "no") for row in counted), counted
        for verb in (["check", sitting.study], ["report", sitting.study, "--out", os.path.join(folder, "report")]):
            done = subprocess.run([lab, "study", *verb], capture_output=True, text=True)
            assert done.returncode == 0, f"study {verb[0]}: {done.stdout}{done.stderr}"
            print(done.stdout)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, *sys.argv[1:]) if desk.is_at_a_desk() else desk.at_a_desk(__file__, "xdotool", seconds=280))
