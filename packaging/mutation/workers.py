# SPDX-License-Identifier: Apache-2.0
"""Several things at a time, each in a folder that no other uses meanwhile."""

from __future__ import annotations

import concurrent.futures
import contextlib
import fcntl
import pathlib
import queue
from collections.abc import Callable, Iterable, Iterator


class OtherRun(Exception):
    """Another run uses these folders."""


@contextlib.contextmanager
def alone(folder: pathlib.Path) -> Iterator[None]:
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise OtherRun(f"Another run is at work in {folder}.") from None
        yield


def for_each(things: Iterable, work: Callable, jobs: int, folder: pathlib.Path, stop: Callable[[], None]) -> None:
    """Calls work(thing, folder) for each. Where one fails or the person interrupts, `stop` ends those at work."""
    folders: queue.SimpleQueue = queue.SimpleQueue()
    for number in range(jobs):
        own = folder / f"worker_{number}"
        own.mkdir(parents=True, exist_ok=True)
        folders.put(own)

    def one(thing):
        own = folders.get()
        try:
            work(thing, own)
        finally:
            folders.put(own)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        running = [pool.submit(one, thing) for thing in things]
        try:
            for future in concurrent.futures.as_completed(running):
                future.result()
        except BaseException:
            for future in running:
                future.cancel()
            stop()
            raise
