// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Gives memory that was freed back to the system at once, where the C library would keep it (glibc).
void give_back_freed_memory();

} // namespace tp
