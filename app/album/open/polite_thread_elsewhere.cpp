// SPDX-License-Identifier: Apache-2.0
#include "app/album/open/polite_thread.hpp"

namespace tp {

void make_thread_polite() {}

} // namespace tp
