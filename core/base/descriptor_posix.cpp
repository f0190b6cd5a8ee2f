// SPDX-License-Identifier: Apache-2.0
#include "core/base/descriptor.hpp"

#include <unistd.h>

namespace tp {

void Descriptor::reset() {
    if (ok())
        ::close(release());
}

} // namespace tp
