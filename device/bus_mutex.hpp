// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>

namespace tp {

/// One look at the buses or opening of a device at a time: hidapi's own set-up and its list are not made for
/// two threads.
inline std::mutex& bus_mutex() {
    static std::mutex mutex;
    return mutex;
}

} // namespace tp
