#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The pages, the camera and the verbs of an album under strace: they talk to this machine's sound, speech, display and accessibility
servers and to nobody else, and what they write of a family only its owner may read.

privacy.py PROGRAM LAB PHOTO [TEST...]    ends in 77 where something that it needs is missing
"""
import html
import json
import os
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import time
import unittest
import wave

import desk
import hostile_files
import network_trace
from album import Album as FamilyAlbum
from album import preferences
from every_page import BY_NUMBER, WIDE, Focus, Walker
from hostile_album import HostileAlbum, Listener

# What each local server's socket is called. "@" begins an abstract name.
SERVERS = {
    "display": r"@?/tmp/\.X11-unix/X\d+|.*/wayland-\d+",
    "session bus": r"@?/tmp/dbus-\w+|/run/user/\d+/bus",
    "accessibility": r".*/at-spi/bus[_\d]*|.*/at-spi2-\w+/socket",
    "sound": r".*/pulse/native|.*/sound-server/socket|.*/pipewire-\d+",
    "speech": r".*/speech-dispatcher/speechd\.sock",
    # The C library's own, where that is installed: Mesa asks it for the home of who sits here, to keep shaders in.
    "user names": r"/var/run/nscd/socket",
}


def judged(trace):
    with open(trace, encoding="utf-8", errors="replace") as file:
        return network_trace.judged(file.read(), SERVERS)


def setUpModule():
    """A desk with a sound server, one for all: a client of accessibility does not find its way to a second one."""
    import sound_server

    folder = tempfile.mkdtemp()
    unittest.addModuleCleanup(shutil.rmtree, folder, True)
    os.mkdir(os.path.join(folder, "sound-server"), 0o700)
    unittest.addModuleCleanup(sound_server.Server(os.path.join(folder, "sound-server")).end)
    unittest.enterModuleContext(desk.Desk())


class Judge(unittest.TestCase):
    """The judge can say no."""

    ALLOWED = """\
