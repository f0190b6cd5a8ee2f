// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/touch_access.hpp"

#include "app/parts/feedbackd/touch_outputs.hpp"
#include "device/touch_output/force_feedback/motor_file.hpp"
#include "device/usb/plug_watch.hpp"

#include <algorithm>
#include <string_view>
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

TouchAccess TouchAccess::with_motor_file(const std::filesystem::path& file) const {
    TouchAccess access = *this;
    access.list = [file, others = list] {
        std::vector<ListedTouchOutput> all;
        for (const PluggedTouchOutput& motor : plugged_motor_file(file))
            all.push_back(
                {motor.name, motor.about, motor.serial_number, motor.means, motor.is_pad, motor.delay});
        const std::vector<ListedTouchOutput> more = others();
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    access.make = [file, others = make](const std::string& name) -> Result<std::unique_ptr<TouchOutput>> {
        for (const PluggedTouchOutput& motor : plugged_motor_file(file))
            if (motor.name == name)
                return motor.make();
        return others(name);
    };
    return access;
}

std::optional<std::filesystem::path> motor_file_named(const std::string& wish) {
    constexpr std::string_view simulated = "simulated:";
    if (!wish.starts_with(simulated) || wish.size() == simulated.size())
        return std::nullopt;
    return wish.substr(simulated.size());
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
