// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/device_drive.hpp"

#include <glm/common.hpp>

#include <utility>

namespace tp {

namespace {

ServoSettings at_rate(ServoSettings settings, double rate) {
    settings.rate = rate;
    return settings;
}

} // namespace

DeviceDrive::DeviceDrive(std::unique_ptr<ForceDevice> device, const Capabilities& can, ServoSettings settings,
                         Clock* clock)
    : device_(std::move(device)),
      loop_(*device_, can, clock != nullptr ? *clock : own_clock_, at_rate(settings, can.rate)) {}

std::vector<Vec2> reach_of(const Capabilities& can, const Affine& device_to_surface) {
    std::vector<Vec2> reach;
    for (const Vec2 corner : can.workspace)
        reach.push_back(device_to_surface(corner));
    return reach;
}

Affine middle_on_middle(const Capabilities& can) {
    if (can.workspace.empty())
        return {};
    Rect reach{can.workspace.front(), can.workspace.front()};
    for (const Vec2 corner : can.workspace)
        reach = {glm::min(reach.min, corner), glm::max(reach.max, corner)};
    return {glm::dmat2(1.0), -reach.centre()};
}

} // namespace tp