11 socket(AF_UNIX, SOCK_STREAM|SOCK_CLOEXEC, 0) = 3
11 connect(3, {sa_family=AF_UNIX, sun_path=@"/tmp/.X11-unix/X99"}, 20) = 0
11 connect(3, {sa_family=AF_UNIX, sun_path="/run/user/1000/pulse/native"}, 110 <unfinished ...>
12 socketpair(AF_UNIX, SOCK_STREAM|SOCK_CLOEXEC, 0, [4, 5]) = 0
11 <... connect resumed>) = 0
11 sendmsg(3, {msg_name=NULL, msg_namelen=0, msg_iov=[{iov_base="x", iov_len=1}], msg_iovlen=1}, MSG_NOSIGNAL) = 1
11 getpeername(3, {sa_family=AF_UNIX, sun_path=@"/tmp/.X11-unix/X99"}, [124 => 20]) = 0
11 socket(AF_NETLINK, SOCK_RAW|SOCK_CLOEXEC|SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT) = 7
11 bind(7, {sa_family=AF_NETLINK, nl_pid=0, nl_groups=0x000002}, 12) = 0
11 --- SIGTERM {si_signo=SIGTERM} ---
12 ???( <unfinished ...>
12 <... ??? resumed>) = ?
12 +++ exited with 0 +++
11 +++ killed by SIGTERM +++
"""
    REFUSED = (
        '11 socket(AF_INET, SOCK_DGRAM|SOCK_CLOEXEC, IPPROTO_IP) = 3',
        '11 socket(AF_INET6, SOCK_STREAM, IPPROTO_TCP <unfinished ...>',
        'socket(AF_INET, SOCK_STREAM, IPPROTO_IP) = -1 EAFNOSUPPORT (Address family not supported by protocol)',
        '11 connect(3, {sa_family=AF_INET, sin_port=htons(53), sin_addr=inet_addr("127.0.0.53")}, 16) = 0',
        '11 connect(3, {sa_family=AF_INET6, sin6_port=htons(443), inet_pton(AF_INET6, "::1", &sin6_addr)}, 28) = 0',
        '11 connect(3, {sa_family=AF_UNIX, sun_path="/run/user/1000/someone"}, 110) = 0',
        '11 connect(3, {sa_family=AF_UNIX, sun_path="/tmp/.X11-unix/X99/../other"}, 110) = 0',
        '11 connect(3, 0x7ffd1, 110) = -1 EFAULT (Bad address)',
        '11 sendto(3, "x", 1, 0, {sa_family=AF_INET, sin_port=htons(9), sin_addr=inet_addr("1.2.3.4")}, 16) = 1',
        '11 sendmsg(3, {msg_name={sa_family=AF_UNIX, sun_path="/dev/log"}, msg_namelen=110, msg_iovlen=1}, 0) = 1',
        '11 socket(AF_NETLINK, SOCK_RAW|SOCK_CLOEXEC, NETLINK_ROUTE) = 3',
        '11 socket(AF_VSOCK, SOCK_STREAM, 0) = 3',
        '11 socket(AF_PACKET, SOCK_RAW, htons(ETH_P_ALL)) = 3',
        '11 bind(3, {sa_family=AF_UNIX, sun_path="/tmp/mine"}, 110) = 0',
        '11 listen(3, 1) = 0',
        '11 io_uring_setup(8, {flags=0}) = 4',
        '11 a line that nobody knows',
        '12 ???( <unfinished ...>',  # and it lives on: what did it call?
        '13 <... ??? resumed>) = ?',
    )

    def test_local_servers_are_known_by_name(self):
        found = network_trace.judged(self.ALLOWED, SERVERS)
        self.assertEqual(found.offences, [])
        self.assertEqual(dict(found.servers), {"display": 1, "sound": 1})
        self.assertEqual((found.lines, found.ended), (14, 2))

    def test_each_offence_is_said_by_its_call(self):
        for line in self.REFUSED:
            with self.subTest(line=line):
                found = network_trace.judged(self.ALLOWED + line + "\n", SERVERS)
                self.assertEqual(len(found.offences), 1)
                self.assertIn(line, found.offences[0])

    def test_a_real_connection_is_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            trace = os.path.join(folder, "trace")
            reach = "import socket; socket.socket(socket.AF_INET, socket.SOCK_DGRAM).connect(('127.0.0.1', 9))"
            run_traced([sys.executable, "-c", reach], trace)
            offences = judged(trace).offences
        self.assertEqual([re.search(r"(\w+)\(", line)[1] for line in offences][:2], ["socket", "connect"])


def run_traced(command, trace, calls=network_trace.CALLS, **how):
    """Runs it to its end, and until the trace is whole."""
    done = subprocess.run(network_trace.traced(command, trace, calls), capture_output=True, text=True, **how)
    wait_until(lambda: is_whole(trace))
    return done


def is_whole(trace):
    """Whether the first process that it speaks of has ended."""
    with open(trace, encoding="utf-8", errors="replace") as file:
        lines = file.read().splitlines()
    first = lines[0].split()[0] if lines else None
    return any(re.match(rf"{first}\s+\+\+\+ (exited|killed)", line) for line in lines)


def wait_until(true):
    end = time.monotonic() + desk.PATIENCE
    while not true():
        if time.monotonic() > end:
            raise AssertionError("it did not happen")
        time.sleep(0.05)


def files_below(folder):
    for place, folders, files in os.walk(folder):
        for name in folders + files:
            yield os.path.join(place, name)


def open_to_others(path):
    return stat.S_IMODE(os.lstat(path).st_mode) & 0o077


class Album(unittest.TestCase):
    """An afternoon with the verbs, with a umask that keeps nothing from anybody."""

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder, True)
        for name in ("album", "card", "cache", "home", "session"):
            os.mkdir(self.path(name), 0o700)
        shutil.copy(PHOTO, self.path("card/IMG_1.JPG"))
        with open(PHOTO, "rb") as one, open(self.path("card/IMG_2.JPG"), "wb") as other:
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
        done = run_traced([LAB, "album", *words], trace, network_trace.CALLS, env=environment,
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
        program = subprocess.Popen(network_trace.traced([PROGRAM, "--voice", "on", PHOTO], trace))
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


def written_in(node):
    """What somebody could change or read letter by letter; empty where there is no such thing."""
    try:
        return node.queryText().getText(0, -1)
    except NotImplementedError:
        return ""


class HostileWords(unittest.TestCase):
    """A stranger's names, captions, transcripts and file names on every page."""

    CALLS = network_trace.CALLS + ",open,openat,openat2"
    DETAILS = 7  # of a photograph that Browse tells one after the other
    ON_NO_PAGE = {"transcript", "model", "device"}  # searched in; read by verbs

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.listener = self.enterContext(Listener())
        self.album = HostileAlbum(LAB, PHOTO, self.folder, self.listener.port)
        self.focus = Focus()
        self.shown = set()

    def walk(self, pages, *words):
        """Over pages, until each has come to rest; whom the program met and what it opened on the way."""
        environment = preferences(self.folder, asked=True, voice="screen_reader", album_folders=[self.album.album.folder],
                                  last_photo=self.album.photos[0])
        trace = os.path.join(self.folder, "trace")
        command = [PROGRAM, "--size", "x".join(map(str, WIDE)), *words]
        running = subprocess.Popen(network_trace.traced(command, trace, self.CALLS), env=environment,
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
    """What a stranger's models and studies say of themselves, read by the verbs."""

    CALLS = HostileWords.CALLS

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.listener = self.enterContext(Listener())
        self.album = HostileAlbum(LAB, PHOTO, self.folder, self.listener.port)

    def verb(self, *words, good=True, **variables):
        """What it says; it met nobody and did not open what it was told to look at."""
        trace = os.path.join(self.folder, "trace")
        environment = dict(preferences(self.folder), XDG_RUNTIME_DIR=self.folder, **variables)
        done = run_traced([LAB, *words], trace, self.CALLS, env=environment)
        self.assertEqual(done.returncode == 0, good, f"{words}: {done.stdout}{done.stderr}")
        self.assertEqual(judged(trace).offences, [], words)
        with open(trace, encoding="utf-8", errors="replace") as file:
            calls = file.read()
        self.assertIn("open", calls)
        self.assertNotIn(self.album.bait, calls)
        self.assertEqual(self.listener.callers, [], words)
        return done.stdout + done.stderr

    def test_what_models_say_of_themselves_is_not_followed(self):
        words, models = self.album.words["model"], os.path.join(self.folder, "models")
        os.mkdir(models)
        known = os.path.join(os.path.dirname(PHOTO), "../models/yunet.onnx")
        file = hostile_files.model(known, words, self.album.bait, os.path.join(models, "yunet.onnx"))
        hostile_files.cascade(words, self.album.bait, os.path.join(models, "haarcascade_frontalface_default.xml"))
        said = self.verb("models", "check", good=False, TOUCHPHOTO_MODELS=models)
        self.assertIn("a file that we do not know", said)
        said += self.verb("models", "list", TOUCHPHOTO_MODELS=models)
        said += self.verb("faces", "--detector", file, PHOTO, good=False)
        self.assertNotIn(words, said)

    def test_a_study_s_page_shows_its_words_as_words(self):
        experiment = os.path.join(self.album.experiment(), "strangers.study")
        study = hostile_files.study(LAB, experiment, self.album.words["device"], os.path.join(self.folder, "study"))
        report = os.path.join(self.folder, "report")
        for words in (("check", study), ("report", study, "--out", report), ("export", study, "--out", report + ".zip")):
            self.verb("study", *words)
        pages = dict(hostile_files.pages_in(report))
        self.assertGreater(len(pages), 2)
        self.assertTrue(any(self.album.words["title"] in html.unescape(text) for text in pages.values()), "its title is nowhere")
        for name, text in pages.items():
            self.assertNotRegex(text, r"<[^>]*127\.0\.0\.1", name)


class Camera(unittest.TestCase):
    """A camera looks, the microphone of the moment hears: what goes anywhere, and what is kept."""

    CALLS = network_trace.CALLS + ",open,openat,openat2,creat"
    WRITES = re.compile(r"(?:open|openat|openat2|creat)\(.*?\"([^\"]*)\".*(?:O_WRONLY|O_RDWR|O_CREAT)")
    NO_PLACE_TO_KEEP = ("/dev/", "/proc/", "/sys/")
    # At the beginning of a file or anywhere in one, as in a row of the index.
    PICTURE_OR_SOUND = re.compile(rb"\xff\xd8\xff[\xdb\xe0-\xef]|\x89PNG\r\n|RIFF....(?:WAVE|WEBP|AVI )|fLaC\x00|OggS\x00|ftyp(?:mp4|iso|qt|hei|avi)", re.DOTALL)
    # What the program keeps in folders of its own.
    KEEPS = re.compile(r"(?:config/touchphoto/preferences\.json|cache/touchphoto/album\.(?:lock|sqlite))[^/]*")

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.album = FamilyAlbum(LAB, [PHOTO], self.folder)
        self.own = tuple(os.path.join(self.folder, name) for name in ("config", "cache"))

    def look(self, keys, until):
        """With the camera and the microphone on, until that is to be seen; what was opened to be written."""
        environment = preferences(self.folder, asked=True, voice="screen_reader", language="en", capture_told=True,
                                  shutter_by_itself=False, keep_moment=True, album_folders=[self.album.folder])
        trace = os.path.join(self.folder, "trace")
        command = [PROGRAM, "--camera", "simulated:" + PHOTO, "--page", "capture"]
        running = subprocess.Popen(network_trace.traced(command, trace, self.CALLS), env=environment)
        try:
            page = desk.Page()
            page.await_name("The microphone is on.")
            page.await_name("What to do: …")
            page.keys(*keys)
            page.await_name(until)
            time.sleep(2.0)  # twenty frames
            self.assertIsNone(running.poll(), "the program has ended")
        finally:
            running.terminate()
            running.wait(20)
        wait_until(lambda: is_whole(trace))
        self.assertEqual(judged(trace).offences, [])
        with open(trace, encoding="utf-8", errors="replace") as file:
            return {found[1] for line in file if (found := self.WRITES.search(line))}

    def assert_kept_nowhere_but(self, written, *places):
        """What was written lies in these places or in folders of the program's own, and there it is no picture and no sound."""
        self.assertTrue(any(path.startswith(self.own) for path in written), f"strace saw nothing of {written}")
        elsewhere = sorted(path for path in written if not path.startswith(self.own + self.NO_PLACE_TO_KEEP + places))
        self.assertEqual(elsewhere, [])
        inside = [os.path.relpath(path, self.folder) for path in written if "/touchphoto/" in path and path.startswith(self.own)]
        self.assertEqual([path for path in inside if not self.KEEPS.fullmatch(path)], [])
        for path in files_below(self.folder):
            if os.path.isfile(path) and path.startswith(self.own):
                with open(path, "rb") as file:
                    self.assertIsNone(self.PICTURE_OR_SOUND.search(file.read()), path)

    def test_the_judge_knows_a_picture_and_a_sound(self):
        for kept in (b"\xff\xd8\xff\xe0\0\x10JFIF", b"a row\xff\xd8\xff\xe1", b"RIFF\1\2\3\4WAVEfmt ", b"fLaC\0\0\0\x22", b"\0\0\0\x18ftypmp42"):
            self.assertIsNotNone(self.PICTURE_OR_SOUND.search(kept), kept)
        self.assertIsNotNone(self.KEEPS.fullmatch("cache/touchphoto/album.sqlite-wal"))
        for path in ("cache/touchphoto/frame.raw", "config/touchphoto/preferences.json/frame", "cache/touchphoto/moment.pcm"):
            self.assertIsNone(self.KEEPS.fullmatch(path), path)

    def test_without_the_shutter_nothing_is_kept(self):
        before = sorted(files_below(self.album.folder))
        written = self.look((), "Take the photograph")
        self.assert_kept_nowhere_but(written)
        self.assertEqual(sorted(files_below(self.album.folder)), before)

    def test_with_it_one_photograph_is_kept_in_the_album(self):
        before = set(files_below(self.album.folder))
        written = self.look(("space",), "Last photograph: Taken…")
        self.assert_kept_nowhere_but(written, self.album.folder + "/")
        kept = sorted(os.path.splitext(path)[1] for path in set(files_below(self.album.folder)) - before if os.path.isfile(path))
        self.assertEqual([ending for ending in kept if ending not in (".flac", ".part")], [".jpg", ".xmp"])
        self.assertLessEqual(len(kept), 3)  # and the sound of the moment, as far as it was over


def outer():
    reason = network_trace.can_trace()
    if reason:
        print(f"SKIP: {reason}")
        return 77
    os.environ.pop("SESSION_MANAGER", None)
    return desk.at_a_desk(__file__, "ffmpeg", "pulseaudio", "pactl", "speech-dispatcher", seconds=580, opengl=True)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    if not desk.is_at_a_desk():
        sys.exit(outer())
    PROGRAM, LAB, PHOTO = sys.argv[1:4]
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
