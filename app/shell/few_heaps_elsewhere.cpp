// SPDX-License-Identifier: Apache-2.0
#include "app/shell/few_heaps.hpp"

namespace tp {

void keep_few_heaps() {}

} // namespace tp
