#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Orca, the screen reader of the Linux desktop, reads the program aloud: from its first question through the pages, by keys
only. What Orca gives its voice is asserted in order.

orca_reads.py PROGRAM LAB PHOTOS...    ends in 77 where something that it needs is missing
"""
import sys
import tempfile

import desk
from album import Album, preferences
from orca import Listener, beside, journey

SCREEN_READER = "3: No, my screen reader speaks"


class Reader(Listener):
    """A blind person on the way through the pages."""

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
        self.presses("1", "Choose this folder push button", "notification Folder ")
        self.presses("Escape", "notification Question 5 of 5.")
        self.presses("2", "notification TouchPhoto, start page. 1: Listen to photographs. 2: Feel a face.")

    def goes_over_the_start_page(self):
        self.reviews_the_heading("TouchPhoto Help", "TouchPhoto heading")
        self.presses("Tab", "2: Feel a face, ")
        self.presses("Tab", "3: Look after the album, ")

    def changes_settings(self):
        self.presses("shift+Tab", "2: Feel a face, ")
        self.presses("shift+Tab", "1: Listen to photographs, ")
        self.presses("shift+Tab", "Help push button", "Says what you can do here.")
        # The numbers hold in the bar too.
        self.presses("4", "Who speaks: ", "notification Settings. Go through them with Tab")
        self.presses("Tab", "Who speaks: My screen reader speaks", "selected radio button")
        force = self.page.await_name("Strongest force", self.page.atspi.ROLE_SLIDER)
        force.queryComponent().grabFocus()
        self.orca.says("Strongest force slider 1.0", "1.0 newtons")
        self.presses("Right", "1.1", "notification At most 1.1 newtons.")
        self.presses("ctrl+z", "notification Undone: ")
        self.presses("Escape", "notification TouchPhoto, start page.")

    def browses(self):
        self.presses("1", "Anna", "Left and right arrow: other photographs.")
        self.page.await_name("Anna, smiling; no recordings yet. 1 of 2", self.page.atspi.ROLE_IMAGE)
        self.presses("KP_Insert+KP_Enter", "Listen to photographs – TouchPhoto")
        self.presses("Tab", "Play recordings push button")
        self.presses("Right", "notification ")
        self.page.await_name("One person, smiling; no recordings yet. 2 of 2", self.page.atspi.ROLE_IMAGE)
        self.presses("Left", "notification Anna, smiling; no recordings yet.")
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
        self.presses("3", "Import photographs… push button", "notification Look after the album. 2 photographs.")
        self.reviews_the_heading("Photographs of the album", "Photographs of the album heading")
        self.presses("Tab", "Import a folder… push button")
        self.presses("Tab", "People… push button.", "Says once who somebody is, for all photographs.")
        self.presses("Tab", "Order: Newest first", "selected radio button")
        self.presses("Tab", "Order: Check these first", "not selected radio button")
        self.presses("space", "selected")
        self.presses("Escape", "notification TouchPhoto, start page.")


def inner(program, lab, photos):
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        album = Album(lab, photos, folder)
        album.run("person", "name", "--face", "0.5,0.4,0.4,0.5", album.photos[0], "Anna")
        environment = preferences(folder, language="en", album_folders=[album.folder])
        with beside(program, folder, environment) as orca:
            listener = Reader(desk.Page(), orca)
            listener.answers_the_five_questions()
            listener.goes_over_the_start_page()
            listener.changes_settings()
            listener.browses()
            listener.feels_a_face()
            listener.looks_after_the_album()


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(journey(__file__, inner))
