# SPDX-License-Identifier: Apache-2.0
"""What a program asked of the network, by strace: which sockets, to whom, and whether it may."""
import collections
import re
import subprocess

# The calls that make, use or hand over sockets; io_uring could do the same behind the tracer's back.
CALLS = "network,io_uring_setup"

CALL = re.compile(r"(?:\d+\s+)?(\w+)\((.*)$")
OTHER = re.compile(r"(?:\d+\s+)?(\+\+\+ |--- |<\.\.\. \w+ resumed>)|strace: Process \d+ (attached|detached)")
# A thread that was ended on the doorstep of a call: the kernel lets nobody in after that, and strace can no longer ask
# which call it was. It is one only where that thread's end follows.
NEVER_BEGUN = re.compile(r"(\d+)\s+(\?+\(\s*<unfinished \.\.\.>|<\.\.\. \?+ resumed>\) += \?|\?+\(\) += \?)$")
END = re.compile(r"(\d+)\s+\+\+\+ (?:exited with|killed by) ")
ADDRESS = re.compile(r"sa_family=(\w+)(?:, sun_path=(@?\"[^\"]*\"))?")
# Calls whose addresses are where something is sent to; in others they are who we are, or who is asking.
TO_SOMEBODY = ("connect", "sendto", "sendmsg", "sendmmsg")

Findings = collections.namedtuple("Findings", "offences servers lines ended")


def traced(command, trace, calls=CALLS):
    """The command that runs `command` under strace. It is the child of who starts it, as it would be without."""
    return ["strace", "-D", "-f", "--seccomp-bpf", "-s", "256", "-e", "trace=" + calls, "-o", trace] + list(command)


def can_trace():
    """Empty where strace works here; else why not."""
    try:
        done = subprocess.run(["strace", "-f", "-e", "trace=network", "-o", "/dev/null", "true"], capture_output=True,
                              text=True)
    except FileNotFoundError:
        return "strace is not installed"
    return "" if done.returncode == 0 else "strace may not trace here: " + done.stderr.strip()


def judged(trace, servers):
    """Judges the text of a trace. `servers`: name -> regular expression of the whole path of the local sockets that a
    program may connect to. Every call that is not one of those is an offence, in strace's own words."""
    offences, met, ended = [], collections.Counter(), 0
    lines = trace.splitlines()
    last_end = {end[1]: at for at, line in enumerate(lines) if (end := END.match(line))}
    for at, line in enumerate(lines):
        ended += "+++ exited with" in line or "+++ killed by" in line
        call = CALL.match(line)
        if not call:
            never_begun = NEVER_BEGUN.match(line)
            if not OTHER.match(line) and not (never_begun and last_end.get(never_begun[1], -1) > at):
                offences.append("not understood: " + line)
            continue
        name, words = call.groups()
        if not allowed(name, words, servers, met):
            offences.append(line)
    return Findings(offences, met, len(lines), ended)


def allowed(name, words, servers, met):
    if name in ("socket", "socketpair"):
        return words.startswith(("AF_UNIX,", "AF_LOCAL,")) or is_kernel_event(words)
    if name in ("listen", "accept", "accept4", "io_uring_setup"):
        return False  # nobody is to come in
    addresses = ADDRESS.findall(words)
    if name == "bind":  # only to hear the kernel's events
        return bool(addresses) and all(family == "AF_NETLINK" for family, _ in addresses)
    for family, path in addresses:
        if family not in ("AF_UNIX", "AF_NETLINK", "AF_UNSPEC"):
            return False
        if family != "AF_UNIX" or name not in TO_SOMEBODY:
            continue
        server = next((who for who, like in servers.items() if re.fullmatch(like, path.replace('"', ""))), None)
        if server is None:
            return False
        met[server] += 1
    return name != "connect" or any(family == "AF_UNIX" for family, _ in addresses)


def is_kernel_event(words):
    """Devices that come and go are told through such a socket, by the kernel of this machine; it knows no other."""
    return words.startswith("AF_NETLINK,") and "NETLINK_KOBJECT_UEVENT" in words
