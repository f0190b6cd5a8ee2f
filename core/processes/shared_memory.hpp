// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/descriptor.hpp"

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
    Mapping& operator=(Mapping&& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        return *this;
    }

    void* data() const { return data_; }
    std::size_t size() const { return size_; } ///< bytes
    /// The process takes no memory for that part until it is looked at again; it holds what it held.
    void rest(std::size_t begin, std::size_t bytes) const;

private:
    void* data_;
    std::size_t size_;
};

/// Memory that can be handed to another process. Nobody can make it larger or smaller.
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

/// What another process has put into memory of its own, to be read. That process may still write to it: what
/// is read twice may be two different things. None where its size may still change, for then reading may end
/// this process: on Linux where it is not sealed, on Windows where it is a file's or not all of it is there. On
/// Windows it has whole pages.
std::optional<Mapping> received(const Descriptor& memory);

/// A file that is open for reading, whole, to be read. Where it becomes shorter meanwhile, looking at what is gone ends
/// this process, so this is for a helper. None where it is empty or the system has no room.
std::optional<Mapping> mapped_file(const Descriptor& file);

} // namespace tp
