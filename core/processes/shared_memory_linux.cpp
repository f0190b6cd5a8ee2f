// SPDX-License-Identifier: Apache-2.0
#include "core/processes/shared_memory.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/types.h>
#include <unistd.h>

namespace tp {
namespace {

constexpr int size_seals = F_SEAL_GROW | F_SEAL_SHRINK;

std::optional<Mapping> mapped(const Descriptor& memory, std::size_t bytes, int access) {
    void* const data = ::mmap(nullptr, bytes, access, MAP_SHARED, memory.number(), 0);
    return data == MAP_FAILED ? std::nullopt : std::optional<Mapping>(std::in_place, data, bytes);
}

} // namespace

Mapping::~Mapping() {
    if (data_ != nullptr)
        ::munmap(data_, size_);
}

void Mapping::rest(std::size_t begin, std::size_t bytes) const {
    static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    const std::size_t first = begin / page * page; // what lies before in that page is looked at again
    if (begin + bytes <= size_)
        ::madvise(static_cast<char*>(data_) + first, begin + bytes - first, MADV_DONTNEED);
}

std::optional<SharedMemory> SharedMemory::make(std::size_t bytes) {
    Descriptor descriptor(::memfd_create("touchphoto", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!descriptor.ok() || bytes == 0 || ::ftruncate(descriptor.number(), static_cast<off_t>(bytes)) != 0 ||
        ::fcntl(descriptor.number(), F_ADD_SEALS, size_seals) != 0)
        return std::nullopt;
    std::optional<Mapping> mapping = mapped(descriptor, bytes, PROT_READ | PROT_WRITE);
    if (!mapping)
        return std::nullopt;
    return SharedMemory(std::move(descriptor), *std::move(mapping));
}

Descriptor SharedMemory::another() const {
    return Descriptor(::fcntl(descriptor_.number(), F_DUPFD_CLOEXEC, 0));
}

std::optional<Mapping> received(const Descriptor& memory) {
    const int seals = ::fcntl(memory.number(), F_GET_SEALS);
    const off_t size = ::lseek(memory.number(), 0, SEEK_END);
    if (seals < 0 || (seals & size_seals) != size_seals || size <= 0)
        return std::nullopt;
    return mapped(memory, static_cast<std::size_t>(size), PROT_READ);
}

std::optional<Mapping> mapped_file(const Descriptor& file) {
    const off_t size = ::lseek(file.number(), 0, SEEK_END);
    return size > 0 ? mapped(file, static_cast<std::size_t>(size), PROT_READ) : std::nullopt;
}

} // namespace tp
