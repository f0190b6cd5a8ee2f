// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_device.hpp"

#include "app/parts/devices/fault_words.hpp"
#include "audio/sentences/sentences.hpp"

#include <memory>
#include <utility>

namespace tp {

namespace {
constexpr int sheet_settles_ms = 300; ///< a window that is moved or made larger tells of each step
}

ExploreDevice::ExploreDevice(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreTour& tour,
                             ExploreEar& ear, ExploreChoices& choices, ExploreWords& words,
                             const ExploreSettings& settings)
    : servo_(servo), view_(view), finger_(finger), tour_(tour), ear_(ear), choices_(choices), words_(words),
      servo_settings_(settings.device_servo), sheet_(view.frame()), connector_(settings.devices) {
    connect(&view_, &ExploreView::fresh, this, [this] {
        force_wanted_ = true;
        if (here())
            let_in();
        look();
    });
    connect(&connector_, &DeviceConnector::looked, this, &ExploreDevice::look);
    connect(&connector_, &DeviceConnector::opened, this,
            [this](const std::shared_ptr<OpenDevice>& open) { use(*open); });
    connect(&connector_, &DeviceConnector::refused, this, &ExploreDevice::refuse);
    sheet_settles_.setSingleShot(true);
    sheet_settles_.setInterval(sheet_settles_ms);
    connect(&sheet_settles_, &QTimer::timeout, this, &ExploreDevice::follow_sheet);
}

QString ExploreDevice::faultSentence() const {
    const QString why =
        faults_.shown() == Fault::motors_off ? in_persons_language(servo_.complaint()) : QString();
    return why.isEmpty() ? fault_words(faults_.shown()) : why;
}

// --- the force ---

void ExploreDevice::let_in() {
    servo_.engage();
    emit changed();
}

void ExploreDevice::enter() {
    want();
    if (view_.ready() && force_wanted_)
        let_in();
}

void ExploreDevice::leave() {
    force_wanted_ = engaged() || !view_.ready();
    disengage();
    give_back();
    state_ = State::Away;
}

void ExploreDevice::engage() {
    if (!view_.ready())
        return;
    ear_.listen();
    refused_.clear(); // where one was refused, it is asked again
    if (state_ == State::Awaited)
        state_ = State::Expected;
    let_in();
    words_.tell(servo_.by_touch() ? tr("Ticks are on.") : tr("The force is on."), Priority::touch);
    emit engage_asked();
    look();
}

void ExploreDevice::disengage() {
    servo_.disengage();
    emit changed();
}

void ExploreDevice::watch(Fault fault, double now) {
    const Fault shown = faults_.shown();
    const bool must_tell = faults_.must_tell(fault, now);
    if (disables(fault) && engaged())
        emit disabled();
    if (must_tell)
        words_.tell(Earcon::fault, faultSentence(), Priority::fault);
    if (faults_.must_tell_ready(now))
        words_.tell(engaged() ? tr("The device is ready. Its force is on.")
                              : tr("The device is ready. Its force is off. Press Enter to switch it on."),
                    Priority::message);
    if (faults_.shown() != shown)
        emit changed();
    if (fault == Fault::device_lost && state_ == State::InUse)
        lose();
}

// --- the device ---

/// The person wants one: it is looked for.
void ExploreDevice::want() {
    refused_.clear();
    if (state_ != State::InUse)
        state_ = State::Expected;
    connector_.watch(state_ != State::InUse);
}

void ExploreDevice::give_back() {
    connector_.watch(false);
    connector_.cancel();
    if (std::exchange(state_, State::Awaited) != State::InUse)
        return;
    connector_.release(servo_.use_simulated());
    emit in_use_changed();
}

/// Opens the device that the person wants as soon as there is something to feel.
void ExploreDevice::look() {
    if (!here() || !view_.ready() || state_ == State::InUse || connector_.opening() || !connector_.knows())
        return;
    const ListedDevice* device = device_for(connector_.there(), choices_.device());
    if (device == nullptr) {
        state_ = State::Awaited;
        refused_.clear();
        view_.reach({});
    } else if (device->name != refused_) {
        connector_.open(*device);
    }
}

void ExploreDevice::use(OpenDevice& open) {
    const bool at_once = state_ == State::Expected && engaged();
    if (tour_.touring())
        tour_.end_told();
    state_ = State::InUse;
    emit in_use_changed(); // ticks end
    ServoSettings servo = servo_settings_;
    const std::optional<Affine> calibrated =
        open.calibration ? sheet_.from_device(*open.calibration) : std::nullopt;
    servo.device_to_surface = calibrated.value_or(middle_on_middle(open.can));
    device_sheet_ = open.calibration ? std::optional(sheet_) : std::nullopt;
    about_ = in_persons_language(open.listed.about);
    faults_ = {}; // what was told of another, or before it was plugged in again, is told anew
    connector_.watch(false);
    connector_.release(servo_.use(std::make_unique<DeviceDrive>(std::move(open.device), open.can, servo)));
    finger_.take_handle();
    view_.reach(reach_of(open.can, servo.device_to_surface));
    ear_.lift();
    if (at_once)
        servo_.engage();
    emit changed();
    if (open.calibration && !calibrated)
        words_.tell(tr("The picture is too small or too large on the screen to be felt where it is seen. The "
                       "device feels it in its "
                       "true size."),
                    Priority::message);
    words_.tell(at_once ? tr("Device: %1. Its force is on.").arg(about_)
                        : tr("Device: %1. Its force is off. Press Enter to switch it on.").arg(about_),
                Priority::message);
}

void ExploreDevice::refuse(const QString& sentence) {
    state_ = State::Awaited;
    if (const ListedDevice* device = device_for(connector_.there(), choices_.device()))
        refused_ = device->name;
    words_.tell(Earcon::fault, tr("%1 Until then the force is only drawn.").arg(sentence), Priority::fault);
}

/// It was unplugged; where it comes back the person lets its force in.
void ExploreDevice::lose() {
    if (tour_.touring())
        tour_.end();
    give_back();
    ear_.lift();
    emit changed();
    connector_.watch(true);
}

// --- where the sheet lies ---

void ExploreDevice::sheetLies(double left, double top, double scale) {
    if (sheet_.lies(left, top, scale))
        sheet_settles_.start();
}

/// A device that lies on the screen feels the sheet where it lies now: it is opened anew with the new map.
void ExploreDevice::follow_sheet() {
    if (state_ != State::InUse || !device_sheet_ || *device_sheet_ == sheet_)
        return;
    const bool on = engaged();
    if (tour_.touring())
        tour_.end_told();
    give_back();
    if (on)
        servo_.engage();
    want();
}

} // namespace tp
