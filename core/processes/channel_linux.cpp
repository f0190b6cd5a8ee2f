// SPDX-License-Identifier: Apache-2.0
#include "core/processes/channel.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>

namespace tp {
namespace {

/// Room for one descriptor beside a message's bytes.
struct Beside {
    alignas(cmsghdr) std::array<unsigned char, CMSG_SPACE(sizeof(int))> bytes{};
};

msghdr header_for(iovec& bytes) {
    msghdr header{};
    header.msg_iov = &bytes;
    header.msg_iovlen = 1;
    return header;
}

/// The descriptors in a header that was received.
std::vector<Descriptor> handed_over(msghdr& header) {
    std::vector<Descriptor> descriptors;
    for (cmsghdr* part = CMSG_FIRSTHDR(&header); part != nullptr; part = CMSG_NXTHDR(&header, part)) {
        if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_RIGHTS ||
            part->cmsg_len != CMSG_LEN(sizeof(int)))
            continue;
        int number = -1;
        std::memcpy(&number, CMSG_DATA(part), sizeof number);
        descriptors.emplace_back(number);
    }
    return descriptors;
}

} // namespace

std::optional<std::pair<Channel, Channel>> Channel::pair() {
    std::array<int, 2> ends{-1, -1};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return std::nullopt;
    return std::pair(Channel(Descriptor(ends[0])), Channel(Descriptor(ends[1])));
}

bool Channel::other_end_is(const ChildProcess&) { return true; } // the kernel hands over by itself

bool Channel::send(const Message& message) noexcept {
    if (message.bytes.size() > longest_message || message.descriptors.size() > 1)
        return false;
    iovec bytes{const_cast<unsigned char*>(message.bytes.data()), message.bytes.size()};
    msghdr header = header_for(bytes);
    Beside beside;
    if (!message.descriptors.empty()) {
        header.msg_control = beside.bytes.data();
        header.msg_controllen = beside.bytes.size();
        cmsghdr* const part = CMSG_FIRSTHDR(&header);
        part->cmsg_level = SOL_SOCKET;
        part->cmsg_type = SCM_RIGHTS;
        part->cmsg_len = CMSG_LEN(sizeof(int));
        const int number = message.descriptors.front().number();
        std::memcpy(CMSG_DATA(part), &number, sizeof number);
    }
    while (::sendmsg(end_.number(), &header, MSG_NOSIGNAL) < 0)
        if (errno != EINTR)
            return false;
    return true;
}

std::variant<Message, Channel::Silence> Channel::receive(std::chrono::milliseconds patience) {
    pollfd one{end_.number(), POLLIN, 0};
    int ready = 0;
    do
        ready = ::poll(&one, 1, static_cast<int>(patience.count()));
    while (ready < 0 && errno == EINTR);
    if (ready == 0)
        return Silence::not_yet;
    Message message;
    message.bytes.resize(longest_message);
    iovec bytes{message.bytes.data(), message.bytes.size()};
    msghdr header = header_for(bytes);
    Beside beside;
    header.msg_control = beside.bytes.data();
    header.msg_controllen = beside.bytes.size();
    const ssize_t count = ::recvmsg(end_.number(), &header, MSG_CMSG_CLOEXEC | MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EINTR))
        return Silence::not_yet;
    if (count <= 0)
        return Silence::gone;
    message.descriptors = handed_over(header);
    if ((header.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) != 0)
        return Silence::gone;
    message.bytes.resize(static_cast<std::size_t>(count));
    return message;
}

} // namespace tp
