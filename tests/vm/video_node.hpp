// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tp::vm {

/// A node of the kernel's test camera (vivid), as another program has it open: its faults are pressed here, and whoever
/// streams from it keeps everybody else from doing so.
class VideoNode {
public:
    explicit VideoNode(const char* path);
    ~VideoNode();
    VideoNode(const VideoNode&) = delete;
    VideoNode& operator=(const VideoNode&) = delete;

    bool good() const { return file_ >= 0; }
    /// Sets the control of this name ("Disconnect", "Percentage of Dropped Buffers"); false where there is none.
    bool set(const std::string& control, int value) const;
    /// Takes buffers, as a program that is about to stream; false where somebody else has them.
    bool occupy() const;

private:
    int file_;
};

} // namespace tp::vm
