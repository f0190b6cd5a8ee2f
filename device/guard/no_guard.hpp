// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

namespace tp {

/// Why a device stays off that nothing would watch over.
Error nobody_to_watch();
Error guard_is_missing();
Error guard_does_not_start();
Error no_room_for_guard();

} // namespace tp
