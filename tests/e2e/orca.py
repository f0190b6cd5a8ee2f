# SPDX-License-Identifier: Apache-2.0
"""Orca, the screen reader of the Linux desktop, and a person who hears it. What it gives its voice comes from its own debug
file."""
import contextlib
import os
import queue
import re
import subprocess
import sys
import threading
import time
import tty

import desk
import sound_server

SPEECH = re.compile(r"^[0-9:.]+ - SPEECH OUTPUT: '(.*?)'(?: voice=\w+)? ?(?:[\[{].*)?$")
KEY_OF = re.compile(r"^\S+( \S+)? $")  # its echo of a key
ROLES = re.compile(r"^notification |( (push button|text|heading))?\.?$")
REST = 0.5  # s without a word


class Orca:
    """Orca and what it says, with settings of its own below `folder`. Its debug file is a terminal, because what it writes to
    others is kept back until there is much of it."""

    def __init__(self, folder):
        self.terminal, self.orcas_end = os.openpty()
        tty.setraw(self.orcas_end)
        environment = dict(os.environ, HOME=folder, XDG_DATA_HOME=os.path.join(folder, "data"))
        self.process = subprocess.Popen(["orca", "--debug-file", os.ttyname(self.orcas_end)], env=environment)
        self.spoken = queue.SimpleQueue()
        self.spoken_so_far = []  # since it was asked last whether it said anything twice
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        for line in os.fdopen(self.terminal, errors="replace"):
            if said := SPEECH.match(line):
                self.spoken.put(said[1])

    def next(self, seconds):
        """What it says next; None: nothing for so long."""
        try:
            self.spoken_so_far.append(self.spoken.get(timeout=max(0, seconds)))
        except queue.Empty:
            return None
        print(f"Orca: {self.spoken_so_far[-1]}", flush=True)
        return self.spoken_so_far[-1]

    def says(self, *sentences):
        """All of these were said after what was awaited before; others may come between. What is matched is the beginning
        of each."""
        awaited, since = list(sentences), []
        end = time.monotonic() + desk.PATIENCE
        while awaited:
            said = self.next(end - time.monotonic())
            assert said is not None, f"Orca never said \"{awaited[0]}\"; it said since: {since}"
            since.append(said)
            awaited = [sentence for sentence in awaited if not said.startswith(sentence)]

    def says_nothing_twice(self):
        """Of all that it has said since it was asked this last, until it is silent for a moment."""
        while self.next(REST) is not None:
            pass
        said = [ROLES.sub("", words) for words in self.spoken_so_far if not KEY_OF.match(words)]
        self.spoken_so_far = []
        for i, words in enumerate(said):
            again = [others for others in said[:i] + said[i + 1:] if words in others]
            assert not again, f"Orca says \"{words}\" twice: {said}"

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

    def presses_once(self, key, *said):
        """The same, and nothing is said twice."""
        self.orca.says_nothing_twice()
        self.presses(key, *said)
        self.orca.says_nothing_twice()

    def types(self, text):
        self.page.type(text)


@contextlib.contextmanager
def beside(program, folder, environment, *options):
    """Orca and then the program, with sound and speech of their own; both still run at the end."""
    with contextlib.ExitStack() as desk_of_both:
        for helper in (sound_server.Server(folder), sound_server.Speech()):
            desk_of_both.callback(helper.end)
        orca = Orca(folder)
        desk_of_both.callback(orca.end)
        orca.says("Screen reader on.")
        running = subprocess.Popen([program, *options], env=os.environ | environment)
        desk_of_both.callback(running.wait, timeout=20)
        desk_of_both.callback(running.terminate)
        yield orca
        assert running.poll() is None, "the program has ended"


def journey(script, inner):
    """The exit status of a journey with Orca: PROGRAM LAB PHOTOS... on the command line."""
    if desk.is_at_a_desk():
        return desk.verdict(inner, sys.argv[1], sys.argv[2], sys.argv[3:])
    return desk.at_a_desk(script, "xdotool", "pulseaudio", "pactl", "speech-dispatcher", "orca", "/dev/pts/ptmx")
