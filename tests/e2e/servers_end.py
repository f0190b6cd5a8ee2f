#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The servers that the program leans on are killed while somebody records: without the speech server it goes on, starts
another and speaks again; without the display it ends, leaves no process behind, and what was recorded is kept.

servers_end.py PROGRAM LAB PHOTO    ends in 77 where something that it needs is missing
"""
import glob
import os
import signal
import subprocess
import sys
import tempfile

import desk
import sound_server
from album import Album, preferences, tone
from names import heard_while

RECORDED_S = 4.0


def display_server():
    """Its process, as it noted itself."""
    with open(f"/tmp/.X{os.environ['DISPLAY'].lstrip(':').split('.')[0]}-lock", encoding="ascii") as file:
        return int(file.read())


def processes_of(group):
    """What runs in a process group, but for those that ended and that nobody has asked about yet."""
    listed = subprocess.run(["ps", "-eo", "pgid=,stat=,args="], capture_output=True, text=True, check=True).stdout
    return [line for line in listed.splitlines() if line.split()[0] == str(group) and not line.split()[1].startswith("Z")]


class Caregiver:
    def __init__(self, program, album, folder):
        self.album, self.folder, self.page, self.listener = album, folder, desk.Page(), desk.Listener()
        environment = preferences(folder, asked=True, language="en", album_folders=[album.folder])
        self.program = subprocess.Popen([program, "--page", "care"], env=environment, start_new_session=True)

    def records(self):
        self.page.press(os.path.basename(self.album.photos[0]) + "…", self.page.atspi.ROLE_LIST_ITEM)
        self.page.press("Record")
        self.page.await_name("Recording …")  # as soon as the microphone is heard

    def is_heard_by_the_microphone(self, seconds):
        subprocess.run(["paplay", "-d", "mouth", tone(os.path.join(self.folder, "memo.wav"), 500, seconds)], check=True)

    def finishes(self):
        self.page.press("Finish the recording")
        self.listener.await_words("Saved.")

    def hears_it_speak(self):
        """The last sentence again."""
        return len(heard_while(self.folder, lambda: self.page.keys("F2"))) / sound_server.RATE


def without_the_speech_server(person, speech):
    print(f"heard {person.hears_it_speak():.1f} s of the voice")
    person.records()
    speech.process.kill()
    speech.process.wait()
    person.is_heard_by_the_microphone(1.0)
    person.finishes()
    assert len(person.album.tags(person.album.photos[0])) == 1
    print(f"heard {person.hears_it_speak():.1f} s of the voice of another speech server")


def without_the_display(person):
    person.records()
    person.is_heard_by_the_microphone(RECORDED_S)
    os.kill(display_server(), signal.SIGKILL)
    status = person.program.wait(timeout=desk.PATIENCE)
    print(f"ended in {status}")
    sound_server.wait_until(lambda: not processes_of(person.program.pid))
    kept(person.album)


def kept(album):
    """What the microphone heard until then is a recording of the photograph when the album has been looked after."""
    photo = album.photos[0]
    if len(album.tags(photo)) == 1:
        assert glob.glob(photo + ".tags/*.part"), "neither a recording nor a part of one"
        album.run("check", "--mend", album.folder)
    durations = sorted(tag["duration_s"] for tag in album.tags(photo))
    print(f"kept {durations} s")
    assert len(durations) == 2 and durations[1] > RECORDED_S - 1.0, durations


def inner(program, lab, photo):
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        server, speech = sound_server.Server(folder), sound_server.Speech()
        person = Caregiver(program, Album(lab, [photo], folder), folder)
        try:
            without_the_speech_server(person, speech)
            without_the_display(person)
        finally:
            if person.program.poll() is None:
                os.killpg(person.program.pid, signal.SIGKILL)
                person.program.wait()
            speech.end()
            subprocess.run(["pkill", "-f", folder])  # the speech server that the program started
            server.end()


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, *sys.argv[1:4]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "pulseaudio", "pactl", "parec", "paplay", "speech-dispatcher", "ps", "pkill", "/proc/self"))
