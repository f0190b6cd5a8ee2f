// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>

namespace tp {

/// What the system calls by what is open: a file descriptor, on Windows a HANDLE.
#if defined(_WIN32)
using DescriptorNumber = std::intptr_t;
#else
using DescriptorNumber = int;
#endif

/// Something open of the system's, such as a file or memory, that closes itself.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(DescriptorNumber number) : number_(number) {}
    ~Descriptor() { reset(); }
    Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        reset();
        number_ = other.release();
        return *this;
    }

    bool ok() const { return number_ >= 0; }
    DescriptorNumber number() const { return number_; }
    /// Closes it now.
    void reset();
    /// Its number, which is the caller's to close.
    DescriptorNumber release() { return std::exchange(number_, -1); }

private:
    DescriptorNumber number_ = -1;
};

} // namespace tp
