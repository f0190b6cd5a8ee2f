// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor.hpp"

#include <cstdint>
#include <string>

namespace tp {

/// What a confined process may still have.
struct Limits {
    std::uint64_t memory_bytes; ///< what its libraries take included: on Linux addresses, on Windows memory
    int descriptors;            ///< on Linux
};

/// What came of it.
struct Confinement {
    std::string problem; ///< why this system does not do it: then nothing foreign may be decoded
    Descriptor leash;    ///< where the program that asks lets go of it, this process ends; only on Windows
};

/// Takes from this process for good what decoding does not need. Libraries that it needs must be loaded before.
///
/// On Linux it computes afterwards, has memory and threads of its own, reads and writes what is open, and hands over
/// memory on the socket that it has. It opens no file and no socket, starts no program, sends no signal to another,
/// sees no other process and maps no code (seccomp(2)); it is the first that the system ends where memory is short.
///
/// On Windows it has no privileges afterwards, writes no file, opens no other process and starts none, makes no code and
/// loads nobody's but Microsoft's (its token, its integrity, process mitigation policies). A job limits its memory,
/// keeps it from the clipboard and other programs' windows where the program that asks is in no job of its own, and
/// ends it with that program. It can still open files that the person may read, open sockets and see which processes
/// there are: a process cannot give that up by itself there. Nothing of it was tried on Windows itself; what Wine does
/// of it, tests/windows/README.md says.
Confinement confine(const Limits& limits);

/// Lets the kernel end this process when it has computed so long from now on. On Windows nothing: there it is ended by
/// the program that asks, or with it.
void compute_no_longer_than(int seconds);

} // namespace tp
