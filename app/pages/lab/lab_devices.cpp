// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_devices.hpp"

#include "audio/sentences/sentences.hpp"

#include <algorithm>
#include <stop_token>
#include <string>
#include <utility>

namespace tp {

LabDevices::LabDevices(Find find, LabActivity& activity, LabTeller& teller)
    : activity_(activity), teller_(teller),
      find_(std::move(find)), found_{{simulated_device_name, {}, {}, {}}} {}

QStringList LabDevices::names() const {
    QStringList names{tr("Simulated: the mouse or a finger on the screen")};
    for (std::size_t i = 1; i < found_.size(); ++i)
        names << tr("%1, %2").arg(in_persons_language(found_[i].about),
                                  QString::fromStdString(found_[i].name));
    return names;
}

void LabDevices::find() {
    if (activity_.opening() || !find_)
        return;
    work_.ask([this, find = find_](const std::stop_token&) -> LatestTask::Answer {
        return [this, found = find()] {
            const std::string used = found_[static_cast<std::size_t>(current_)].name;
            found_ = {{simulated_device_name, {}, {}, {}}};
            for (const ListedDevice& one : found)
                if (one.name != simulated_device_name)
                    found_.push_back(one);
            const auto same = std::find_if(found_.begin(), found_.end(),
                                           [&](const ListedDevice& one) { return one.name == used; });
            if (same == found_.end())
                activity_.stop();
            current_ = same == found_.end() ? 0 : static_cast<int>(same - found_.begin());
            emit changed();
        };
    });
}

void LabDevices::choose(int index) {
    if (index < 0 || index >= static_cast<int>(found_.size()) || index == current_)
        return;
    activity_.stop();
    current_ = index;
    emit changed();
    teller_.tell(name() + '.');
}

void LabDevices::open(const std::filesystem::path& recording, const SurfaceSize& surface,
                      const LabParameters& parameters, Clock& clock, const Opened& then) {
    const DeviceChain::Wish wish{found_[static_cast<std::size_t>(current_)].name, recording};
    if (simulated())
        return then(DeviceChain::open(wish, surface, parameters, clock));
    work_.ask([wish, surface, parameters, &clock, then](const std::stop_token&) -> LatestTask::Answer {
        auto chain = std::make_shared<Result<std::shared_ptr<DeviceChain>>>(
            DeviceChain::open(wish, surface, parameters, clock));
        return [chain, then] { then(*chain); };
    });
}

} // namespace tp
