// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"
#include "core/base/descriptor.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace tp {

/// Some bytes of a file that another process has opened. Their size is what that one says: this process may
/// not ask the system.
class HandedBytes final : public ByteSource {
public:
    HandedBytes(Descriptor file, std::int64_t begin, std::int64_t size)
        : file_(std::move(file)), begin_(begin), size_(size) {}

    std::uint64_t size() const override { return static_cast<std::uint64_t>(size_); }
    std::size_t read(std::uint64_t at, std::span<char> to) const override;

private:
    Descriptor file_;
    std::int64_t begin_;
    std::int64_t size_;
};

} // namespace tp
