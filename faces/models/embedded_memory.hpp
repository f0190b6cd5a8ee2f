// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Lets the system take back the memory of a file's bytes inside the program, which it reads again when they are wanted.
void let_go_of_memory(const char* begin, const char* end);

} // namespace tp
