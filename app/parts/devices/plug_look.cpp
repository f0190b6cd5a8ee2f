// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/plug_look.hpp"

#include <QMetaObject>

#include <utility>

namespace tp {

namespace {

constexpr int all_there_ms = 300; ///< after a device has come to the USB, its HID or serial node has too

} // namespace

PlugLook::PlugLook(QThreadPool& pool, Look look, int every_ms, OnPlug on_plug)
    : pool_(pool), look_(std::move(look)), on_plug_(std::move(on_plug)) {
    timer_.setInterval(every_ms);
    connect(&timer_, &QTimer::timeout, this, &PlugLook::look);
    once_more_.setSingleShot(true);
    once_more_.setInterval(all_there_ms);
    connect(&once_more_, &QTimer::timeout, this, &PlugLook::look);
}

void PlugLook::watch(bool on) {
    if (!look_ || on == timer_.isActive())
        return;
    ++watched_;
    looking_ = look_again_ = knows_ = false;
    plugs_.reset();
    once_more_.stop();
    if (!on)
        return timer_.stop();
    timer_.start();
    if (on_plug_)
        plugs_ = on_plug_([this] {
            QMetaObject::invokeMethod(this, &PlugLook::look_since_something_changed, Qt::QueuedConnection);
        });
    look();
}

void PlugLook::look_since_something_changed() {
    if (!timer_.isActive())
        return;
    once_more_.start();
    look_again_ = looking_;
    look();
}

void PlugLook::look() {
    if (looking_)
        return;
    looking_ = true;
    look_again_ = false;
    pool_.start([this, watch = watched_, look = look_] {
        QMetaObject::invokeMethod(this, [this, watch, seen = look()] {
            if (watch != watched_)
                return;
            looking_ = false;
            knows_ = true;
            seen();
            if (look_again_)
                this->look();
        });
    });
}

} // namespace tp
