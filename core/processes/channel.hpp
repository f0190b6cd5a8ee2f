// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor.hpp"
#include "core/processes/child_process.hpp"
#include "core/processes/message.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

namespace tp {

/// One end of a way for messages between two processes, in both directions.
class Channel {
public:
    explicit Channel(Descriptor end) : end_(std::move(end)) {}
    /// Two ends, of which the second is for a process that this one starts; none where the system has no room for
    /// them.
    static std::optional<std::pair<Channel, Channel>> pair();
    /// Says who has the second end of a pair: to be told before anything is handed over. On Windows a handle is a
    /// number in one process's own table, and this process alone moves it from one to the other.
    bool other_end_is(const ChildProcess& other);

    enum class Silence : std::uint8_t {
        not_yet, ///< nothing came in time
        gone     ///< nothing will come: the other end is closed, or sent what is no message
    };
    /// False where nobody takes it any more.
    bool send(const Message& message) noexcept;
    /// The next message; waits as long as that. A wait of less than nothing is one without an end.
    std::variant<Message, Silence> receive(std::chrono::milliseconds patience);
    DescriptorNumber descriptor() const { return end_.number(); }

private:
    Descriptor end_;
    Descriptor other_; ///< the process at the other end, where the system needs it
};

} // namespace tp
