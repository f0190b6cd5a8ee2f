// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/overlapped_io.hpp"
#include "core/base/windows/pipe_pair.hpp"
#include "core/processes/channel.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

namespace tp {
namespace {

using windows::Handle;

/// What comes before a message's bytes: the handle that is handed over, as the process counts it that has, or gets, it; 0: none.
using Handed = std::int64_t;
constexpr std::size_t longest_frame = sizeof(Handed) + longest_message;
constexpr DWORD taking_patience_ms = 30'000; ///< of a pipe that has room for a message

HANDLE handle_of(const Descriptor& descriptor) { return reinterpret_cast<HANDLE>(descriptor.number()); }

Descriptor owned(Handle handle) {
    return handle ? Descriptor(reinterpret_cast<DescriptorNumber>(handle.release())) : Descriptor();
}

/// The same in another process, or from one.
HANDLE duplicated(HANDLE from, HANDLE handle, HANDLE to, DWORD options) {
    HANDLE made = nullptr;
    return DuplicateHandle(from, handle, to, &made, 0, FALSE, DUPLICATE_SAME_ACCESS | options) != 0 ? made
                                                                                                    : nullptr;
}

/// What a process at the other end says is a handle of its own. None where it is none; a number below nothing is none either,
/// which Windows takes for a process itself.
Descriptor taken_from(HANDLE other, Handed number) {
    if (number <= 0)
        return Descriptor();
    return owned(Handle(
        duplicated(other, reinterpret_cast<HANDLE>(number), GetCurrentProcess(), DUPLICATE_CLOSE_SOURCE)));
}

} // namespace

std::optional<std::pair<Channel, Channel>> Channel::pair() {
    auto ends = windows::pipe_pair(PIPE_TYPE_MESSAGE | PIPE_READMODE_MESSAGE, longest_frame);
    if (!ends)
        return std::nullopt;
    return std::pair(Channel(owned(std::move(ends->first))), Channel(owned(std::move(ends->second))));
}

bool Channel::other_end_is(const ChildProcess& other) {
    other_ = owned(Handle(
        duplicated(GetCurrentProcess(), reinterpret_cast<HANDLE>(other.number()), GetCurrentProcess(), 0)));
    return other_.ok();
}

bool Channel::send(const Message& message) noexcept {
    if (message.bytes.size() > longest_message || message.descriptors.size() > 1)
        return false;
    Handed handed = 0;
    if (!message.descriptors.empty()) {
        const HANDLE to =
            other_.ok() ? handle_of(other_) : GetCurrentProcess(); // whence the other end takes it
        handed = reinterpret_cast<Handed>(
            duplicated(GetCurrentProcess(), handle_of(message.descriptors.front()), to, 0));
        if (handed == 0)
            return false;
    }
    std::array<std::uint8_t, longest_frame> room{};
    const std::span frame(room.data(), sizeof handed + message.bytes.size());
    std::memcpy(frame.data(), &handed, sizeof handed);
    std::copy(message.bytes.begin(), message.bytes.end(), frame.begin() + sizeof handed);
    return windows::write_some(handle_of(end_), frame, taking_patience_ms) == static_cast<int>(frame.size());
}

std::variant<Message, Channel::Silence> Channel::receive(std::chrono::milliseconds patience) {
    Message message;
    message.bytes.resize(longest_frame);
    const int count =
        windows::read_some(handle_of(end_), message.bytes,
                           patience.count() < 0 ? INFINITE : static_cast<DWORD>(patience.count()));
    if (count == 0)
        return Silence::not_yet;
    Handed handed = 0;
    if (count < static_cast<int>(sizeof handed)) // and where it was longer than a message may be
        return Silence::gone;
    std::memcpy(&handed, message.bytes.data(), sizeof handed);
    message.bytes.resize(static_cast<std::size_t>(count));
    message.bytes.erase(message.bytes.begin(), message.bytes.begin() + sizeof handed);
    if (handed != 0) {
        message.descriptors.push_back(other_.ok() ? taken_from(handle_of(other_), handed)
                                                  : Descriptor(handed));
        if (!message.descriptors.front().ok())
            return Silence::gone;
    }
    return message;
}

} // namespace tp
