// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace tp {

/// What a confined process may still have.
struct Limits {
    std::uint64_t memory_bytes; ///< of addresses, what its libraries take included
    int descriptors;
};

/// Takes from this process for good what decoding does not need. Afterwards it computes, has memory and
/// threads of its own, reads and writes what is open, and hands over memory on the socket that it has. It
/// opens no file and no socket, starts no program, sends no signal to another, sees no other process and maps
/// no code (seccomp(2)); it is the first that the system ends where memory is short. Libraries that it needs
/// must be loaded before. The reason where the system does not do it: then nothing foreign may be decoded.
std::string confine(const Limits& limits);

/// Lets the kernel end this process when it has computed so long from now on.
void compute_no_longer_than(int seconds);

} // namespace tp
