// SPDX-License-Identifier: Apache-2.0
#include "core/processes/shared_memory.hpp"

#include <cstdint>
#include <windows.h>
#include <winternl.h>

extern "C" NTSTATUS NTAPI NtQuerySection(HANDLE section, int what, void* into, SIZE_T size, SIZE_T* written);

namespace tp {
namespace {

/// What NtQuerySection says first of a piece of memory; no header has it.
struct BasicFacts {
    void* at;
    ULONG kind; ///< as it was made: SEC_COMMIT, SEC_RESERVE, SEC_FILE, …
    LARGE_INTEGER bytes;
};

HANDLE handle_of(const Descriptor& memory) { return reinterpret_cast<HANDLE>(memory.number()); }

/// Whether all of it was there from the beginning, and it belongs to no file.
bool lasts(const Descriptor& memory) {
    BasicFacts facts{};
    return NtQuerySection(handle_of(memory), 0, &facts, sizeof facts, nullptr) >= 0 &&
           facts.kind == SEC_COMMIT;
}

} // namespace

void Mapping::rest(std::size_t, std::size_t) const {} // pages of a section come and go as the system likes

Mapping::~Mapping() {
    if (data_ != nullptr)
        UnmapViewOfFile(data_);
}

std::optional<SharedMemory> SharedMemory::make(std::size_t bytes) {
    const auto size = std::uint64_t{bytes};
    const HANDLE made = CreateFileMappingW(INVALID_HANDLE_VALUE, nullptr, PAGE_READWRITE | SEC_COMMIT,
                                           static_cast<DWORD>(size >> 32), static_cast<DWORD>(size), nullptr);
    if (made == nullptr) // for no bytes too
        return std::nullopt;
    Descriptor descriptor(reinterpret_cast<DescriptorNumber>(made));
    void* const data = MapViewOfFile(made, FILE_MAP_READ | FILE_MAP_WRITE, 0, 0, bytes);
    if (data == nullptr)
        return std::nullopt;
    return SharedMemory(std::move(descriptor), Mapping(data, bytes));
}

Descriptor SharedMemory::another() const {
    HANDLE made = nullptr;
    DuplicateHandle(GetCurrentProcess(), handle_of(descriptor_), GetCurrentProcess(), &made, 0, FALSE,
                    DUPLICATE_SAME_ACCESS);
    return made == nullptr ? Descriptor() : Descriptor(reinterpret_cast<DescriptorNumber>(made));
}

std::optional<Mapping> received(const Descriptor& memory) {
    void* const data = lasts(memory) ? MapViewOfFile(handle_of(memory), FILE_MAP_READ, 0, 0, 0) : nullptr;
    if (data == nullptr)
        return std::nullopt;
    MEMORY_BASIC_INFORMATION pages{};
    VirtualQuery(data, &pages, sizeof pages);
    Mapping mapping(data, pages.RegionSize);
    return pages.State == MEM_COMMIT ? std::optional(std::move(mapping)) : std::nullopt;
}

std::optional<Mapping> mapped_file(const Descriptor& file) {
    LARGE_INTEGER size{};
    if (!GetFileSizeEx(handle_of(file), &size))
        return std::nullopt;
    const HANDLE made = CreateFileMappingW(handle_of(file), nullptr, PAGE_READONLY, 0, 0, nullptr);
    if (made == nullptr) // of an empty file too
        return std::nullopt;
    const Descriptor section(reinterpret_cast<DescriptorNumber>(made));
    void* const data = MapViewOfFile(made, FILE_MAP_READ, 0, 0, 0);
    return data == nullptr
               ? std::nullopt
               : std::optional<Mapping>(std::in_place, data, static_cast<std::size_t>(size.QuadPart));
}

} // namespace tp
