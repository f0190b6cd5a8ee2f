// SPDX-License-Identifier: Apache-2.0
#include "core/base/descriptor.hpp"

#include <windows.h>

namespace tp {

void Descriptor::reset() {
    if (ok())
        CloseHandle(reinterpret_cast<HANDLE>(release()));
}

} // namespace tp
