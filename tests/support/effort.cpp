// SPDX-License-Identifier: Apache-2.0
#include "effort.hpp"

namespace tp::test {

std::size_t tried_of(std::size_t count) {
#ifdef TP_SANITIZED
    return (count + 3) / 4;
#else
    return count;
#endif
}

} // namespace tp::test
