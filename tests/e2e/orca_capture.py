#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A blind person takes a photograph with Orca, by keys only: is told where the camera is to go and goes there, hears what was
taken, speaks a memo, and finds the photograph in Browse. What Orca gives its voice is asserted in order.

orca_capture.py PROGRAM LAB FACE PHOTOS...    FACE is what the camera looks at; ends in 77 where something is missing
"""
import os
import subprocess
import sys
import tempfile
import time

import desk
from album import Album, preferences, tone
from capture import MOST_SENTENCES, PATIENT_FOR, Words, hand
from orca import Listener, beside, journey


class Photographer(Listener):
    def __init__(self, page, orca, album):
        super().__init__(page, orca)
        self.album = album
        self.ways = hand(Words("en"))

    def photographs(self):
        return sorted(name for name in os.listdir(self.album.folder) if name.endswith(".jpg"))

    def opens_the_camera(self):
        self.orca.says("notification TouchPhoto, start page.")
        self.presses("6", "Camera view canvas.")

    def is_led_until_it_is_taken(self):
        """Does what Orca says; who waits in vain presses Space."""
        before = len(self.photographs())
        end = time.monotonic() + desk.PATIENCE
        moves = 0
        while not (said := self.orca.next(PATIENT_FOR) or "").startswith("notification Taken: "):
            assert time.monotonic() < end and moves < MOST_SENTENCES, "no photograph was taken"
            if not said:
                self.page.keys("space")
            for words, keys in self.ways.items():
                if said.startswith("notification ") and said.endswith(words):
                    self.page.keys(*keys)
                    moves += 1
                    break
        assert moves > 0, "taken without a word"
        assert "in the middle" in said, said
        assert len(self.photographs()) == before + 1, self.photographs()

    def speaks_a_memo(self, voice):
        self.page.await_name("Record a memo")
        self.presses("m")
        self.page.await_name("Finish the memo")
        subprocess.run(["paplay", "--device=mouth", voice], check=True)
        self.presses("m", "notification Recorded: 2 seconds. Saved.")

    def finds_it_in_browse(self):
        self.presses("Escape")  # silence
        self.presses("Escape", "notification TouchPhoto, start page.")
        self.page.keys("1")
        end = time.monotonic() + desk.PATIENCE
        while "; 1 recording." not in (said := self.orca.next(PATIENT_FOR) or ""):
            assert time.monotonic() < end, "Orca never said that the newest photograph is shown, with its recording"
            if said.endswith(" of 3 image."):
                self.page.keys("End")


def inner(program, lab, photos):
    face, *photos = photos
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        album = Album(lab, photos, folder)
        environment = preferences(folder, asked=True, voice="screen_reader", language="en", capture_told=True,
                                  album_folders=[album.folder])
        with beside(program, folder, environment, "--camera", "simulated:" + face) as orca:
            photographer = Photographer(desk.Page(), orca, album)
            photographer.opens_the_camera()
            photographer.is_led_until_it_is_taken()
            photographer.speaks_a_memo(tone(os.path.join(folder, "voice.wav"), 440, 2.0))
            photographer.finds_it_in_browse()


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    sys.exit(journey(__file__, inner))
