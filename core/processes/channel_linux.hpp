// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor_posix.hpp"
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
    explicit Channel(Descriptor socket) : socket_(std::move(socket)) {}
    /// Two ends; none where the system has no room for them.
    static std::optional<std::pair<Channel, Channel>> pair();

    enum class Silence : std::uint8_t {
        not_yet, ///< nothing came in time
        gone     ///< nothing will come: the other end is closed, or sent what is no message
    };
    /// False where nobody takes it any more.
    bool send(const Message& message) noexcept;
    /// The next message; waits as long as that. A wait of less than nothing is one without an end.
    std::variant<Message, Silence> receive(std::chrono::milliseconds patience);
    int descriptor() const { return socket_.number(); }

private:
    Descriptor socket_;
};

} // namespace tp
