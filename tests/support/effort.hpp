// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace tp::test {

/// Of `count` > 0 things that take the same way through the program, how many a test tries: all. With a
/// sanitizer, which looks at that way, a quarter; what comes out is judged over all of them without.
std::size_t tried_of(std::size_t count);

/// Of what is tried in thirds, those (0 … 2) that this run tries: all, or, where the number TP_TURN is set, the
/// one whose turn it is.
std::vector<int> thirds();

/// Whether this run is as long as can be: always, or, where TP_TURN is set, at every third turn.
bool is_long_run();

} // namespace tp::test
