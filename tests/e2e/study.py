#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A researcher and a participant do a whole experiment by keys and by what the program says: from the start page through
consent, training, trials, a break, a pause and a second day to the last trial; then the researcher hears how the study stands
and has its report made, and the folder on the disk is checked and reported by the lab's verbs. What is on the screen while a shape is felt shows nothing of it. In each language.

study.py PROGRAM LAB    ends in 77 where something is missing; TP_PICTURES=FOLDER keeps what was on the screen
"""
import csv
import glob
import os
import re
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

import desk
from album import preferences

LANGUAGES = ("en", "de", "ko")
CATALOGUES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "translations")
TRAINING, TRIALS, BREAK_AFTER = 3, 45, 15  # of resources/studies/primitives.study
SHAPES = ["circle", "triangle", "square", "pentagon", "hexagon"]
STOPPED_AFTER = 7  # trials; the rest is another day's
BORDER = 24  # px of the surface that its frame and its focus ring may have


class Words:
    """What the pages say in a language, by what their sources say."""

    def __init__(self, language):
        self.language, self.known = language, {}
        if language == "en":
            return
        for context in xml.etree.ElementTree.parse(os.path.join(CATALOGUES, f"touchphoto_{language}.ts")).iter("context"):
            for message in context.iter("message"):
                source, translation = message.find("source").text, message.find("translation")
                forms = translation.findall("numerusform")
                text = forms[-1].text if forms else translation.text
                self.known.setdefault(source, text)
                self.known[context.find("name").text, source] = text

    def __call__(self, source, *values, context=None):
        """In the first context that has it, where none is told."""
        text = self.known.get((context, source), self.known.get(source, source))
        for number, value in enumerate(values, 1):
            text = text.replace(f"%{number}", str(value))
        return text

    def beginning(self, source):
        """Until the first thing that varies."""
        return re.split("%", self(source))[0].strip()


class Screen:
    """What is to be seen, as numbers."""

    def __init__(self):
        import gi

        gi.require_version("Gdk", "3.0")
        from gi.repository import Gdk

        self.gdk = Gdk
        Gdk.init([])

    def part(self, place, keep=None):
        """Pixels of (x, y, width, height) on the screen: height × width × 3."""
        import numpy as np

        root = self.gdk.get_default_root_window()
        picture = self.gdk.pixbuf_get_from_window(root, *place)
        if keep:
            whole = self.gdk.pixbuf_get_from_window(root, 0, 0, root.get_width(), root.get_height())
            whole.savev(keep, "png", [], [])
        rows = np.frombuffer(picture.get_pixels(), dtype=np.uint8)
        stride, channels = picture.get_rowstride(), picture.get_n_channels()
        rows = np.pad(rows, (0, stride * picture.get_height() - len(rows)))
        return rows.reshape(picture.get_height(), stride)[:, : picture.get_width() * channels].reshape(
            picture.get_height(), picture.get_width(), channels)[:, :, :3]


class Sitting:
    def __init__(self, page, listener, words, folder):
        self.page, self.listener, self.words, self.folder = page, listener, words, folder

    def hears(self, *sentences):
        self.listener.await_words(*sentences)
        for sentence in sentences:
            print("heard:", sentence)

    def begins(self):
        """From the start page to the first trial."""
        words = self.words
        self.page.await_name("7: " + words("Studies") + "…")
        desk.awaited(lambda: any(node.getState().contains(self.page.atspi.STATE_FOCUSED) for node in self.page.shown()
                                 if node.getRole() != self.page.atspi.ROLE_FRAME))
        self.page.keys("7")
        self.hears(words("Studies. %1. Keys 1 to %2 choose the experiment, S starts it, F1 says more.",
                         words("Following contours, by stiffness and range"), 5))
        self.page.keys("2")
        self.hears(words("Naming shapes of three sizes"))

    def agrees(self, participant):
        self.page.await_name(self.words("Start with participant %1", participant))  # the folder has been looked at
        self.page.keys("s")
        self.hears(self.words("You are asked to take part in a study: %1. It has %3 trials. What is kept is the way of your "
                              "finger, the force on it, times and answers, on this computer only, under the number %2 and "
                              "without your name. You may pause at any time with P and stop with Escape, without giving a "
                              "reason; the force is then off at once. Nothing has been kept so far. If you agree, press "
                              "Enter. If you do not, press Escape.", self.words("Naming shapes of three sizes"),
                              participant, TRIALS))
        self.page.keys("Return")

    def rows(self):
        table = os.path.join(self.folder, "participant-001.csv")
        if not os.path.exists(table):
            return []
        with open(table, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def awaits_trial(self, number, training=False):
        words = self.words
        which = words("Training %1 of %2", number, TRAINING) if training else words("Trial %1 of %2", number, TRIALS)
        what = words("Feel the line; nothing is asked.") if training else words("Feel the shape.")
        self.listener.await_words(words("%1. %2 Press Space to start.", which, what))

    def feels_in_training(self):
        """A line, after which nothing is asked."""
        before = len(self.rows())
        self.page.keys("space", "Right", "Down", "space")
        desk.awaited(lambda: len(self.rows()) == before + 1)
        row = self.rows()[-1]
        assert (row["training"], row["answer"], row["correct"]) == ("yes", "", ""), row

    def feels_and_names(self, answer):
        before = len(self.rows())
        self.page.keys("space", "Right", "Down", "space")
        self.listener.await_words(self.words("Which was it?"))
        self.page.keys(str(answer))
        desk.awaited(lambda: len(self.rows()) == before + 1)


def nothing_is_seen(sitting, screen, keep):
    """While a shape is felt the surface is one field of one colour, its frame and its focus ring apart."""
    page = sitting.page
    sitting.page.keys("space", "Right", "Right", "Down")
    page.await_name(sitting.words("Running"))
    time.sleep(0.5)  # it is drawn
    surface = next(node for node in page.shown() if node.getRole() == page.atspi.ROLE_CANVAS)
    place = surface.queryComponent().getExtents(page.atspi.DESKTOP_COORDS)
    assert place.width > 300 and place.height > 300, (place.width, place.height)
    pixels = screen.part((place.x + BORDER, place.y + BORDER, place.width - 2 * BORDER, place.height - 2 * BORDER), keep)
    colours = {tuple(colour) for row in pixels for colour in row}
    assert len(colours) == 1, f"{len(colours)} colours on the surface"
    for node in page.shown():
        told = [shape for shape in SHAPES if ": " + sitting.words(shape) in node.name]
        assert not told or node.name.startswith(desk.SAID), f"\"{node.name}\" tells {told}"
    page.keys("p")
    sitting.hears(sitting.words("Paused. The trial is done again. Press Space to go on."))
    assert sitting.rows()[-1]["repeated"] == "yes", sitting.rows()[-1]
    page.keys("space")


def researcher_asks(sitting):
    """How the study stands, by key and as it is shown; its report, by the client."""
    words, report = sitting.words, sitting.folder + " report"
    sitting.page.keys("c")
    sitting.hears(words("Trials that count: %1.", TRIALS))
    sitting.page.await_name(words("Participants: %1.", 1) + "…")
    sitting.page.await_name(words("Nothing is wrong in the folder."))
    sitting.page.press(words("Make the report"))
    sitting.hears(words("The report is in %1. Open the file %2 there.", report, "report.html"))
    assert os.path.getsize(os.path.join(report, "report.html")) > 1000


def start(program, folder, language):
    environment = preferences(folder, asked=True, voice="screen_reader", language=language)
    return desk.started([program], env=environment)


def journey(program, lab, folder, language, listener, screen):
    words = Words(language)
    desk.SAID = words("Last sentence") + ": "  # the listener knows it by that
    study = os.path.join(folder, "Documents", "TouchPhoto studies", "primitives")
    sitting = Sitting(desk.Page(), listener, words, study)
    keep = os.environ.get("TP_PICTURES")
    with start(program, folder, language):
        sitting.begins()
        assert not os.path.exists(study), "something is written before consent"
        sitting.agrees(1)
        for number in range(1, TRAINING + 1):
            sitting.awaits_trial(number, training=True)
            sitting.feels_in_training()
        sitting.awaits_trial(1)
        nothing_is_seen(sitting, screen, keep and os.path.join(keep, f"study-{language}.png"))
        for number in range(1, STOPPED_AFTER + 1):
            listener.await_words(words("Trial %1 of %2", number, TRIALS))
            sitting.feels_and_names(1 + number % 5)
        listener.await_words(words("Trial %1 of %2", STOPPED_AFTER + 1, TRIALS))
        sitting.page.keys("Escape")
        sitting.hears(words("Stop the study? The force is off. Press Escape again to stop, or Space to go on."))
        sitting.page.keys("Escape")
        sitting.hears(words.beginning("Stopped. Everything is kept. %1"))
    with start(program, folder, language):  # the next day
        sitting.begins()
        sitting.page.await_name(words("Start with participant %1", 2))
        sitting.page.keys("n", "1", "Return")
        sitting.hears(words("Participant %1", 1))
        sitting.page.await_name(words("%1 has done %2 of %3 trials.", words("Participant %1", 1), STOPPED_AFTER, TRIALS) + "…")
        sitting.agrees(1)
        for number in range(STOPPED_AFTER + 1, TRIALS + 1):
            listener.await_words(words("Trial %1 of %2", number, TRIALS))
            sitting.feels_and_names(1 + number % 5)
            if number % BREAK_AFTER == 0 and number < TRIALS:
                sitting.hears(words.beginning("Time for a break. %1 Press Space to go on."))
                sitting.page.keys("space")
        sitting.hears(words.beginning("That was the last trial. %1 Thank you. Press Space to end."))
        sitting.page.keys("space")
        sitting.hears(words("The study has ended for participant %1.", 1))
        researcher_asks(sitting)
    counted = [row for row in sitting.rows() if row["training"] == "no" and row["repeated"] == "no"]
    assert len(counted) == TRIALS, len(counted)
    paths = glob.glob(os.path.join(study, "paths", "*.csv.gz"))
    assert len(paths) == len(sitting.rows()), (len(paths), len(sitting.rows()))
    for verb in (["check", study], ["report", study, "--out", os.path.join(folder, "report")]):
        done = subprocess.run([lab, "study", *verb], capture_output=True, text=True)
        assert done.returncode == 0, f"study {verb[0]}: {done.stderr}"
        print(done.stdout)


def inner(program, lab):
    with desk.Desk():
        listener, screen = desk.Listener(quick=True), Screen()
        for language in LANGUAGES:
            with tempfile.TemporaryDirectory() as folder:
                journey(program, lab, folder, language, listener, screen)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, *sys.argv[1:]) if desk.is_at_a_desk() else desk.at_a_desk(__file__, "xdotool", seconds=580))
