#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A blind person alone with the program: from its start, by keys and a screen reader's actions only, through the questions,
an album of five photographs, its recordings, a face with its tour and zoom, a search and the speed of speech. What the
program says is asserted in order; recordings are heard in what the sound server played.

person.py PROGRAM LAB PHOTOS...    ends in 77 where something that it needs is missing
"""
import os
import subprocess
import sys
import tempfile

import numpy as np

import desk
import sound_server
from album import Album, tone

FIRST_HZ, SECOND_HZ = 660, 880  # of the recordings, so that each is told from the other by its pitch
HEARD_S = 1.5  # of a recording of 2 s; a window at its border counts for neither


def seconds_of(samples, hz, rate=sound_server.RATE):
    """How long a pitch was heard: windows of 50 ms in which it holds most of the energy."""
    width = rate // 20
    count = 0
    for begin in range(0, len(samples) - width, width):
        block = samples[begin : begin + width]
        energy = (block**2).sum()
        if energy < 1e-4:
            continue
        phase = 2 * np.pi * hz * np.arange(width) / rate
        share = 2 * ((block @ np.cos(phase)) ** 2 + (block @ np.sin(phase)) ** 2) / (width * energy)
        count += share > 0.8
    return count / 20


class Person:
    def __init__(self, folder, page, listener):
        self.folder, self.page, self.listener = folder, page, listener

    def hears(self, *sentences):
        self.listener.await_words(*sentences)
        for sentence in sentences:
            print(f"heard: {sentence}")

    def answers_the_five_questions(self):
        self.page.await_name("1: Yes")
        self.page.press("3: No, my screen reader speaks")
        self.hears("Question 2 of 5. How fast should it speak?")
        self.page.keys("4")
        self.hears("Question 3 of 5.")
        self.page.keys("1")
        self.hears("Question 4 of 5. No force device was found.")
        self.page.keys("1")
        self.hears("Question 5 of 5. Where are your photographs?")
        self.page.press("In another folder" if self.page.find("In another folder") else "1: In another folder")
        self.hears("Folder ")
        self.page.press("Family…", self.page.atspi.ROLE_LIST_ITEM)
        self.hears("Folder Family: 5 photographs in this folder itself")
        self.page.press("Choose this folder")
        self.hears("TouchPhoto, start page. 1: Listen to photographs. 2: Feel a face.")

    def browses_and_hears_a_recording(self):
        ear = sound_server.Ear(self.folder, "ear")
        self.page.keys("1")
        self.page.await_name("Anna, smiling; 1 recording. 1 of 5", self.page.atspi.ROLE_IMAGE)  # its focus makes a screen reader read it
        self.page.keys("Down")
        self.hears("Anna")
        self.page.keys("Up", "Return")
        sound_server.wait_until(lambda: seconds_of(ear.so_far(), FIRST_HZ) >= HEARD_S)
        self.page.await_name("Play recordings")  # the recording has ended
        self.page.keys("Right")
        self.hears("; 1 recording.")
        self.page.await_name("One person, smiling; 1 recording. 2 of 5", self.page.atspi.ROLE_IMAGE)  # nobody has named him
        heard = ear.heard()
        first, second = seconds_of(heard, FIRST_HZ), seconds_of(heard, SECOND_HZ)
        print(f"of the first photograph's recording {first:.2f} s were heard, of the second's {second:.2f} s")
        assert first >= HEARD_S, first
        assert second == 0, second
        self.page.keys("Left")
        self.hears("Anna, smiling; 1 recording.")

    def feels_a_face(self):
        self.page.keys("e")
        self.hears("Anna. One face. Eyes, mouth and outline can be felt.")
        for feature in ("left eye", "right eye"):
            self.page.keys("Tab")
            self.hears(feature)
        self.page.keys("w")
        self.hears("Anna. On the right eye, at its ")
        lips = self.page.await_name("lips…", self.page.atspi.ROLE_PUSH_BUTTON)
        place = lips.queryComponent().getExtents(self.page.atspi.DESKTOP_COORDS)
        window = self.page.window()
        found = window.queryComponent().getAccessibleAtPoint(place.x + place.width // 2, place.y + 3,
                                                             self.page.atspi.DESKTOP_COORDS)
        found = self.deepest(found, place.x + place.width // 2, place.y + 3)
        assert found.name == lips.name, f"{found.getRoleName()} \"{found.name}\" lies where the lips are"
        self.page.act(found)
        self.hears("lips")
        print("found by its place: lips")
        for key, sentence in (("z", "Zoomed to the eyes"), ("z", "Zoomed to the mouth"),
                              ("shift+z", "Zoomed out to the whole face")):
            self.page.keys(key)
            self.hears(sentence)
        self.page.keys("space")
        self.hears("Tour round the ", "Tour finished.")
        self.page.keys("Escape")
        self.hears("Stopped.")
        self.page.keys("Escape")
        self.hears("TouchPhoto, start page.")

    def deepest(self, node, x, y):
        while True:
            below = node.queryComponent().getAccessibleAtPoint(x, y, self.page.atspi.DESKTOP_COORDS)
            if below is None or below == node:
                return node
            node = below

    def searches_a_name(self):
        self.page.keys("1")
        self.hears("Your photographs.")
        self.page.keys("s")
        self.hears("Search. Type a name")
        self.page.type("clar")
        self.page.await_name("One person; no recordings yet., clara_sad.jpg, …")  # which is first, is told by what was seen so far
        self.page.keys("Return")
        self.hears("2 photographs")
        self.page.keys("Down", "Return")
        self.hears("Found: clar, ")

    def changes_the_speed_of_speech(self):
        self.page.press("Home")
        self.hears("TouchPhoto, start page.")
        self.page.press("4: Settings…", self.page.atspi.ROLE_LIST_ITEM)
        self.hears("Settings. Go through them with Tab")
        self.page.press("Speed of speech: Slow")
        self.hears("Slow. This is how fast I speak.")
        self.page.keys("ctrl+z")
        self.hears("Undone: the speed of speech.")
        self.page.keys("Escape")
        self.hears("TouchPhoto, start page.")

def inner(program, lab, photos):
    with tempfile.TemporaryDirectory() as folder, desk.Desk(), sound_server.Server(folder):
        album = Album(lab, photos, folder)
        album.run("tag", "add", "--from", tone(os.path.join(folder, "1.wav"), FIRST_HZ, 2.0), "--kind", "memo", album.photos[0])
        album.run("tag", "add", "--from", tone(os.path.join(folder, "2.wav"), SECOND_HZ, 2.0), "--kind", "story", album.photos[1])
        album.run("person", "name", "--face", "0.5,0.4,0.4,0.5", album.photos[0], "Anna")
        environment = dict(os.environ, XDG_CONFIG_HOME=folder + "/config", XDG_CACHE_HOME=folder + "/cache", HOME=folder)
        subprocess.run(["xdotool", "mousemove", "0", "0"], check=True)  # nobody holds it; on the face it would say what it lies on
        listener = desk.Listener()
        with desk.started([program], env=environment):
            person = Person(folder, desk.Page(), listener)
            person.answers_the_five_questions()
            person.browses_and_hears_a_recording()
            person.feels_a_face()
            person.searches_a_name()
            person.changes_the_speed_of_speech()


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, sys.argv[1], sys.argv[2], sys.argv[3:]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "pulseaudio", "pactl", "parec", opengl=True))
