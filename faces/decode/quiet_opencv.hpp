// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Sets OpenCV up for this program, once: no log lines, and one thread, so that sums are taken in one order
/// and the same bytes give the same contours. For the whole process.
void quiet_opencv();

/// While it lives, nothing of the calling thread reaches std::cerr: OpenCV's decoders write there about files
/// that this program describes in a sentence of its own. After quiet_opencv.
class HushedThread {
public:
    HushedThread();
    ~HushedThread();
    HushedThread(const HushedThread&) = delete;
    HushedThread& operator=(const HushedThread&) = delete;

private:
    bool before_;
};

} // namespace tp
