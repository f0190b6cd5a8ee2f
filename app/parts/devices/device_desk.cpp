// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/device_desk.hpp"

#include "audio/sentences/sentences.hpp"
#include "device/calibration_file.hpp"

#include <QMetaObject>

#include <utility>

namespace tp {

namespace {

constexpr int all_there_ms = 300; ///< after a device has come to the USB, its HID or serial node has too

} // namespace

DeviceDesk::DeviceDesk(DeviceAccess access) : access_(std::move(access)) {
    pool_.setMaxThreadCount(1);
    timer_.setInterval(access_.look_every_ms);
    connect(&timer_, &QTimer::timeout, this, &DeviceDesk::look);
    once_more_.setSingleShot(true);
    once_more_.setInterval(all_there_ms);
    connect(&once_more_, &QTimer::timeout, this, &DeviceDesk::look);
}

DeviceDesk::~DeviceDesk() { pool_.waitForDone(); }

void DeviceDesk::watch(bool on) {
    if (!access_.list || on == timer_.isActive())
        return;
    ++watched_;
    looking_ = look_again_ = knows_ = false;
    plugs_.reset();
    once_more_.stop();
    if (!on)
        return timer_.stop();
    timer_.start();
    if (access_.on_plug)
        plugs_ = access_.on_plug(
            [this] { QMetaObject::invokeMethod(this, &DeviceDesk::look_since_something_changed, Qt::QueuedConnection); });
    look();
}

void DeviceDesk::look_since_something_changed() {
    if (!timer_.isActive())
        return;
    once_more_.start();
    look_again_ = looking_;
    look();
}

void DeviceDesk::look() {
    if (looking_)
        return;
    looking_ = true;
    look_again_ = false;
    pool_.start([this, watch = watched_, list = access_.list] {
        std::vector<ListedDevice> found = list();
        std::erase_if(found, [](const ListedDevice& one) { return one.interface.empty(); }); // the simulated one
        QMetaObject::invokeMethod(this, [this, watch, found = std::move(found)]() mutable {
            if (watch != watched_)
                return;
            looking_ = false;
            knows_ = true;
            there_ = std::move(found);
            emit looked();
            if (look_again_)
                look();
        });
    });
}

void DeviceDesk::open(const ListedDevice& device) { begin(device, false); }
void DeviceDesk::home(const ListedDevice& device) { begin(device, true); }

void DeviceDesk::begin(const ListedDevice& listed, bool homes) {
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

void DeviceDesk::cancel() {
    ++wish_;
    opening_ = false;
}

void DeviceDesk::release(std::unique_ptr<DeviceDrive> drive) {
    if (drive)
        pool_.start([held = std::make_shared<std::unique_ptr<DeviceDrive>>(std::move(drive))] { held->reset(); });
}

} // namespace tp
