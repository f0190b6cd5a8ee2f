// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// From now on the calling thread gets a tenth of a busy core. Not the idle class: a thread that may be starved must hold no
/// lock of the database. Where the system cannot do that for one thread, nothing changes.
void make_thread_polite();

} // namespace tp
