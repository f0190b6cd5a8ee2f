// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/touch_access.hpp"

#include "app/parts/feedbackd/touch_outputs.hpp"
#include "device/usb/plug_watch.hpp"

#include <algorithm>
#include <utility>

namespace tp {

TouchAccess TouchAccess::of_this_computer(double width_mm, double height_mm,
                                          const std::shared_ptr<TickListener>& listener) {
    TouchAccess access;
    access.list = [] {
        std::vector<ListedTouchOutput> all = touch_outputs_here();
        all.push_back({drawn_touch_name, "drawn finger", {}, TouchMeans::friction, false});
        return all;
    };
    access.make = [width_mm, height_mm,
                   listener](const std::string& name) -> Result<std::unique_ptr<TouchOutput>> {
        if (name == drawn_touch_name)
            return std::unique_ptr<TouchOutput>(std::make_unique<DrawnTouch>(width_mm, height_mm, listener));
        return touch_output_here(name);
    };
    access.on_plug = [](std::function<void()> changed) {
        return std::make_shared<PlugWatch>(std::move(changed));
    };
    return access;
}

QString key_of(const ListedTouchOutput& output) {
    return QString::fromStdString(output.serial_number.empty() ? output.name : output.serial_number);
}

const ListedTouchOutput* touch_for(const std::vector<ListedTouchOutput>& there, const QString& key) {
    const auto chosen = std::find_if(there.begin(), there.end(),
                                     [&key](const ListedTouchOutput& one) { return key_of(one) == key; });
    if (chosen != there.end())
        return &*chosen;
    const auto under = std::find_if(there.begin(), there.end(), [](const ListedTouchOutput& one) {
        return one.means != TouchMeans::rumble; // of what may lie in a drawer
    });
    return under == there.end() ? nullptr : &*under;
}

} // namespace tp
