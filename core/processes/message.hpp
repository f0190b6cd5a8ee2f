// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// The longest that passes from one process to another at once, in bytes. What is longer lies in shared
/// memory.
inline constexpr std::size_t longest_message = 1 << 16;

/// What one process says to another: bytes, and descriptors that it hands over.
struct Message {
    std::vector<unsigned char> bytes;
    std::vector<Descriptor> descriptors; ///< at most one
};

/// Puts a message together.
class MessageWriter {
public:
    MessageWriter& add(std::int64_t number);
    MessageWriter& add(std::string_view text);
    MessageWriter& add(std::span<const std::int32_t> numbers);
    MessageWriter& hand_over(Descriptor descriptor);
    Message take() { return std::move(message_); }

private:
    void add_bytes(const void* from, std::size_t count);

    Message message_;
};

/// Takes a message apart, in the order in which it was put together. The other process may say anything: what
/// is missing is zero or empty, and then the message is not `whole`.
class MessageReader {
public:
    explicit MessageReader(Message& message) : message_(message) {}

    std::int64_t number();
    std::string text();
    /// As many as there are, at most as many as `to` has room for.
    std::size_t numbers(std::span<std::int32_t> to);
    Descriptor descriptor();
    bool has_descriptor() const { return taken_ < message_.descriptors.size(); }
    /// Whether all that was asked for was there, and nothing is left.
    bool whole() const;

private:
    std::span<const unsigned char> next(std::size_t count);

    Message& message_;
    std::size_t at_ = 0;
    std::size_t taken_ = 0; ///< descriptors
    bool missing_ = false;
};

} // namespace tp
