// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Sets OpenCV up for this program, once: no log lines, and one thread, so that sums are taken in one order
/// and the same bytes give the same contours. For the whole process.
void quiet_opencv();

} // namespace tp
