// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor_posix.hpp"

#include <cstddef>
#include <optional>
#include <utility>

namespace tp {

/// Memory of this process's that is unmapped again.
class Mapping {
public:
    Mapping(void* data, std::size_t size) : data_(data), size_(size) {}
    ~Mapping();
    Mapping(Mapping&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
    Mapping& operator=(Mapping&&) = delete;

    void* data() const { return data_; }
    std::size_t size() const { return size_; } ///< bytes

private:
    void* data_;
    std::size_t size_;
};

/// Memory that can be handed to another process.
class SharedMemory {
public:
    /// Zeros. None where the system gives none.
    static std::optional<SharedMemory> make(std::size_t bytes);

    void* data() const { return mapping_.data(); }
    std::size_t size() const { return mapping_.size(); } ///< bytes
    /// A descriptor of the same memory, which lives as long as one of them or a view of it does.
    Descriptor another() const;

private:
    SharedMemory(Descriptor descriptor, Mapping mapping)
        : descriptor_(std::move(descriptor)), mapping_(std::move(mapping)) {}

    Descriptor descriptor_;
    Mapping mapping_;
};

/// From now on nobody can make the memory larger or smaller, nor, where the system allows it, write to it:
/// not while a SharedMemory of it lives, and sometimes not for a moment longer. False where not even its size
/// can be sealed.
bool seal(const Descriptor& memory);

/// What another process has put into the memory, as it is now: nobody changes it while it is read, and what
/// is written to it is seen by nobody else. What is sealed is not copied. None where its size is not sealed,
/// or is less than so many `bytes`.
std::optional<Mapping> received(const Descriptor& memory, std::size_t bytes);

} // namespace tp
