// SPDX-License-Identifier: Apache-2.0
#include "video_node.hpp"

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace tp::vm {

VideoNode::VideoNode(const char* path) : file_(open(path, O_RDWR | O_CLOEXEC)) {}

VideoNode::~VideoNode() {
    if (good())
        close(file_);
}

bool VideoNode::set(const std::string& control, int value) const {
    v4l2_queryctrl asked{};
    asked.id = V4L2_CTRL_FLAG_NEXT_CTRL;
    while (ioctl(file_, VIDIOC_QUERYCTRL, &asked) == 0) {
        if (reinterpret_cast<const char*>(asked.name) == control) {
            v4l2_control set{asked.id, value};
            return ioctl(file_, VIDIOC_S_CTRL, &set) == 0;
        }
        asked.id |= V4L2_CTRL_FLAG_NEXT_CTRL;
    }
    return false;
}

bool VideoNode::occupy() const {
    v4l2_requestbuffers buffers{};
    buffers.count = 2;
    buffers.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffers.memory = V4L2_MEMORY_MMAP;
    return ioctl(file_, VIDIOC_REQBUFS, &buffers) == 0;
}

} // namespace tp::vm
