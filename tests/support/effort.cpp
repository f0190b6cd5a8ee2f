// SPDX-License-Identifier: Apache-2.0
#include "effort.hpp"

#include <cstdlib>

namespace tp::test {

std::size_t tried_of(std::size_t count) {
#ifdef TP_SANITIZED
    return (count + 3) / 4;
#else
    return count;
#endif
}

std::vector<int> thirds() {
    const char* const turn = std::getenv("TP_TURN");
    return turn == nullptr || *turn == '\0' ? std::vector{0, 1, 2}
                                            : std::vector{std::abs(std::atoi(turn)) % 3};
}

bool is_long_run() { return thirds().front() == 0; }

} // namespace tp::test
