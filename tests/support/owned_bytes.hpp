// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace tp::test {

/// Bytes that are their reader's own.
class OwnedBytes : public ByteSource {
public:
    explicit OwnedBytes(std::string bytes) : bytes_(std::move(bytes)) {}
    std::uint64_t size() const override { return bytes_.size(); }
    std::size_t read(std::uint64_t at, std::span<char> to) const override {
        return MemoryBytes(bytes_).read(at, to);
    }

private:
    std::string bytes_;
};

} // namespace tp::test
