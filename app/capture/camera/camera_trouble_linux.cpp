// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/camera_trouble.hpp"
#include "core/files/first_line.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <optional>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> nodes_in(const fs::path& devices) {
    std::vector<fs::path> nodes;
    std::error_code failed;
    fs::directory_iterator entry(devices, failed);
    for (; !failed && entry != fs::directory_iterator(); entry.increment(failed))
        if (entry->path().filename().string().starts_with("video"))
            nodes.push_back(entry->path());
    return nodes;
}

int open_node(const fs::path& node) { return open(node.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC); }

/// What the driver says of the device; nothing where it may not be asked.
std::optional<v4l2_capability> capability_of(const fs::path& node) {
    const int camera = open_node(node);
    if (camera < 0)
        return std::nullopt;
    v4l2_capability capability{};
    const bool answered = ioctl(camera, VIDIOC_QUERYCAP, &capability) == 0;
    close(camera);
    return answered ? std::optional(capability) : std::nullopt;
}

/// By the name of the device, or of this one of its nodes: listed is the one with some drivers, the other with others. A node
/// of the same name that gives no pictures, but what is known of them, is another.
bool is_called(const fs::path& node, const std::string& name, const fs::path& names) {
    const auto capability = capability_of(node);
    if (capability && !(capability->device_caps & (V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_VIDEO_CAPTURE_MPLANE)))
        return false;
    if (capability) {
        const auto* const card = reinterpret_cast<const char*>(capability->card);
        if (name == std::string(card, strnlen(card, sizeof capability->card)))
            return true;
    }
    return !name.empty() && first_line(names / node.filename() / "name") == name;
}

/// Nothing where it can be opened and nobody else streams from it.
std::optional<CameraTrouble> trouble_with(const fs::path& node) {
    const int camera = open_node(node);
    if (camera < 0)
        return trouble_of(errno);
    v4l2_requestbuffers none{};
    none.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    none.memory = V4L2_MEMORY_MMAP;
    const bool busy = ioctl(camera, VIDIOC_REQBUFS, &none) < 0 && errno == EBUSY;
    close(camera);
    return busy ? std::optional(CameraTrouble::in_use) : std::nullopt;
}

} // namespace

CameraTrouble trouble_of(int error) {
    switch (error) {
    case EACCES:
    case EPERM:
        return CameraTrouble::denied;
    case EBUSY:
        return CameraTrouble::in_use;
    case ENOENT:
    case ENODEV:
    case ENXIO:
        return CameraTrouble::unplugged;
    default:
        return CameraTrouble::silent;
    }
}

CameraTrouble why_none(const CameraPlaces& places) {
    for (const fs::path& node : nodes_in(places.devices))
        if (trouble_with(node) == CameraTrouble::denied)
            return CameraTrouble::denied;
    return CameraTrouble::none_there;
}

CameraTrouble why_silent(const std::string& name, bool gave, const CameraPlaces& places) {
    bool there = false;
    for (const fs::path& node : nodes_in(places.devices)) {
        if (!is_called(node, name, places.names))
            continue;
        there = true;
        const std::optional<CameraTrouble> trouble = trouble_with(node);
        // Where it gave pictures it is this program that streams from it.
        if (trouble && !(gave && trouble == CameraTrouble::in_use))
            return *trouble;
    }
    return there ? CameraTrouble::silent : CameraTrouble::unplugged;
}

} // namespace tp
