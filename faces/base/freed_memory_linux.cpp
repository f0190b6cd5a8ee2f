// SPDX-License-Identifier: Apache-2.0
#include "faces/base/freed_memory.hpp"

#include <malloc.h>

namespace tp {

void give_back_freed_memory() {
#ifdef __GLIBC__ // another library gives it back by itself
    malloc_trim(0);
#endif
}

} // namespace tp
