#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The pages, the camera and the verbs of an album under strace: they talk to this machine's sound, speech, display and accessibility
servers and to nobody else, and what they write of a family only its owner may read.

privacy.py PROGRAM LAB PHOTO [TEST...]    ends in 77 where something that it needs is missing
"""
import contextlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import wave

import desk
import network_trace
from privacy_camera import Camera  # unittest finds it here
from privacy_judge import TRIED, Judge, files_below, is_whole, judged, open_to_others, run_traced, wait_until
from privacy_words import HostileVerbs, HostileWords


@contextlib.contextmanager
def desk_with_sound():
    """One for all: a client of accessibility does not find its way to a second one."""
    import sound_server

    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder, contextlib.ExitStack() as ends:
        os.mkdir(os.path.join(folder, "sound-server"), 0o700)
        ends.callback(sound_server.Server(os.path.join(folder, "sound-server")).end)
        with desk.Desk():
            yield


class Album(unittest.TestCase):
    """An afternoon with the verbs, with a umask that keeps nothing from anybody."""

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder, True)
        for name in ("album", "card", "cache", "home", "session"):
            os.mkdir(self.path(name), 0o700)
        shutil.copy(TRIED.photo, self.path("card/IMG_1.JPG"))
        with open(TRIED.photo, "rb") as one, open(self.path("card/IMG_2.JPG"), "wb") as other:
            other.write(one.read() + b"\0")
        self.tone("card/IMG_1.WAV")
        subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-f", "lavfi", "-i", "sine=duration=1", "-c:a", "aac",
                        self.path("card/IMG_2.MOV")], check=True)
        self.tone("memo.wav")
        self.traces = 0

    def path(self, name):
        return os.path.join(self.folder, name)

    def tone(self, name):
        with wave.open(self.path(name), "wb") as file:
            file.setnchannels(1)
            file.setsampwidth(2)
            file.setframerate(8000)
            file.writeframes(b"".join(int(8000 * (i // 10 % 2) - 4000).to_bytes(2, "little", signed=True)
                                      for i in range(8000)))

    def album(self, *words):
        """The verb's stdout; nothing of it went to the network, and no file was made that others may read."""
        self.traces += 1
        trace = self.path(f"trace{self.traces}")
        # without a session's folder Qt would ask the C library, and that the machine's name service, who sits here
        environment = dict(os.environ, HOME=self.path("home"), XDG_CACHE_HOME=self.path("cache"),
                           XDG_RUNTIME_DIR=self.path("session"))
        done = run_traced([TRIED.lab, "album", *words], trace, network_trace.CALLS, env=environment,
                          preexec_fn=lambda: os.umask(0))
        self.assertEqual(done.returncode, 0, f"album {' '.join(words)}: {done.stdout}{done.stderr}")
        found = judged(trace)
        self.assertEqual(found.offences, [], f"album {' '.join(words)}")
        self.assertEqual(sum(found.servers.values()), 0, f"album {words[0]} needs no server at all: {found.servers}")
        self.assertGreaterEqual(found.ended, 1, "strace saw nothing")
        return done.stdout

    def test_the_verbs_reach_nobody_and_what_they_write_is_the_owner_s(self):
        album, photo = self.path("album"), self.path("album/Mai/IMG_1.JPG")
        lines = self.album("import", album, self.path("card"), "--into", "Mai", "--json").splitlines()
        self.assertEqual([json.loads(line)["sound"]["source"] for line in lines], ["sound_file", "live_photo"])
        self.album("tag", "add", photo, "--from", self.path("memo.wav"), "--person", "Anna", "--transcript", "Anna by the lake")
        self.album("tag", "add", photo, "--from", self.path("memo.wav"), "--kind", "place")
        self.album("scan", album, "--json")
        found = self.album("search", album, "lake", "--json")
        self.assertEqual([os.path.basename(json.loads(line)["photo"]) for line in found.splitlines()], ["IMG_1.JPG"])
        self.album("list", album)
        self.album("show", photo, "--json")
        first = json.loads(self.album("tag", "list", photo, "--json").splitlines()[0])["file"]
        self.album("tag", "delete", photo, first)
        self.album("trash", "list", album)
        self.album("person", "list", album)
        self.album("person", "record", album, "Anna", "--from", self.path("memo.wav"))
        self.album("export", album, "--to", self.path("family.touchphoto"))
        self.album("import", album, self.path("family.touchphoto"), "--into", "again")
        self.album("rebuild", album)
        self.assertEqual(json.loads(self.album("check", album, "--json"))["findings"], [])

        cache, own = list(files_below(self.path("cache"))), list(files_below(os.path.join(album, ".touchphoto")))
        recordings = [path for path in files_below(album) if ".tags" in path or path.endswith(".flac")]
        self.assertTrue(any(os.path.isfile(path) and os.path.getsize(path) > 4096 for path in cache), "no index")
        self.assertGreaterEqual(sum(path.endswith(".flac") for path in recordings), 4)
        self.assertTrue(any(path.endswith("people/Anna.flac") for path in recordings), recordings)
        self.assertTrue(any("/trash/" in path for path in own), own)
        for path in cache + own + recordings + [self.path("family.touchphoto")]:
            self.assertEqual(open_to_others(path), 0, f"others may read {path}")
        print(f"looked at: {len(cache)} files and folders of the index, {len(own)} of .touchphoto, "
              f"{len(recordings)} of recordings")


class Page(unittest.TestCase):
    """The page with its voice on, operated by an accessibility client."""

    def explore(self, page):
        page.await_name("left eye", page.atspi.ROLE_PUSH_BUTTON)
        page.press("left eye")
        page.await_name("Under the finger: left eye")
        page.press("Guided tour")
        page.await_name(desk.SAID + "Tour finished.")
        page.press("Where am I?")
        page.await_name(desk.SAID + "The face. On the left eye, at its …")
        page.press("Stop")
        page.press("Force on")

    def test_it_talks_to_local_servers_only(self):
        import sound_server

        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder, True)
        speech = sound_server.Speech()  # before the program, which would start one as a child
        self.addCleanup(speech.end)
        trace = os.path.join(folder, "trace")
        program = subprocess.Popen(network_trace.traced([TRIED.program, "--voice", "on", TRIED.photo], trace))
        try:
            self.explore(desk.Page())
            self.assertIsNone(program.poll(), "the program has ended")
        finally:
            program.terminate()
            program.wait(20)
        wait_until(lambda: is_whole(trace))
        found = judged(trace)
        self.assertEqual(found.offences, [])
        for server in ("display", "session bus", "accessibility"):
            self.assertGreater(found.servers[server], 0, f"it never met the {server}: is this the whole trace?")
        print(f"met in {found.lines} lines of trace: " + ", ".join(sorted(found.servers)))


def outer():
    reason = network_trace.can_trace()
    if reason:
        print(f"SKIP: {reason}")
        return 77
    os.environ.pop("SESSION_MANAGER", None)
    return desk.at_a_desk(__file__, "ffmpeg", "pulseaudio", "pactl", "speech-dispatcher", "/proc/self", seconds=580, opengl=True)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    if not desk.is_at_a_desk():
        sys.exit(outer())
    TRIED.program, TRIED.lab, TRIED.photo = sys.argv[1:4]
    with desk_with_sound():
        unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
