// SPDX-License-Identifier: Apache-2.0
// The device of an ExploreSession: found, opened and given back while the page is in sight.
#include "app/pages/explore/explore_session.hpp"

#include "audio/sentences/sentences.hpp"

#include <utility>

namespace tp {

namespace {
constexpr double least_stretch = 0.5; ///< from the screen's millimetres to the sheet's
constexpr double most_stretch = 1.5;  ///< 0.2 N/mm becomes 0.45 N/mm, for which the damping near a line suffices
} // namespace

QString ExploreSession::faultSentence() const {
    const QString why = faults_.shown() == Fault::motors_off ? in_persons_language(servo_.complaint()) : QString();
    return why.isEmpty() ? fault_words(faults_.shown()) : why;
}

QString ExploreSession::deviceName() const { return servo_.real() ? device_about_ : QString(); }

/// The page has come into sight.
void ExploreSession::want_device() {
    refused_.clear();
    device_expected_ = true;
    desk_.watch(!servo_.real());
}

void ExploreSession::leave_device() {
    desk_.watch(false);
    desk_.cancel();
    if (servo_.real())
        desk_.release(servo_.use_simulated());
}

/// Opens the device that the person wants as soon as there is something to feel.
void ExploreSession::devices_seen() {
    if (!here_ || state_ != State::Ready || servo_.real() || desk_.opening() || !desk_.knows())
        return;
    const ListedDevice* device = device_for(desk_.there(), preferences_.choices().device);
    if (device == nullptr) {
        device_expected_ = false;
        refused_.clear();
        fit_to_reach({});
    } else if (device->name != refused_) {
        desk_.open(*device);
    }
}

void ExploreSession::sheetLies(double left, double top, double scale) {
    if (!(scale > 0.0))
        return;
    const Vec2 middle = Vec2(left, -top) + scale * 0.5 * Vec2(frame_.width_mm, -frame_.height_mm);
    screen_to_surface_ = {glm::dmat2(1.0 / scale), -middle / scale};
    sheet_settles_.start();
}

/// A device that lies on the screen feels the sheet where it lies now: it is opened anew with the new map.
void ExploreSession::follow_sheet() {
    const bool still = device_sheet_ && device_sheet_->linear == screen_to_surface_.linear &&
                       device_sheet_->offset == screen_to_surface_.offset;
    if (!here_ || !servo_.real() || !device_sheet_ || still)
        return;
    const bool on = engaged();
    leave_device();
    if (on)
        servo_.engage();
    want_device();
}

/// Device → surface for a device that lies on the screen; nothing where the sheet is drawn so small or large that its
/// stiffness, which the map changes by its square, would be another thing.
std::optional<Affine> ExploreSession::on_the_sheet(const Calibration& calibration) const {
    const double real_mm = 1.0 / screen_to_surface_.linear[0].x;
    if (real_mm < 1.0 / most_stretch || real_mm > 1.0 / least_stretch)
        return std::nullopt;
    return compose(screen_to_surface_, calibration.device_to_surface);
}

/// The photograph is laid where the device reaches all that is felt; without a device over the whole sheet.
void ExploreSession::fit_to_reach(std::vector<Vec2> reach) {
    if (reach == settings_.surface.reach)
        return;
    settings_.surface.reach = std::move(reach);
    if (state_ == State::Ready)
        build(false);
}

void ExploreSession::use_device(OpenDevice& open) {
    const bool at_once = device_expected_ && engaged();
    device_expected_ = false;
    if (touring())
        end_tour(tr("Tour ended."));
    ServoSettings servo = settings_.device_servo;
    const std::optional<Affine> calibrated = open.calibration ? on_the_sheet(*open.calibration) : std::nullopt;
    servo.device_to_surface = calibrated.value_or(middle_on_middle(open.can));
    device_sheet_ = open.calibration ? std::optional(screen_to_surface_) : std::nullopt;
    device_about_ = in_persons_language(open.listed.about);
    device_was_at_ = {};
    faults_ = {}; // what was told of another, or before it was plugged in again, is told anew
    desk_.watch(false);
    desk_.release(servo_.use(std::make_unique<DeviceDrive>(std::move(open.device), open.can, servo)));
    fit_to_reach(reach_of(open.can, servo.device_to_surface));
    lift();
    if (at_once)
        servo_.engage();
    emit modeChanged();
    if (open.calibration && !calibrated)
        tell(tr("The picture is too small or too large on the screen to be felt where it is seen. The device feels it in its "
                "true size."),
             Priority::message);
    tell(at_once ? tr("Device: %1. Its force is on.").arg(device_about_)
                 : tr("Device: %1. Its force is off. Press Enter to switch it on.").arg(device_about_),
         Priority::message);
}

void ExploreSession::device_refused(const QString& sentence) {
    device_expected_ = false;
    if (const ListedDevice* device = device_for(desk_.there(), preferences_.choices().device))
        refused_ = device->name;
    earcons_.play(Earcon::fault);
    tell(tr("%1 Until then the force is only drawn.").arg(sentence), Priority::fault);
}

/// It was unplugged; where it comes back the person lets its force in.
void ExploreSession::device_gone() {
    desk_.release(servo_.use_simulated());
    device_expected_ = false;
    lift();
    emit modeChanged();
    desk_.watch(true);
}

} // namespace tp
