// SPDX-License-Identifier: Apache-2.0
#include "core/processes/shared_memory_linux.hpp"

#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/types.h>

namespace tp {
namespace {

constexpr int size_seals = F_SEAL_GROW | F_SEAL_SHRINK;

constexpr int nothing = -1;

std::optional<Mapping> mapped(int memory, std::size_t bytes, int sharing) {
    void* const data = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, sharing, memory, 0);
    return data == MAP_FAILED ? std::nullopt : std::optional<Mapping>(std::in_place, data, bytes);
}

} // namespace

Mapping::~Mapping() {
    if (data_ != nullptr)
        ::munmap(data_, size_);
}

std::optional<SharedMemory> SharedMemory::make(std::size_t bytes) {
    Descriptor descriptor(::memfd_create("touchphoto", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!descriptor.ok() || bytes == 0 || ::ftruncate(descriptor.number(), static_cast<off_t>(bytes)) != 0)
        return std::nullopt;
    std::optional<Mapping> mapping = mapped(descriptor.number(), bytes, MAP_SHARED);
    if (!mapping)
        return std::nullopt;
    return SharedMemory(std::move(descriptor), *std::move(mapping));
}

Descriptor SharedMemory::another() const {
    return Descriptor(::fcntl(descriptor_.number(), F_DUPFD_CLOEXEC, 0));
}

bool seal(const Descriptor& memory) {
    if (::fcntl(memory.number(), F_ADD_SEALS, size_seals) != 0)
        return false;
    ::fcntl(memory.number(), F_ADD_SEALS, F_SEAL_WRITE);
    return true;
}

std::optional<Mapping> received(const Descriptor& memory, std::size_t bytes) {
    const int seals = ::fcntl(memory.number(), F_GET_SEALS);
    if (seals < 0 || (seals & size_seals) != size_seals)
        return std::nullopt;
    const off_t size = ::lseek(memory.number(), 0, SEEK_END);
    if (bytes == 0 || size < 0 || static_cast<std::size_t>(size) < bytes)
        return std::nullopt;
    std::optional<Mapping> there = mapped(memory.number(), bytes, MAP_PRIVATE);
    if (!there || (seals & F_SEAL_WRITE) != 0)
        return there;
    std::optional<Mapping> copy = mapped(nothing, bytes, MAP_PRIVATE | MAP_ANONYMOUS);
    if (copy)
        std::memcpy(copy->data(), there->data(), bytes);
    return copy;
}

} // namespace tp
