#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A caregiver at the program, by keys and a screen reader's actions only: imports a folder, names two people, records a memo
through the microphone, trims it, deletes it and takes that back, mends a contour, and stores a tactile sheet. What the
program says is asserted in order, and what it left on the disk by other programs.

caregiver.py PROGRAM LAB PHOTO...    ends in 77 where something that it needs is missing
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
        self.page.await_name(desk.SAID + "TouchPhoto, start page. 1: Look after the album.…")
        self.page.keys("1")
        self.hears("Look after the album.")
        self.page.press("Import a folder…")
        self.hears("Folder ")
        self.page.press("Card…", self.page.atspi.ROLE_LIST_ITEM)
        self.hears("Folder Card: 2 photographs in this folder itself")
        self.page.press("Choose this folder")
        self.hears("2 photographs imported.")

    def names_two_people(self):
        self.page.press("ben_and_clara.jpg…", self.page.atspi.ROLE_LIST_ITEM)
        self.page.press("Face without a name…", self.page.atspi.ROLE_LIST_ITEM)
        self.hears("Face without a name, 1 of 2. Type a name or choose one below.")
        self.type_a_name("Ben")
        self.hears("Saved: Ben. Who is the next face?")
        self.type_a_name("Clara")
        self.hears("Saved: Clara.")

    def type_a_name(self, name):
        field = self.page.await_name("Who is face …", self.page.atspi.ROLE_TEXT)
        field.queryComponent().grabFocus()
        self.page.type(name)
        self.page.keys("Return")

    def records_a_memo(self):
        self.page.press("Record")
        self.page.await_name("Recording …")  # as soon as the microphone is heard
        sound = tone(os.path.join(self.folder, "memo.wav"), 500, 3.0)
        subprocess.run(["paplay", "-d", "mouth", sound], check=True)
        self.page.press("Finish the recording")
        self.hears("Saved.")
        tags = self.album.tags(self.photo)
        assert len(tags) == 1 and tags[0]["duration_s"] >= 3.0, tags

    def trims_it(self):
        before = self.album.tags(self.photo)[0]["duration_s"]
        self.page.press("Memo…", self.page.atspi.ROLE_LIST_ITEM)
        end = self.page.await_name("End of the part to keep…", self.page.atspi.ROLE_SLIDER)
        end.queryComponent().grabFocus()
        self.page.keys("shift+Left")
        self.page.press("Trim to this part")
        self.hears("Trimmed: ")
        after = self.album.tags(self.photo)[0]["duration_s"]
        print(f"trimmed from {before:.2f} to {after:.2f} s")
        assert abs(before - after - 1.0) < 0.05, (before, after)

    def deletes_it_and_takes_that_back(self):
        self.page.press("Delete the recording")
        self.hears("Deleted: ")
        assert self.album.tags(self.photo) == []
        self.page.press("Undo: …")
        self.hears("Undone: ")
        assert len(self.album.tags(self.photo)) == 1

    def mends_a_contour(self):
        self.page.press("Mend contours…")
        self.hears("ben_and_clara.jpg")
        self.page.await_name("Mend contours", self.page.atspi.ROLE_HEADING)
        self.page.await_name("Undo…")
        self.listener.listen(3)
        self.page.keys("Tab", "Right", "Right")
        self.hears(" across, ")
        self.page.keys("alt+Left")
        contours = self.photo + ".contours.svg"
        end = time.monotonic() + desk.PATIENCE
        while not os.path.exists(contours) and time.monotonic() < end:
            time.sleep(0.1)
        assert os.path.exists(contours), "no contours were written"

    def prints_a_sheet(self):
        self.page.press("Print a tactile sheet…")
        self.hears("Print ben_and_clara.jpg on 210 by 297 millimetres.")
        self.page.press("Save as PDF")
        self.hears("The sheet is saved as ")
        sheets = glob.glob(os.path.join(self.folder, "Documents", "TouchPhoto", "*.pdf"))
        assert len(sheets) == 1, sheets
        page = subprocess.run(["pdfinfo", sheets[0]], capture_output=True, text=True, check=True).stdout
        assert "A4" in page, page

    @property
    def photo(self):
        return self.album.photo("ben_and_clara.jpg")


def inner(program, lab, photos):
    with tempfile.TemporaryDirectory() as folder, desk.Desk(), sound_server.Server(folder):
        album = Album(lab, [], folder)
        Album(lab, photos, folder, "Card")
        os.mkdir(os.path.join(folder, "Documents"))
        environment = preferences(folder, asked=True, user="caregiver", voice="screen_reader", language="en",
                                  album_folders=[album.folder])
        listener = desk.Listener()
        with desk.started([program], env=environment):
            caregiver = Caregiver(folder, album, desk.Page(), listener)
            caregiver.imports_a_folder()
            caregiver.names_two_people()
            caregiver.records_a_memo()
            caregiver.trims_it()
            caregiver.deletes_it_and_takes_that_back()
            caregiver.mends_a_contour()
            caregiver.prints_a_sheet()


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, sys.argv[1], sys.argv[2], sys.argv[3:]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "pulseaudio", "pactl", "paplay", "pdfinfo"))
