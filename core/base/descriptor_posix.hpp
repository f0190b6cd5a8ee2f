// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>
#include <utility>

namespace tp {

/// A POSIX file descriptor that closes itself.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { reset(); }
    Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        reset();
        number_ = other.release();
        return *this;
    }

    bool ok() const { return number_ >= 0; }
    int number() const { return number_; }
    /// Closes it now.
    void reset() {
        if (ok())
            ::close(release());
    }
    /// Its number, which is the caller's to close.
    int release() { return std::exchange(number_, -1); }

private:
    int number_ = -1;
};

} // namespace tp
