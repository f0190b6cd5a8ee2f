// SPDX-License-Identifier: Apache-2.0
#include "core/processes/message.hpp"

#include <algorithm>
#include <cstring>

namespace tp {

void MessageWriter::add_bytes(const void* from, std::size_t count) {
    const auto* const bytes = static_cast<const unsigned char*>(from);
    message_.bytes.insert(message_.bytes.end(), bytes, bytes + count);
}

MessageWriter& MessageWriter::add(std::int64_t number) {
    add_bytes(&number, sizeof number);
    return *this;
}

MessageWriter& MessageWriter::add(std::string_view text) {
    add(static_cast<std::int64_t>(text.size()));
    add_bytes(text.data(), text.size());
    return *this;
}

MessageWriter& MessageWriter::add(std::span<const std::int32_t> numbers) {
    add(static_cast<std::int64_t>(numbers.size()));
    add_bytes(numbers.data(), numbers.size_bytes());
    return *this;
}

MessageWriter& MessageWriter::hand_over(Descriptor descriptor) {
    message_.descriptors.push_back(std::move(descriptor));
    return *this;
}

std::span<const unsigned char> MessageReader::next(std::size_t count) {
    if (missing_ || count > message_.bytes.size() - at_) {
        missing_ = true;
        return {};
    }
    return std::span(message_.bytes).subspan(std::exchange(at_, at_ + count), count);
}

std::int64_t MessageReader::number() {
    std::int64_t number = 0;
    if (const auto bytes = next(sizeof number); !bytes.empty())
        std::memcpy(&number, bytes.data(), sizeof number);
    return number;
}

std::string MessageReader::text() {
    const auto bytes = next(static_cast<std::size_t>(number()));
    return {bytes.begin(), bytes.end()};
}

std::size_t MessageReader::numbers(std::span<std::int32_t> to) {
    const auto count = static_cast<std::size_t>(number());
    if (count > to.size()) {
        missing_ = true;
        return 0;
    }
    const auto bytes = next(count * sizeof(std::int32_t));
    if (!bytes.empty())
        std::memcpy(to.data(), bytes.data(), bytes.size());
    return bytes.size() / sizeof(std::int32_t);
}

Descriptor MessageReader::descriptor() {
    if (taken_ >= message_.descriptors.size()) {
        missing_ = true;
        return Descriptor();
    }
    return std::move(message_.descriptors[taken_++]);
}

bool MessageReader::whole() const {
    return !missing_ && at_ == message_.bytes.size() && taken_ == message_.descriptors.size();
}

} // namespace tp
