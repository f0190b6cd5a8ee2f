// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes Exiv2 usable from several threads, silent, and able to open HEIC. Before any other use of Exiv2, as
/// often as one likes, from any thread.
void prepare_exiv2();

} // namespace tp
