#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A blind caregiver says with Orca who the people of an album are, by keys only: hears the groups, takes a wrong face out, names
somebody, and takes that back. What Orca gives its voice is asserted in order, and that it says nothing twice.

orca_people.py PROGRAM LAB PHOTOS...    ends in 77 where something that it needs is missing
PHOTOS: Ben is on three of them, ben_angry.jpg the newest and ben_and_clara.jpg the next; somebody else on two.
"""
import sys
import tempfile

import desk
from album import Album, preferences
from orca import Listener, beside, journey

ONE, OTHER = "Who is this?, 3 photographs, ", "Who is this?, 2 photographs, "


class Caregiver(Listener):
    def opens_the_people(self):
        self.orca.says("notification TouchPhoto, start page. 1: Look after the album.")
        self.presses_once("1", "notification Look after the album. 5 photographs.")
        self.presses_once("Tab", "Import a folder… push button")
        self.presses_once("Tab", "People… push button", "Says once who somebody is, for all photographs.")
        self.presses_once("Return", "Back to the photographs push button", "notification ")
        for row in (ONE, OTHER):  # the program looks in its own time
            self.page.await_name(row + "…", self.page.atspi.ROLE_LIST_ITEM, 3 * desk.PATIENCE)
        self.page.await_name("2 people without a name. 1 face on one photograph only.")
        self.presses_once("Escape", "ben_angry.jpg, ")
        self.presses_once("shift+Tab", "Order: Check these first")
        self.presses_once("shift+Tab", "Order: Newest first")
        self.presses_once("shift+Tab", "People… push button")
        self.presses_once("Return", "Back to the photographs push button",
                          "notification 2 people without a name. 1 face on one photograph only.")
        self.presses_once("F1", "notification Look after the album. Each row is a person.")

    def hears_the_groups(self):
        self.presses_once("Tab", ONE + "1 of 2")
        self.presses_once("Down", OTHER + "2 of 2")
        self.presses_once("Up", ONE + "1 of 2")
        self.presses_once("Return", "Name text", "notification Who is this? 3 photographs.")
        self.presses_once("shift+Tab", "Back to the people push button")
        self.presses_once("Tab", "Name text")

    def takes_a_face_out_and_back(self):
        self.presses_once("Tab", "ben_angry.jpg, ")
        self.presses_once("Down", "ben_and_clara.jpg, ")
        self.presses_once("Return", "notification Selected: ben_and_clara.jpg.")
        self.presses_once("shift+Tab", "Open the photograph push button")
        self.presses_once("shift+Tab", "Not this person push button", "For the face that was chosen below.")
        self.presses_once("Return", "notification This face is somebody else's.", "ben_smiling.jpg, ")
        self.presses_once("ctrl+z", "notification Undone: a face was taken out of its group.")
        self.page.await_name("ben_and_clara.jpg, …", self.page.atspi.ROLE_LIST_ITEM)
        self.orca.says_nothing_twice()

    def names_somebody_and_takes_it_back(self):
        self.presses_once("Escape", ONE + "1 of 2")
        self.presses_once("Return", "Name text", "notification Who is this? 3 photographs.")
        self.types("Ben")
        self.orca.says("B", "e", "n")
        self.presses_once("Return", "notification Saved: Ben, on 3 photographs. Who is the next? 2 photographs.")
        self.presses_once("Escape", OTHER + "2 of 2")
        self.presses_once("Up", "Ben, 3 photographs, 1 of 2")
        self.presses_once("ctrl+z", "notification Undone: 3 faces were named Ben.")
        self.page.await_name(ONE + "1 of 2", self.page.atspi.ROLE_LIST_ITEM)
        self.presses_once("Escape", "ben_angry.jpg, ")
        self.presses_once("Escape", "notification TouchPhoto, start page.")


def inner(program, lab, photos):
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        album = Album(lab, photos, folder)
        environment = preferences(folder, asked=True, user="caregiver", voice="screen_reader", language="en",
                                  album_folders=[album.folder])
        with beside(program, folder, environment) as orca:
            caregiver = Caregiver(desk.Page(), orca)
            caregiver.opens_the_people()
            caregiver.hears_the_groups()
            caregiver.takes_a_face_out_and_back()
            caregiver.names_somebody_and_takes_it_back()


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(journey(__file__, inner))
