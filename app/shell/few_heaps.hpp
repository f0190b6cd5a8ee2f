// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Keeps freed memory from piling up over hours (glibc): all threads share two heaps, where they would have
/// eight for each core, and what is larger than a megabyte, such as a picture, goes back to the system when
/// it is freed. In `app.shell.soak` memory then stays at 200 MB from the fifth hour on; without this it was
/// 232 MB after sixteen hours and still grew.
void keep_few_heaps();

} // namespace tp
