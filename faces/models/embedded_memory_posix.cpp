// SPDX-License-Identifier: Apache-2.0
#include "faces/models/embedded_memory.hpp"

#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>

namespace tp {

void let_go_of_memory(const char* begin, const char* end) {
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
    const auto last = reinterpret_cast<std::uintptr_t>(end) / page * page;
    if (first < last)
        madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED); // failing, it costs memory only
}

} // namespace tp
