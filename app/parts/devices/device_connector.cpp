// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/device_connector.hpp"

#include "audio/sentences/sentences.hpp"
#include "device/calibration_file.hpp"

#include <QMetaObject>

#include <utility>

namespace tp {

DeviceConnector::DeviceConnector(DeviceAccess access)
    : access_(std::move(access)), plugs_(pool_, look(), access_.look_every_ms, access_.on_plug) {
    pool_.setMaxThreadCount(1);
}

DeviceConnector::~DeviceConnector() { pool_.waitForDone(); }

PlugLook::Look DeviceConnector::look() {
    if (!access_.list)
        return {};
    return [this, list = access_.list]() -> std::function<void()> {
        std::vector<ListedDevice> found = list();
        std::erase_if(found,
                      [](const ListedDevice& one) { return one.interface.empty(); }); // the simulated one
        return [this, found = std::move(found)] {
            there_ = found;
            emit looked();
        };
    };
}

void DeviceConnector::open(const ListedDevice& device) { begin(device, false); }
void DeviceConnector::home(const ListedDevice& device) { begin(device, true); }

void DeviceConnector::begin(const ListedDevice& listed, bool homes) {
    opening_ = true;
    pool_.start([this, homes, wish = ++wish_, listed, make = access_.make, file = access_.calibrations] {
        auto open = std::make_shared<OpenDevice>();
        open->listed = listed;
        QString problem;
        if (Result<std::unique_ptr<ForceDevice>> made = make(listed.name); !made) {
            problem = in_persons_language(made.error());
        } else {
            open->device = std::move(made).value();
            if (Result<Capabilities> can = open->device->open())
                open->can = std::move(can).value();
            else
                problem = in_persons_language(can.error());
        }
        if (homes) {
            if (problem.isEmpty())
                if (const Result<bool> homed = open->device->home(); !homed)
                    problem = in_persons_language(homed.error());
            open->device.reset();
        }
        if (!file.empty())
            open->calibration = kept_calibration(file, key_of(listed).toStdString());
        QMetaObject::invokeMethod(this, [this, homes, wish, problem, open] {
            if (wish != wish_)
                return pool_.start([open] { open->device.reset(); }); // giving it back may wait
            opening_ = false;
            if (!problem.isEmpty())
                emit refused(problem);
            else if (homes)
                emit homed();
            else
                emit opened(open);
        });
    });
}

void DeviceConnector::cancel() {
    ++wish_;
    opening_ = false;
}

void DeviceConnector::release(std::unique_ptr<DeviceDrive> drive) {
    if (drive)
        pool_.start(
            [held = std::make_shared<std::unique_ptr<DeviceDrive>>(std::move(drive))] { held->reset(); });
}

} // namespace tp
