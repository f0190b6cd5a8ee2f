# SPDX-License-Identifier: Apache-2.0
"""An album of a stranger's: whatever it says in words would like to be fetched from somewhere."""
import os
import shutil
import socket
import subprocess
import threading

from album import Album, tone


class Listener:
    """A server on this machine that waits for whoever lets itself be called. It answers nobody."""

    def __enter__(self):
        self.server = socket.create_server(("127.0.0.1", 0))
        self.port = self.server.getsockname()[1]
        self.callers = []
        self.thread = threading.Thread(target=self.listen, daemon=True)
        self.thread.start()
        return self

    def listen(self):
        while True:
            try:
                caller, _ = self.server.accept()
            except OSError:
                return
            caller.settimeout(5.0)
            try:
                self.callers.append(caller.recv(4096).decode("latin-1"))
            except OSError as silent:
                self.callers.append(f"somebody, who said nothing ({silent})")
            caller.close()

    def __exit__(self, *_):
        self.server.shutdown(socket.SHUT_RDWR)
        self.server.close()
        self.thread.join()


class HostileAlbum:
    """`words` has what is said in each place where a stranger's words come from. Each wants something from the port and
    the picture `bait`, which lies on this machine outside the album."""

    def __init__(self, lab, photo, folder, port):
        self.folder = folder
        self.bait = os.path.join(folder, "bait.png")
        subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-f", "lavfi", "-i", "color=red:s=8x8", "-frames:v", "1",
                        self.bait], check=True)
        self.port = port
        self.words = {where: self.hostile(where) for where in
                      ("person", "caption", "keyword", "transcript", "speaker", "place", "title", "device")}
        # A slash cannot be in a file's name, but its entity can.
        self.words["file"] = f"Ann <img src=http:&#47;&#47;127.0.0.1:{port}&#47;file.png> B"
        self.words["camera"] = self.words["file"].replace("file", "camera")
        self.film = os.path.join(folder, self.words["camera"] + ".mp4")
        with open(self.film, "wb") as file:
            file.write(b"no film")
        named = os.path.join(folder, self.words["file"] + ".jpg")
        shutil.copy(photo, named)
        self.album = Album(lab, [named, photo], folder, name=f"<img src=http:&#47;&#47;127.0.0.1:{port}&#47;folder.png>")
        self.photos = self.album.photos
        subprocess.run(["exiftool", "-q", "-overwrite_original", "-XMP-dc:Description=" + self.words["caption"],
                        "-XMP-iptcCore:AltTextAccessibility=" + self.words["caption"],
                        "-XMP-dc:Subject=" + self.words["keyword"], "-XMP-photoshop:City=" + self.words["place"],
                        *self.photos], check=True)
        memo = tone(os.path.join(folder, "memo.wav"), 440, 1.0)
        for one in self.photos:
            self.album.run("person", "name", "--face", "0.5,0.4,0.4,0.5", one, self.words["person"])
            self.album.run("tag", "add", one, "--from", memo, "--kind", "person", "--person", self.words["person"],
                           "--speaker", self.words["speaker"], "--transcript", self.words["transcript"])

    def experiment(self):
        """A folder with nothing but a stranger's experiment."""
        folder = os.path.join(self.folder, "experiments")
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, "strangers.study"), "w", encoding="utf-8") as file:
            file.write(f"experiment: strangers\ntitle: {self.words['title']}\ntask: follow\n"
                       "factor stiffness: 0.1, 0.2 N/mm\nset range: 5 mm\nset path: circle\nset radius: 40 mm\n")
        return folder

    def hostile(self, where):
        return (f"Ann <img src=\"http://127.0.0.1:{self.port}/{where}.png\"> <img src=\"file://{self.bait}\"> "
                f"![B](http://127.0.0.1:{self.port}/{where}.md) <a href=\"http://127.0.0.1:{self.port}/\">{where}</a>")

    def kinds_in(self, names):
        """Which of the words are among what a screen reader finds."""
        return {kind for kind, words in self.words.items() if any(words in name for name in names)}
