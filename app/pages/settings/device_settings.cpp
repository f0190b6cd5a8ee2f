// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/device_settings.hpp"

#include "app/parts/devices/fault_words.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/geometry/calibration.hpp"
#include "core/guidance/haptic_scene.hpp"
#include "device/calibration_file.hpp"
#include "device/hid_pid/joystick_scale_file.hpp"

#include <QLocale>

#include <utility>

namespace tp {

namespace {

constexpr int device_poll_ms = 16;
constexpr double fault_lasts_s = 0.5; ///< one that heals sooner is not told
constexpr double pull_mm = 4.0;       ///< from the finger to the line that pulls it: where the tent is strongest

QString in_millimetres(double mm) { return QLocale().toString(mm, 'f', 1); }

} // namespace

DeviceSettings::DeviceSettings(Narrator& narrator, Preferences& preferences, Setup setup)
    : narrator_(narrator), preferences_(preferences), setup_(std::move(setup)), connector_(setup_.access) {
    clock_.start();
    timer_.setInterval(device_poll_ms);
    connect(&timer_, &QTimer::timeout, this, &DeviceSettings::poll);
    connect(&preferences_, &Preferences::changed, this, &DeviceSettings::changed);
    connect(&connector_, &DeviceConnector::looked, this, &DeviceSettings::changed);
    connect(&connector_, &DeviceConnector::opened, this,
            [this](const std::shared_ptr<OpenDevice>& open) { opened(*open); });
    connect(&connector_, &DeviceConnector::homed, this,
            [this] { end(tr("The device is homed: it knows where its handle is.")); });
    connect(&connector_, &DeviceConnector::refused, this,
            [this](const QString& sentence) { end(sentence, Priority::fault); });
}

double DeviceSettings::now() const {
    return setup_.now ? setup_.now() : 1e-9 * static_cast<double>(clock_.nsecsElapsed());
}

// --- which there are ---

const ListedDevice* DeviceSettings::serving() const {
    return device_for(connector_.there(), preferences_.choices().device);
}

QString DeviceSettings::name_of(const ListedDevice& device) const {
    const QString name = (in_persons_language(device.about) + ' ' + QString::fromStdString(device.serial_number)).trimmed();
    if (device.interface == "hid")
        return tr("%1, over USB (HID)").arg(name);
    if (device.interface == "bulk")
        return tr("%1, over USB (bulk)").arg(name);
    return name;
}

QStringList DeviceSettings::names() const {
    QStringList names{tr("None: sound, and a drawn finger")};
    for (const ListedDevice& one : connector_.there())
        names << name_of(one);
    const QString& chosen = preferences_.choices().device;
    if (!chosen.isEmpty() && key_at(current()) != chosen)
        names << tr("%1, not plugged in").arg(chosen);
    return names;
}

int DeviceSettings::current() const {
    const ListedDevice* device = serving();
    return device == nullptr ? 0 : static_cast<int>(device - connector_.there().data()) + 1;
}

std::optional<QString> DeviceSettings::key_at(int index) const {
    if (index == 0)
        return no_device_key;
    const auto place = static_cast<std::size_t>(index) - 1;
    return index > 0 && place < connector_.there().size() ? std::optional(key_of(connector_.there()[place]))
                                                          : std::nullopt;
}

QString DeviceSettings::calibration() const {
    const ListedDevice* device = serving();
    if (device == nullptr)
        return {};
    const auto kept = setup_.access.calibrations.empty()
                          ? std::nullopt
                          : kept_calibration(setup_.access.calibrations, key_of(*device).toStdString());
    return kept ? tr("Calibrated: misses by %1 millimetres on average.").arg(in_millimetres(kept->residual_mm))
                : tr("Not calibrated. It may stand beside the screen; to lie on it, it must be calibrated.");
}

void DeviceSettings::enter() { connector_.watch(true); }

void DeviceSettings::leave() {
    end({});
    connector_.watch(false);
}

// --- what is done with one ---

void DeviceSettings::begin(Doing what) {
    if (doing_ != Doing::nothing)
        return;
    const ListedDevice* device = serving();
    if (device == nullptr)
        return narrator_.tell(
            connector_.there().empty()
                ? tr("No force device is plugged in. Plug one in; it is found automatically.")
                : tr("No force device is chosen. Choose one above."),
            Priority::touch);
    doing_ = what;
    key_ = key_of(*device);
    scale_key_ = device->scale_key;
    const ListedDevice wish = *device;
    connector_.watch(false);
    if (what == Doing::homing)
        connector_.home(wish);
    else
        connector_.open(wish);
}

void DeviceSettings::tryForce() { begin(Doing::opening_to_try); }
void DeviceSettings::calibrate() { begin(Doing::opening_to_calibrate); }
void DeviceSettings::home() { begin(Doing::homing); }
void DeviceSettings::measure() {
    if (serving() != nullptr && !measurable())
        return narrator_.tell(tr("This device knows its own force; only force sticks need measuring."),
                              Priority::touch);
    begin(Doing::opening_to_measure);
}

void DeviceSettings::opened(OpenDevice& open) {
    const bool to_measure = doing_ == Doing::opening_to_measure;
    const bool to_calibrate = doing_ == Doing::opening_to_calibrate;
    drive_ = std::make_unique<DeviceDrive>(std::move(open.device), open.can,
                                           to_calibrate ? settings_for_reading(setup_.servo) : setup_.servo);
    drive_->loop().set_max_force(to_measure ? JoystickTrial::pull_n : preferences_.choices().max_force_n);
    drive_->loop().start();
    faulty_from_ = -1.0;
    steps_.reset();
    touch_.reset();
    if (to_measure)
        measuring_.emplace(drive_->device(), drive_->loop());
    doing_ = to_measure     ? Doing::announcing_measure
             : to_calibrate ? Doing::calibrating
                            : Doing::announcing_trial;
    timer_.start();
    emit changed();
    announce();
}

void DeviceSettings::announce() {
    if (doing_ == Doing::announcing_measure)
        narrator_.tell_then(tr("%1 Escape ends it.").arg(instruction()), [this] {
            if (doing_ == Doing::announcing_measure)
                doing_ = Doing::measuring;
        });
    else if (doing_ == Doing::announcing_trial)
        narrator_.tell_then(
            tr("The strongest force, %1 newtons: to the right, then to the left. Escape ends it.")
                .arg(QLocale().toString(preferences_.choices().max_force_n, 'f', 1)),
            [this] {
                if (doing_ == Doing::announcing_trial)
                    doing_ = Doing::about_to_pull;
            });
    else
        narrator_.tell(tr("Calibration. The device lies on the screen; put a finger into it, so that it touches the screen. "
                          "Escape ends it. %1")
                           .arg(instruction()),
                       Priority::message);
}

void DeviceSettings::poll() {
    const ServoSnapshot seen = drive_->loop().snapshot();
    const double time = now();
    if (seen.ticks == 0 || tells_fault(seen, time))
        return;
    switch (doing_) {
    case Doing::about_to_pull:
        return pull(Doing::pulling_right);
    case Doing::pulling_right:
        if (time - pulls_since_ >= pull_s)
            pull(Doing::pulling_left);
        return;
    case Doing::pulling_left:
        if (time - pulls_since_ >= pull_s)
            end(tr("That was the strongest force."));
        return;
    case Doing::calibrating:
        if (seen.fault == Fault::none)
            sample(seen.finger());
        return;
    case Doing::measuring:
        return poll_measuring();
    default:
        return;
    }
}

/// One that disables, or lasts, is told, and ends what is done.
bool DeviceSettings::tells_fault(const ServoSnapshot& seen, double time) {
    if (seen.fault == Fault::none)
        faulty_from_ = -1.0;
    else if (faulty_from_ < 0.0)
        faulty_from_ = time;
    if (seen.fault == Fault::none || (!disables(seen.fault) && time - faulty_from_ < fault_lasts_s))
        return false;
    const QString why =
        seen.fault == Fault::motors_off ? in_persons_language(drive_->device().complaint()) : QString();
    end(why.isEmpty() ? fault_words(seen.fault) : why, Priority::fault);
    return true;
}

void DeviceSettings::pull(Doing which) {
    doing_ = which;
    pulls_since_ = now();
    const Vec2 toward(which == Doing::pulling_right ? 1.0 : -1.0, 0.0);
    drive_->loop().render(line_that_pulls(drive_->loop().snapshot().finger(), toward,
                                          preferences_.choices().max_force_n, pull_mm));
    drive_->loop().engage();
}

// --- calibration ---

QString DeviceSettings::instruction() const {
    if (measuring_)
        return measuring_->words();
    switch (mark()) {
    case CalibrationSteps::top_left: return tr("Touch the top left corner and keep still until I speak.");
    case CalibrationSteps::top_right: return tr("Now the top right corner.");
    case CalibrationSteps::bottom_right: return tr("Now the bottom right corner.");
    case CalibrationSteps::bottom_left: return tr("Now the bottom left corner.");
    default: return {};
    }
}

void DeviceSettings::areaLies(double left, double top, double width, double height) {
    if (doing_ == Doing::calibrating && (!steps_ || steps_->pairs().empty()))
        steps_.emplace(Rect{{left, -top - height}, {left + width, -top}});
}

void DeviceSettings::touched(double x, double y) { touch_ = Vec2(x, -y); }

void DeviceSettings::lifted() {
    touch_.reset();
    if (steps_)
        steps_->lift();
}

void DeviceSettings::sample(Vec2 device) {
    if (!steps_ || !touch_ || !steps_->sample(*touch_, device, now()))
        return;
    if (steps_->mark() == CalibrationSteps::all_touched)
        return finish();
    emit changed();
    narrator_.tell(instruction(), Priority::message);
}

void DeviceSettings::finish() { end(result()); }

/// Keeps it where it is good; what came of it.
QString DeviceSettings::result() {
    const Result<Calibration> found = steps_->calibration();
    const QString as_before = tr("Nothing was changed.");
    if (!found)
        return in_persons_language(found.error()) + ' ' + as_before;
    if (found->residual_mm > most_residual_mm)
        return tr("The calibration misses your touches by %1 millimetres on average, and at most %2 are "
                  "allowed. Make sure that the device does not slip on the screen, keep still at each "
                  "corner, and calibrate again.")
                   .arg(in_millimetres(found->residual_mm), in_millimetres(most_residual_mm)) +
               ' ' + as_before;
    if (!is_plausible(found->device_to_surface))
        return tr("The device and the screen do not move alike. Calibrate again with the finger in the device, and no other "
                  "on the screen.") +
               ' ' + as_before;
    if (const std::string why = keep_calibration(setup_.access.calibrations, key_.toStdString(), *found); !why.empty())
        return in_persons_language(why);
    return tr("Calibrated. It misses by %1 millimetres on average, and is saved for this device.")
        .arg(in_millimetres(found->residual_mm));
}

// --- measuring ---

void DeviceSettings::poll_measuring() {
    if (!measuring_->poll(now()))
        return;
    if (measuring_->trial().step() == JoystickTrial::Step::failed)
        return end(instruction() + ' ' + tr("Nothing was changed."), Priority::fault);
    emit changed();
    if (weighing())
        narrator_.tell(instruction(), Priority::message);
}

void DeviceSettings::weighed(const QString& text) {
    if (!weighing())
        return;
    bool number = false;
    double grams = QLocale().toDouble(text.trimmed(), &number);
    if (!number)
        grams = text.trimmed().toDouble(&number);
    const Result<bool> done = measuring_->weighed(number ? grams : -1.0, now());
    if (!done)
        return narrator_.tell(in_persons_language(done.error()), Priority::touch);
    if (!*done)
        return narrator_.tell(tr("That is too little to be read well. The stick pulls twice as strongly now: weigh again."),
                              Priority::message);
    const JoystickScale found = measuring_->trial().assumed();
    const std::string why = keep_joystick_scale(setup_.access.joystick_scales, scale_key_, found);
    end(why.empty() ? tr("The stick is measured: %1 newtons at most. That is saved for this stick.")
                          .arg(QLocale().toString(found.newtons_at_full, 'f', 1))
                    : in_persons_language(why));
}

// --- its end ---

bool DeviceSettings::stop() {
    if (doing_ == Doing::nothing)
        return false;
    narrator_.stop();
    end(doing_ == Doing::calibrating ? tr("Calibration cancelled. Nothing was changed.")
        : measuring()                ? tr("Measurement cancelled. The force is off. Nothing was changed.")
                                     : tr("Stopped. The force is off."),
        Priority::touch);
    return true;
}

void DeviceSettings::end(const QString& sentence, Priority priority) {
    const bool was_doing = std::exchange(doing_, Doing::nothing) != Doing::nothing;
    timer_.stop();
    connector_.cancel();
    measuring_.reset();
    if (drive_) {
        drive_->loop().disengage();
        connector_.release(std::move(drive_));
    }
    steps_.reset();
    touch_.reset();
    if (!was_doing)
        return;
    connector_.watch(true);
    emit changed();
    narrator_.tell(sentence, priority);
}

} // namespace tp
