# SPDX-License-Identifier: Apache-2.0
"""Whom a program met and what it wrote, by its trace: what the tests of privacy share, and whether the judge can say no."""
import os
import re
import stat
import subprocess
import sys
import tempfile
import time
import types
import unittest

import desk
import network_trace

# What is tried: the paths of the program, of touchphoto-lab and of a photograph; privacy.py says them.
TRIED = types.SimpleNamespace(program=None, lab=None, photo=None)

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
12 ???()                             = ?
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
        '13 ???()                             = ?',
    )

    def test_local_servers_are_known_by_name(self):
        found = network_trace.judged(self.ALLOWED, SERVERS)
        self.assertEqual(found.offences, [])
        self.assertEqual(dict(found.servers), {"display": 1, "sound": 1})
        self.assertEqual((found.lines, found.ended), (15, 2))

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
