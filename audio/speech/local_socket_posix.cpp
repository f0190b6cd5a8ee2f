// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/local_socket.hpp"

#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace tp {

LocalSocket LocalSocket::to(const std::string& path) {
    LocalSocket made;
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path)
        return made;
    std::memcpy(address.sun_path, path.data(), path.size());
    LocalSocket socket;
    socket.number_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket.ok() &&
        ::connect(socket.number_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
        made = std::move(socket);
    return made;
}

LocalSocket::~LocalSocket() {
    if (ok())
        ::close(number_);
}

bool LocalSocket::send(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(number_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent <= 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return ok();
}

std::optional<std::size_t> LocalSocket::receive(std::span<char> into) {
    const ssize_t got = ::recv(number_, into.data(), into.size(), MSG_DONTWAIT);
    if (got < 0 && (errno == EAGAIN || errno == EINTR))
        return std::nullopt;
    return got < 0 ? 0 : static_cast<std::size_t>(got);
}

} // namespace tp
