# SPDX-License-Identifier: Apache-2.0
"""What a stranger's files say is shown and read as words: nothing is fetched that they ask for."""
import html
import os
import shutil
import subprocess
import tempfile
import unittest

import desk
import hostile_files
import network_trace
from album import preferences
from every_page import BY_NUMBER, WIDE, Focus, Walker
from hostile_album import HostileAlbum, Listener
from privacy_judge import TRIED, is_whole, judged, run_traced, wait_until

# What a page opens is looked at too.
CALLS = network_trace.CALLS + ",open,openat,openat2"


def written_in(node):
    """What somebody could change or read letter by letter; empty where there is no such thing."""
    try:
        return node.queryText().getText(0, -1)
    except NotImplementedError:
        return ""


class HostileWords(unittest.TestCase):
    """A stranger's names, captions, transcripts and file names on every page."""

    DETAILS = 7  # of a photograph that Browse tells one after the other
    ON_NO_PAGE = {"transcript", "device"}  # searched in; read by a verb

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.listener = self.enterContext(Listener())
        self.album = HostileAlbum(TRIED.lab, TRIED.photo, self.folder, self.listener.port)
        self.focus = Focus()
        self.shown = set()

    def walk(self, pages, *words):
        """Over pages, until each has come to rest; whom the program met and what it opened on the way."""
        environment = preferences(self.folder, asked=True, voice="screen_reader", album_folders=[self.album.album.folder],
                                  last_photo=self.album.photos[0])
        trace = os.path.join(self.folder, "trace")
        command = [TRIED.program, "--size", "x".join(map(str, WIDE)), *words]
        running = subprocess.Popen(network_trace.traced(command, trace, CALLS), env=environment,
                                   cwd=self.album.experiment())
        try:
            walker = Walker(running, desk.Page(), self.focus)
            for page in pages:
                walker.go(page)
                if "camera" in page:
                    walker.awaited("why it gives nothing", lambda: self.note_what_is_shown(walker) or "camera" in self.shown)
                walker.faultless(page)
                for _ in range(self.DETAILS if page == "browse" else 0):
                    self.note_what_is_shown(walker)
                    walker.page.keys("Down")
                self.note_what_is_shown(walker)
                if page == "care":
                    self.meet_the_people(walker)
                if page == "study":
                    self.open_the_experiment(walker)
            self.assertIsNone(running.poll(), "the program has ended")
        finally:
            running.terminate()
            running.wait(20)
        wait_until(lambda: is_whole(trace))
        self.assertEqual(judged(trace).offences, [])
        with open(trace, encoding="utf-8", errors="replace") as file:
            self.assertEqual([line for line in file if "open" in line.split("(")[0] and self.album.bait in line], [])

    def meet_the_people(self, walker):
        """Whoever is on a photograph, by faces: the list, one of them, and the names that are offered for what is typed."""
        name = self.album.words["person"]
        walker.press("People…")
        walker.press(f"{name}, 2 photographs, 1 of 1")
        walker.awaited("the name in its field", lambda: any(written_in(node) == name for node in walker.seen()))
        walker.faultless("a person")
        walker.page.keys("Escape", "Escape")

    def open_the_experiment(self, walker):
        """A stranger's, by Qt's own dialog, which shows the only file of the folder that the program was started in."""
        walker.page.keys("o")
        file = walker.page.await_name("strangers.study").parent
        walker.page.act(file, "setfocus")
        walker.page.keys("Return")
        walker.awaited("the experiment", lambda: any(self.album.words["title"] in node.name for node in walker.seen()))
        walker.faultless("a stranger's experiment")
        self.note_what_is_shown(walker)

    def note_what_is_shown(self, walker):
        for node in walker.seen():
            self.shown |= self.album.kinds_in([node.name, written_in(node)])

    def test_nothing_is_fetched_that_words_ask_for(self):
        broken = os.path.join(self.folder, self.album.words["file"] + ".png")
        with open(broken, "wb") as file:
            file.write(b"no picture")
        for pages, words in ((("mend", "start", *BY_NUMBER), ("--page", "mend")), (("print",), ("--page", "print")),
                             (("what cannot be opened",), (broken,)),
                             (("a camera that cannot be played",), ("--camera", "video:" + self.album.film, "--page", "capture"))):
            with self.subTest(words=words):
                self.walk(pages, *words)
        self.assertEqual(self.listener.callers, [])
        self.assertEqual(self.shown, set(self.album.words) - self.ON_NO_PAGE)


class HostileVerbs(unittest.TestCase):
    """What a stranger's studies say of themselves, read by the verbs."""

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.listener = self.enterContext(Listener())
        self.album = HostileAlbum(TRIED.lab, TRIED.photo, self.folder, self.listener.port)

    def verb(self, *words):
        """Runs a verb, which meets nobody and does not open what it is told to look at."""
        trace = os.path.join(self.folder, "trace")
        environment = dict(preferences(self.folder), XDG_RUNTIME_DIR=self.folder)
        done = run_traced([TRIED.lab, *words], trace, CALLS, env=environment)
        self.assertEqual(done.returncode, 0, f"{words}: {done.stdout}{done.stderr}")
        self.assertEqual(judged(trace).offences, [], words)
        with open(trace, encoding="utf-8", errors="replace") as file:
            calls = file.read()
        self.assertIn("open", calls)
        self.assertNotIn(self.album.bait, calls)
        self.assertEqual(self.listener.callers, [], words)

    def test_a_study_s_page_shows_its_words_as_words(self):
        experiment = os.path.join(self.album.experiment(), "strangers.study")
        study = hostile_files.study(TRIED.lab, experiment, self.album.words["device"], os.path.join(self.folder, "study"))
        report = os.path.join(self.folder, "report")
        for words in (("check", study), ("report", study, "--out", report), ("export", study, "--out", report + ".zip")):
            self.verb("study", *words)
        pages = dict(hostile_files.pages_in(report))
        self.assertGreater(len(pages), 2)
        self.assertTrue(any(self.album.words["title"] in html.unescape(text) for text in pages.values()), "its title is nowhere")
        for name, text in pages.items():
            self.assertNotRegex(text, r"<[^>]*127\.0\.0\.1", name)
