// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string_view>

namespace tp::test {

/// Bytes on a disk that dies: from the read `at` on, counted from 0, it gives half of what is asked, then nothing.
class FailingBytes : public ByteSource {
public:
    FailingBytes(std::string_view bytes, int at) : bytes_(bytes), left_(at) {}

    std::uint64_t size() const override { return bytes_.size(); }
    std::size_t read(std::uint64_t at, std::span<char> to) const override {
        if (left_-- > 0)
            return bytes_.read(at, to);
        fault_ = EIO;
        return left_ < -1 ? 0 : bytes_.read(at, to.first(to.size() / 2));
    }
    int fault() const override { return fault_; }

private:
    MemoryBytes bytes_;
    mutable int left_;
    mutable int fault_ = 0;
};

/// Lets `look` have the bytes on disks that fail earlier and earlier, a few of them; it must come to an end.
template <typename Look>
void on_failing_disks(std::string_view bytes, Look look) {
    constexpr int reads = 12;
    for (int at = 0; at < reads; ++at)
        look(FailingBytes(bytes, at));
}

} // namespace tp::test
