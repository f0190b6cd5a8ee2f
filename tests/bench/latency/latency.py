#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""How soon the program answers: its first sound and word, the next page, a touch. From outside, on a display, a sound server
and a speech server of its own: what is measured is what leaves the program. It prints; nothing is asserted.

latency.py PROGRAM LAB ROUNDS PHOTO...
"""
import os
import signal
import subprocess
import sys
import tempfile
import time

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "e2e"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import desk
import sound_server
from album import Album, preferences
from screen import Screen
from sound_gate import Gate

SIZE = "1400x950"  # px; room for the window as it comes, with its frame
BAR = 60  # px; the height in which a page's title stands, at its usual size


def row(what, goal, seconds):
    """One line of the table; None among `seconds` is what never came."""
    times = sorted(1000 * each for each in seconds if each is not None)
    missing = len(seconds) - len(times)
    if times:
        print(f"| {what} | {goal} | {np.median(times):.0f} | {np.percentile(times, 95):.0f} | {times[-1]:.0f} | {len(times)} |"
              + (f" {missing} never came" if missing else ""), flush=True)
    else:
        print(f"| {what} | {goal} | never came |", flush=True)


class Bench:
    def __init__(self, program, folder, album, rounds):
        self.program, self.folder, self.album, self.rounds = program, folder, album, rounds
        self.screen = Screen()
        self.gate = Gate(folder, os.path.join(folder, "socket"))
        os.environ["PULSE_SERVER"] = "unix:" + self.gate.path  # of the program and of the speech server

    def started(self, voice, *words, **choices):
        """The program and when it began."""
        environment = preferences(self.folder, asked=True, language="en", voice=voice, guide="none",
                                  album_folders=[self.album.folder], last_photo=self.album.photos[0], **choices)
        environment.setdefault("QT_QUICK_BACKEND", "software")  # no such display has a GPU, and OpenGL without one is slow
        self.gate.listen()
        begin = time.monotonic()
        return begin, subprocess.Popen([self.program, *words], env=environment, stderr=subprocess.DEVNULL)

    @staticmethod
    def end(running):
        running.terminate()
        running.wait(timeout=30)

    # --- the start ---

    def start(self, heading, speech_server):
        earcons, words, windows = [], [], []
        for _ in range(self.rounds):
            speech = sound_server.Speech() if speech_server else None
            self.gate.await_silence()
            before = self.screen.await_rest((0, 0, 400, 200))
            begin, running = self.started("program")
            shown = self.screen.await_change(before, (0, 0, 400, 200))
            windows.append(shown and shown - begin)
            for speaks, list_of in ((False, earcons), (True, words)):
                heard = self.gate.heard(speaks)
                list_of.append(heard and heard - begin)
            self.end(running)
            if speech is not None:
                speech.end()
            else:
                self.end_speech_server()
        row(f"start to the first earcon{heading}", 500, earcons)
        row(f"start to the first word{heading}", 1000, words)
        row(f"start to the window{heading}", "", windows)

    def end_speech_server(self):
        """The one that the program started."""
        file = os.path.join(self.folder, "speech-dispatcher", "pid", "speech-dispatcher.pid")
        try:
            with open(file, encoding="ascii") as number:
                os.kill(int(number.read()), signal.SIGTERM)
        except (FileNotFoundError, ProcessLookupError, ValueError):
            return
        while os.path.exists(file):
            time.sleep(0.05)

    # --- the pages ---

    def window(self):
        """Its place on the screen, once it is drawn."""
        found = subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--name", "TouchPhoto"], check=True,
                               capture_output=True, text=True).stdout.split()[0]
        lines = subprocess.run(["xdotool", "getwindowgeometry", "--shell", found], check=True, capture_output=True,
                               text=True).stdout.split()
        place = {name: int(value) for name, value in (line.split("=") for line in lines)}
        return place["X"], place["Y"], place["WIDTH"], place["HEIGHT"]

    def key_to_page(self, key, title):
        before = self.screen.await_rest(title, 0.5)
        pressed = self.screen.press(key)
        shown = self.screen.await_change(before, title)
        return shown and shown - pressed

    def pages(self):
        keys = {"Browse": "1", "Explore": "2", "Care": "3", "Settings": "4", "Lab": "5"}
        first = {page: [] for page in keys}
        again = {page: [] for page in keys}
        home = []
        for _ in range(max(2, self.rounds // 3)):
            _, running = self.started("off")
            x, y, width, _ = self.window()
            title = (x, y, width // 2, BAR)
            self.screen.await_rest(title, 2.0)
            for times in (first, again, again, again):
                for page, key in keys.items():
                    times[page].append(self.key_to_page(key, title))
                    home.append(self.key_to_page("Alt_L+Home", title))
            self.end(running)
        for page in keys:
            row(f"key to {page}, opened first", 100, first[page])
            row(f"key to {page}, again", 100, again[page])
        row("key to Start", 100, home)

    # --- the finger ---

    def finger(self):
        _, running = self.started("off", "--page", "explore")
        x, y, width, height = self.window()
        self.screen.await_rest((x, y, width, height), 2.0)  # the face is found
        self.gate.await_silence()
        places = self.places_in_the_face(x, y, width, height)
        asleep, awake, drawn = [], [], []
        for turn in range(5 * self.rounds):
            place = places[turn % len(places)]
            self.screen.point(x + 40, y + height - 90)  # beside the face: what is touched next is entered
            self.screen.await_rest((x + 24, y + height - 106, 32, 32), 0.2)
            self.screen.point(x + width // 2, y + 5)  # off the surface
            self.gate.await_silence(6.0 if turn % 5 == 0 else 0.6)  # after 5 s the stream is closed
            around = (place[0] - 16, place[1] - 16, 32, 32)
            before = self.screen.await_rest(around, 0.2)
            self.gate.listen()
            touched = self.screen.point(*place)
            shown = self.screen.await_change(before, around, 2.0)
            heard = self.gate.heard(patience=2.0)
            drawn.append(shown and shown - touched)
            (asleep if turn % 5 == 0 else awake).append(heard and heard - touched)
        self.end(running)
        row("touch to its earcon", 50, awake)
        row("touch to its earcon, after silence of 5 s and more", 50, asleep)
        row("touch to the drawn hand", "", drawn)

    def places_in_the_face(self, x, y, width, height):
        """The middle of the surface, where the face is fitted to; a few places, so that each is another touch."""
        middle = (x + int(0.33 * width), y + int(0.5 * height))
        return [(middle[0] + dx, middle[1] + dy) for dx, dy in ((0, 0), (40, 20), (-40, 30), (20, -40), (-30, -30))]


    # --- the camera ---

    def camera(self):
        """The page's own words begin the moment it opens; the camera comes after them."""
        first, again = [], []
        for _ in range(self.rounds):
            speech = sound_server.Speech()
            _, running = self.started("program", "--camera", "simulated:" + self.album.photos[0], capture_told=True)
            self.gate.heard(True)  # of the start page
            for times in (first, again, again):
                self.gate.await_silence(1.0)
                self.gate.listen()
                pressed = self.screen.press("6")
                heard = self.gate.heard(True)
                times.append(heard and heard - pressed)
                self.screen.press("Alt_L+Home")
                self.gate.await_silence(1.0)
            self.end(running)
            speech.end()
        row("key to the first word of the camera's page, opened first", 1000, first)
        row("key to the first word of the camera's page, again", 1000, again)


def inner(program, lab, rounds, photos):
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        server = sound_server.Server(folder)
        try:
            album = Album(lab, photos, folder)
            album.run("person", "name", "--face", "0.5,0.4,0.4,0.5", album.photos[0], "Anna")
            bench = Bench(program, folder, album, rounds)
            print("| from … to | goal, ms | median | 95 % | longest | times |\n| --- | --: | --: | --: | --: | --: |")
            parts = os.environ.get("TOUCHPHOTO_LATENCY", "start pages finger camera").split()
            if "start" in parts:
                bench.start("", speech_server=True)
                bench.start(", speech server not running", speech_server=False)
            if "pages" in parts:
                bench.pages()
            if "finger" in parts:
                bench.finger()
            if "camera" in parts:
                bench.camera()
            return 0
        finally:
            server.end()


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    sys.exit(inner(sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4:]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "pulseaudio", "pactl", "speech-dispatcher",
                                 size=SIZE, seconds=1800))
