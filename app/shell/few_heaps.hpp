// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Keeps freed memory from piling up over hours (glibc): all threads share two heaps, where they would have
/// eight for each core, and what is larger than a megabyte, such as a picture, goes back to the system when
/// it is freed. In the last eight of `app.shell.soak`'s sixteen hours memory then grew by 4.3 MB an hour, and
/// by 7.2 without this.
void keep_few_heaps();

} // namespace tp
