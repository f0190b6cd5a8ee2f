#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A caregiver at the program, by keys and a screen reader's actions only: imports a folder, names two people, records a memo
through the microphone, trims it, deletes it and takes that back, mends a contour, and stores a tactile sheet. What the
program says is asserted in order, and what it left on the disk by other programs.

caregiver.py PROGRAM LAB PHOTO PHOTO    ends in 77 where something that it needs is missing
"""
import glob
import os
import subprocess
import sys
import tempfile
import time

import desk
import sound_server
from album import Album, preferences, tone


class Caregiver:
    def __init__(self, folder, album, page, listener):
        self.folder, self.album, self.page, self.listener = folder, album, page, listener

    def hears(self, *sentences):
        self.listener.await_words(*sentences)
        for sentence in sentences:
            print(f"heard: {sentence}")

    def imports_a_folder(self):
        self.hears("TouchPhoto, start page. 1: Look after the album.")
        self.page.keys("1")
        self.hears("Care for the album.")
        for _ in range(8): self.listener.listen(0.5)
        print(self.listener.heard)
        for n in self.page.shown():
            if n.name: print(n.getRoleName(), "|", n.name)


def inner(program, lab, photos):
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        server = sound_server.Server(folder)
        album = Album(lab, photos, folder)
        os.mkdir(os.path.join(folder, "Pictures"))
        environment = preferences(folder, asked=True, user="caregiver", voice="screen_reader", language="en",
                                  album_folders=[album.folder])
        listener = desk.Listener()
        running = subprocess.Popen([program], env=environment)
        try:
            caregiver = Caregiver(folder, album, desk.Page(), listener)
            caregiver.imports_a_folder()
            assert running.poll() is None, "the program has ended"
            print("PASS")
            return 0
        except AssertionError as fault:
            print(f"FAIL: {fault}")
            return 1
        finally:
            running.terminate()
            running.wait(timeout=20)
            server.end()


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    sys.exit(inner(sys.argv[1], sys.argv[2], sys.argv[3:]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "pulseaudio", "pactl", "parec"))
