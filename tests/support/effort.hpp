// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace tp::test {

/// Of `count` > 0 things that take the same way through the program, how many a test tries: all. With a
/// sanitizer, which looks at that way, a quarter; what comes out is judged over all of them without.
std::size_t tried_of(std::size_t count);

} // namespace tp::test
