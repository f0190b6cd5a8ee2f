#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Orca, the screen reader of the Linux desktop, reads the program aloud: from its first question through the pages, by keys
only. What Orca gives its voice is asserted in order, from its own debug file.

orca_reads.py PROGRAM LAB PHOTOS...    ends in 77 where something that it needs is missing
"""
import os
import queue
import re
import subprocess
import sys
import tempfile
import threading
import time
import tty

import desk
import sound_server
from album import Album, preferences

SPEECH = re.compile(r"^[0-9:.]+ - SPEECH OUTPUT: '(.*?)'(?: voice=\w+)? ?(?:[\[{].*)?$")
SCREEN_READER = "3: No, my screen reader speaks"


class Orca:
    """Orca and what it says, with settings of its own below `folder`. Its debug file is a terminal, because what it writes to
    others is kept back until there is much of it."""

    def __init__(self, folder):
        self.terminal, self.orcas_end = os.openpty()
        tty.setraw(self.orcas_end)
        environment = dict(os.environ, HOME=folder, XDG_DATA_HOME=os.path.join(folder, "data"))
        self.process = subprocess.Popen(["orca", "--debug-file", os.ttyname(self.orcas_end)], env=environment)
        self.spoken = queue.SimpleQueue()
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        for line in os.fdopen(self.terminal, errors="replace"):
            if said := SPEECH.match(line):
                self.spoken.put(said[1])

    def says(self, *sentences):
        """All of these were said after what was awaited before; others may come between. What is matched is the beginning
        of each."""
        awaited, since = list(sentences), []
        end = time.monotonic() + desk.PATIENCE
        while awaited:
            try:
                since.append(self.spoken.get(timeout=max(0, end - time.monotonic())))
            except queue.Empty:
                raise AssertionError(f"Orca never said \"{awaited[0]}\"; it said since: {since}") from None
            print(f"Orca: {since[-1]}", flush=True)
            awaited = [sentence for sentence in awaited if not since[-1].startswith(sentence)]

    def end(self):
        self.process.kill()  # a goodbye would wait for its voice
        self.process.wait()


class Listener:
    """A blind person who hears Orca."""

    def __init__(self, page, orca):
        self.page, self.orca = page, orca

    def presses(self, key, *said):
        self.page.keys(key)
        self.orca.says(*said)

    def reviews_the_heading(self, line, heading):
        """Orca's own way over the window, from the first control to the line above it."""
        self.presses("KP_Home", line)
        self.presses("KP_Insert+KP_Begin", heading)

    def answers_the_five_questions(self):
        self.orca.says("1: Yes push button")
        self.presses("Tab", "2: No, the words on the screen are enough push button")
        self.presses("Tab", SCREEN_READER + " push button")
        self.presses("3", "notification Question 2 of 5. How fast should it speak?")
        self.presses("3", "notification Question 3 of 5.")
        self.presses("1", "notification Question 4 of 5. No force device was found.")
        self.presses("1", "notification Question 5 of 5. Where are your photographs?")
        self.presses("1", "Take this folder push button", "notification Folder ")
        self.presses("Escape", "notification Question 5 of 5.")
        self.presses("2", "notification TouchPhoto, start page. 1: Listen to photographs. 2: Feel a face.")

    def goes_over_the_start_page(self):
        self.reviews_the_heading("TouchPhoto Help", "TouchPhoto heading")
        self.presses("Tab", "2: Feel a face, ")
        self.presses("Tab", "3: Look after the album, ")

    def changes_settings(self):
        self.presses("shift+Tab", "2: Feel a face, ")
        self.presses("shift+Tab", "1: Listen to photographs, ")
        self.presses("shift+Tab", "Help push button", "Says what can be done here.")
        # The numbers hold in the bar too.
        self.presses("4", "Who speaks: ", "notification Settings. Go through them by Tab")
        self.presses("Tab", "Who speaks: My screen reader speaks", "selected radio button")
        force = self.page.await_name("Strongest force", self.page.atspi.ROLE_SLIDER)
        force.queryComponent().grabFocus()
        self.orca.says("Strongest force slider 1.0", "1.0 newtons")
        self.presses("Right", "1.1", "notification At most 1.1 newtons.")
        self.presses("ctrl+z", "notification Undone: ")
        self.presses("Escape", "notification TouchPhoto, start page.")

    def browses(self):
        self.presses("1", "Anna; no recordings yet. 1 of 2 image", "Left and right arrow: other photographs.")
        self.presses("KP_Insert+KP_Enter", "Listen to photographs – TouchPhoto")
        self.presses("Tab", "Play recordings push button")
        self.presses("Right", "notification ben_smiling.jpg; no recordings yet.")
        self.presses("Left", "notification Anna; no recordings yet.")
        self.presses("s", "A name, a place or any word text", "notification Search. Type a name")
        self.presses("Escape", "notification TouchPhoto, start page.")

    def feels_a_face(self):
        self.presses("2", "Touch surface canvas", "notification Anna. One face. Eyes, mouth and outline can be felt.")
        self.presses("KP_Insert+KP_Enter", "Feel a face – TouchPhoto")
        self.presses("Tab", "notification left eye of Anna.")
        self.presses("w", "notification Anna. On the left eye, at its ")
        self.presses("space", "notification Tour finished.")
        self.presses("Escape", "notification Stopped.")
        self.presses("Escape", "notification TouchPhoto, start page.")

    def looks_after_the_album(self):
        self.presses("3", "Import photographs… push button", "notification Care for the album. 2 photographs.")
        self.reviews_the_heading("Photographs of the album", "Photographs of the album heading")
        self.presses("Tab", "Import a folder… push button")
        self.presses("Tab", "Order: Newest first", "selected radio button")
        self.presses("Tab", "Order: Check these first", "not selected radio button")
        self.presses("space", "selected")
        self.presses("Escape", "notification TouchPhoto, start page.")


def inner(program, lab, photos):
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        server = sound_server.Server(folder)
        speech = sound_server.Speech()
        album = Album(lab, photos, folder)
        album.run("person", "name", "--face", "0.5,0.4,0.4,0.5", album.photos[0], "Anna")
        environment = preferences(folder, language="en", album_folders=[album.folder])
        environment["QT_QUICK_BACKEND"] = "software"  # where no GPU is, OpenGL keeps Orca's questions waiting for pictures
        orca = Orca(folder)
        running = None
        try:
            orca.says("Screen reader on.")
            running = subprocess.Popen([program], env=environment)
            listener = Listener(desk.Page(), orca)
            listener.answers_the_five_questions()
            listener.goes_over_the_start_page()
            listener.changes_settings()
            listener.browses()
            listener.feels_a_face()
            listener.looks_after_the_album()
            assert running.poll() is None, "the program has ended"
        finally:
            if running is not None:
                running.terminate()
                running.wait(timeout=20)
            orca.end()
            speech.end()
            server.end()


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, sys.argv[1], sys.argv[2], sys.argv[3:]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "pulseaudio", "pactl", "speech-dispatcher", "orca"))
