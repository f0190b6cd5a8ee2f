# SPDX-License-Identifier: Apache-2.0
"""Builds a room's tests with a mutant in them, and runs them until one notices."""

from __future__ import annotations

import hashlib
import math
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import tempfile
import threading
import time

from mutant import Mutant
from program import Program, Test
from record import NOTICED, SAME, SURVIVED, UNBUILDABLE

_ROOM_EFFORT = "-O1"
_COMPILE_SECONDS = 300.0
_MEMORY = pathlib.Path("/dev/shm")  # a disk that nobody waits for
_ROOM_FOR_TESTS = 4 << 30  # bytes
# Of what goes wrong at random (tests/device/closed_loop) a tenth: what a mutant breaks shows at once, or in none of it.
_FEWER = {"TP_SCHEDULES": "200"}


class Stopped(Exception):
    """The person has had enough."""


class TestsFail(Exception):
    """They do so without any mutant."""


class Judge:
    """One room. `prepare` first; then `judge` from several threads, each with a folder of its own."""

    def __init__(self, program: Program, room: str, work: pathlib.Path):
        self._program = program
        self._room = room
        self._work = work
        self._tests = program.tests(room)
        self._plain: dict[str, pathlib.Path] = {}  # the objects of the room without a mutant, by their source
        self._needs: dict[str, set[str]] = {}  # what a room's source or a test's object includes
        self._seconds: dict[str, float] = {}
        self._processor_seconds: dict[str, float] = {}
        self._noticed: dict[str, int] = {}
        self._lock = threading.Lock()
        self._running: set[subprocess.Popen] = set()
        self._stop = False

    def stop(self) -> None:
        with self._lock:
            self._stop = True
            for process in self._running:
                _kill(process)

    def compile_room(self, file: str, folder: pathlib.Path) -> None:
        """One of program.replaced_files, without a mutant."""
        target = self._plain_object(file)
        target.parent.mkdir(parents=True, exist_ok=True)
        cache = ["ccache"] if shutil.which("ccache") else []
        command = [*cache, *self._room_command(file), "-MMD", "-MF", f"{target}.d", "-o", str(target), "-c", file]
        if self._run(command, _COMPILE_SECONDS, folder / "compile.txt") != 0:
            raise TestsFail(f"{file} does not compile alone:\n" + (folder / "compile.txt").read_text())
        words = pathlib.Path(f"{target}.d").read_text(encoding="utf-8").replace("\\\n", " ").split()[1:]
        with self._lock:
            self._plain[file] = target
            self._needs[file] = {os.path.realpath(self._program.build / word) for word in words}

    def run_plain(self, folder: pathlib.Path) -> None:
        """Every test without a mutant: how long it takes, and that it passes."""
        for test in self._tests:
            for name in test.objects:
                self._needs[name] = self._program.headers_of(name)
            program = folder / "test"
            if self._link(test, {}, {}, program, folder) != 0:
                raise TestsFail(f"{test.name} cannot be linked:\n" + (folder / "link.txt").read_text())
            begun, worked = time.monotonic(), _processor_seconds()
            if self._run_test(test, program, 300.0, 300.0, folder) != 0:
                raise TestsFail(f"{test.name} fails without any mutant:\n" +
                                (folder / "test.txt").read_text(errors="replace")[-2000:])
            self._seconds[test.name] = time.monotonic() - begun
            self._processor_seconds[test.name] = _processor_seconds() - worked

    def judge(self, mutant: Mutant, content: bytes, folder: pathlib.Path) -> tuple[str, str]:
        """What becomes of it, and which test noticed."""
        if mutant.file.endswith(".hpp"):
            return self._judge_header(mutant, content, folder)
        file = str(self._program.root / mutant.file)
        source = folder / os.path.basename(file)
        source.write_bytes(mutant.applied(content))
        target = folder / "mutant.o"
        if self._compile(self._room_command(file), file, source, target, [], folder) != 0:
            return UNBUILDABLE, ""
        if _digest(target) == _digest(self._plain[file]):
            return SAME, ""
        for test in self._in_order(mutant):
            if self._notices(test, {file: target}, {}, folder):
                return NOTICED, test.name
        return SURVIVED, ""

    def _judge_header(self, mutant: Mutant, content: bytes, folder: pathlib.Path) -> tuple[str, str]:
        """All that includes it is compiled with the mutant in its place."""
        overlay = folder / "overlay"
        shutil.rmtree(overlay, ignore_errors=True)
        header = overlay / mutant.file
        header.parent.mkdir(parents=True)
        header.write_bytes(mutant.applied(content))
        include = [f"-I{overlay}"]
        original = os.path.realpath(self._program.root / mutant.file)
        same = True
        objects = {}
        for number, file in enumerate(self._plain):
            if original in self._needs[file]:
                target = folder / f"room_{number}.o"
                if self._compile(self._room_command(file), file, pathlib.Path(file), target, include, folder) != 0:
                    return UNBUILDABLE, ""
                same = same and _digest(target) == _digest(self._plain[file])
                objects[file] = target
        for test in self._in_order(mutant):
            own = {}
            for number, name in enumerate(test.objects):
                if original in self._needs[name]:
                    source = self._program.source_of(name)
                    path = str(self._program.root / source)
                    target = folder / f"test_{number}.o"
                    if self._compile(self._program.compile_command(path), path, pathlib.Path(path), target, include,
                                     folder) != 0:
                        return UNBUILDABLE, ""
                    if _digest(target) != _digest(test.objects[name]):
                        same = False
                    own[name] = target
            if same and not own:
                continue
            if self._notices(test, objects, own, folder):
                return NOTICED, test.name
        return (SAME if same else SURVIVED), ""

    def _in_order(self, mutant: Mutant) -> list[Test]:
        """The one named after the file first, then those that notice most in a second."""
        stem = pathlib.PurePath(mutant.file).stem
        with self._lock:
            worth = {test.name: (self._noticed.get(test.name, 0) + 1) / (self._seconds[test.name] + 0.2)
                     for test in self._tests}
        return sorted(self._tests, key=lambda test: (test.name.rsplit(".", 1)[-1] != stem, -worth[test.name]))

    def _notices(self, test: Test, room: dict, own: dict, folder: pathlib.Path) -> bool:
        program = folder / "test"
        if self._link(test, room, own, program, folder) != 0:
            return True
        seconds = 8 * self._seconds[test.name] + 10.0  # a machine that others use too is slow now and then
        if self._run_test(test, program, seconds, 4 * self._processor_seconds[test.name] + 3.0, folder) == 0:
            return False
        with self._lock:
            self._noticed[test.name] = self._noticed.get(test.name, 0) + 1
        return True

    def _plain_object(self, file: str) -> pathlib.Path:
        return self._work / "plain" / (hashlib.sha256(file.encode()).hexdigest()[:16] + ".o")

    def _room_command(self, file: str) -> list[str]:
        return [*self._program.compile_command(file), _ROOM_EFFORT]

    def _compile(self, command: list[str], file: str, source: pathlib.Path, target: pathlib.Path, include: list[str],
                 folder: pathlib.Path) -> int:
        line = [command[0], *include, *command[1:], "-iquote", os.path.dirname(file), "-o", str(target), "-c", str(source)]
        return self._run(line, _COMPILE_SECONDS, folder / "compile.txt")

    def _link(self, test: Test, room: dict, own: dict, program: pathlib.Path, folder: pathlib.Path) -> int:
        """The room's objects before the libraries, so that what a library has of them is not taken, or in place of one that
        has nothing else; those of a library that the test does without stay out."""
        line = []
        replaced = self._program.whole_archives(self._plain)
        archives = {os.path.basename(word) for word in test.link if word.endswith(".a")}
        placed = False
        for word in test.link:
            if word.endswith(".a") and not placed:
                line += [str(room.get(file, plain)) for file, plain in self._plain.items()
                         if self._program.archive_of(file) in archives]
                placed = True
            if os.path.basename(word) not in replaced:
                line.append(str(own[word]) if word in own else word)
        line[line.index("-o") + 1] = str(program)
        return self._run(line, _COMPILE_SECONDS, folder / "link.txt")

    def _run_test(self, test: Test, program: pathlib.Path, seconds: float, processor_seconds: float,
                  folder: pathlib.Path) -> int:
        for other in self._program.programs_beside(test):
            beside = folder / other.name
            beside.unlink(missing_ok=True)
            beside.symlink_to(other.resolve())
        # A short name: that of a socket below it has 107 letters at most.
        with tempfile.TemporaryDirectory(prefix="mutant-", dir=_place_for_homes(), ignore_cleanup_errors=True) as home:
            os.chmod(home, 0o755)  # a test may look at what it made as somebody else
            environment = {**_FEWER, **os.environ, **test.environment, "TMPDIR": home, "XDG_CONFIG_HOME": f"{home}/config",
                           "XDG_CACHE_HOME": f"{home}/cache"}
            return self._run([str(program), *test.arguments], seconds, folder / "test.txt", cwd=home, env=environment,
                             preexec_fn=lambda: _limit(processor_seconds))

    def _run(self, command: list[str], seconds: float, output: pathlib.Path, **options) -> int:
        """Its exit status; that of a killed process where it takes too long."""
        options.setdefault("cwd", self._program.build)
        with output.open("wb") as file:
            with self._lock:
                if self._stop:
                    raise Stopped
                process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.STDOUT,
                                           process_group=0, **options)  # a session's leader would own a terminal it opens
                self._running.add(process)
            try:
                status = process.wait(seconds)
            except subprocess.TimeoutExpired:
                status = -signal.SIGKILL
            finally:
                with self._lock:
                    self._running.discard(process)
                _kill(process)  # and whom it started
                process.wait()
        if self._stop:
            raise Stopped
        return status


def _digest(path: pathlib.Path) -> bytes:
    return hashlib.sha256(path.read_bytes()).digest()


def _kill(process: subprocess.Popen) -> None:
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def _place_for_homes() -> pathlib.Path | None:
    """In memory, where there is room and programs may be run: what waits for the disk takes a fraction of the time."""
    if not _MEMORY.is_dir() or not os.access(_MEMORY, os.W_OK) or os.statvfs(_MEMORY).f_flag & os.ST_NOEXEC:
        return None
    return _MEMORY if shutil.disk_usage(_MEMORY).free > _ROOM_FOR_TESTS else None


def _processor_seconds() -> float:
    """Of all programs that were started and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _limit(processor_seconds: float) -> None:
    """A mutant that crashes or writes without end fills no disk, and one that goes round and round ends."""
    resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(processor_seconds), resource.RLIM_INFINITY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 30, 1 << 30))
