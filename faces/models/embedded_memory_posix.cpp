// SPDX-License-Identifier: Apache-2.0
#include "faces/models/embedded_memory.hpp"

#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>

namespace tp {

void let_go_of_memory(const char* begin, const char* end) {
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const std::uintptr_t before = (page - reinterpret_cast<std::uintptr_t>(begin) % page) % page;
    const std::uintptr_t behind = reinterpret_cast<std::uintptr_t>(end) % page;
    const auto bytes = static_cast<std::uintptr_t>(end - begin);
    if (before + behind < bytes) // failing, it costs memory only
        madvise(const_cast<char*>(begin + before), bytes - before - behind, MADV_DONTNEED);
}

} // namespace tp
