// SPDX-License-Identifier: Apache-2.0
#include "app/shell/few_heaps.hpp"

#include <malloc.h>

namespace tp {

void keep_few_heaps() {
#ifdef __GLIBC__ // another library keeps few by itself
    // NOLINTBEGIN(concurrency-mt-unsafe): asked for before there are other threads
    mallopt(M_ARENA_MAX, 2);
    mallopt(M_MMAP_THRESHOLD, 1 << 20); // bytes; otherwise glibc raises it to 32 MB
    // NOLINTEND(concurrency-mt-unsafe)
#endif
}

} // namespace tp
