// SPDX-License-Identifier: Apache-2.0
// Where no speech-dispatcher is, and Qt's own engines speak.
#include "audio/speech/local_socket.hpp"

namespace tp {

LocalSocket LocalSocket::to(const std::string&) { return {}; }

LocalSocket::~LocalSocket() = default;

bool LocalSocket::send(std::string_view) { return false; }

std::optional<std::size_t> LocalSocket::receive(std::span<char>) { return 0; }

} // namespace tp
