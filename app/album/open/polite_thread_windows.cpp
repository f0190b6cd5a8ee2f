// SPDX-License-Identifier: Apache-2.0
#include "app/album/open/polite_thread.hpp"

#include <windows.h>

namespace tp {

void make_thread_polite() { SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_BELOW_NORMAL); }

} // namespace tp
