// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/study_finger.hpp"

#include "app/parts/devices/fault_words.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/geometry/transform.hpp"

#include <QStringList>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace {

/// Its six numbers, row by row.
std::string words_of(const Affine& map) {
    QStringList numbers;
    for (const double value :
         {map.linear[0].x, map.linear[1].x, map.offset.x, map.linear[0].y, map.linear[1].y, map.offset.y})
        numbers << QString::number(value, 'g', 9);
    return numbers.join(' ').toStdString();
}

} // namespace

StudyFinger::StudyFinger(const StudySettings& settings, Preferences& preferences)
    : settings_(settings), preferences_(preferences), connector_(settings.devices) {
    connect(&connector_, &DeviceConnector::looked, this, &StudyFinger::changed);
    connect(&connector_, &DeviceConnector::opened, this,
            [this](const std::shared_ptr<OpenDevice>& open) { use(*open); });
    connect(&connector_, &DeviceConnector::refused, this, [this](const QString& sentence) {
        give_back();
        emit refused(sentence);
    });
}

StudyFinger::~StudyFinger() { give_back(); }

void StudyFinger::look(bool on) {
    looks_ = on;
    connector_.watch(on);
}

const ListedDevice* StudyFinger::wanted() const {
    return device_for(connector_.there(), preferences_.choices().device);
}

QString StudyFinger::found() const {
    const ListedDevice* device = wanted();
    return device == nullptr ? QString() : in_persons_language(device->about);
}

double StudyFinger::persons_limit_n() const {
    return std::clamp(preferences_.choices().max_force_n, 0.0, settings_.servo.limits.max_force);
}

void StudyFinger::choose_limit(double device_n) {
    const double persons = persons_limit_n();
    limit_n_ = std::min(device_n, wish_.force_allowed ? std::max(persons, wish_.pull_n) : persons);
    servo_->set_max_force(limit_n_);
}

/// For the record, in English: "force pad, TPC-0042, at most 1.00 N, cut: the study asks for 5.00 N"
std::string StudyFinger::recorded(QStringList about) const {
    const auto newtons = [](double value) { return QString::number(value, 'f', 2) + " N"; };
    about << QStringList{"at most", newtons(limit_n_)}.join(' ');
    if (wish_.force_allowed && limit_n_ > persons_limit_n())
        about << "raised with the researcher's consent";
    if (is_cut())
        about << QStringList{"cut: the study asks for", newtons(wish_.pull_n)}.join(' ');
    return about.join(", ").toStdString();
}

void StudyFinger::take(const Wish& wish) {
    give_back();
    wish_ = wish;
    faults_ = {};
    calibration_.clear();
    servo_ = std::make_unique<FingerServo>(wish.surface, settings_.servo, settings_.plant, settings_.time);
    choose_limit(SimulatedDevice::max_force_n);
    const ListedDevice* wanted = wish.device ? this->wanted() : nullptr;
    if (wish.device && wanted == nullptr) {
        give_back();
        return emit refused(tr("The force device is not there. Connect it."));
    }
    if (wanted == nullptr) {
        about_ = recorded({"drawn finger", "mouse or touchscreen or keys", "tone"});
        return emit taken();
    }
    opening_ = true;
    connector_.open(*wanted);
}

/// Whether it reaches all of the surface, laid middle on middle.
bool StudyFinger::reaches(const OpenDevice& open) const {
    const std::vector<Vec2> reach = reach_of(open.can, middle_on_middle(open.can));
    Vec2 most(0.0);
    for (const Vec2 corner : reach)
        most = glm::max(most, glm::abs(corner));
    return most.x >= 0.5 * wish_.surface.x && most.y >= 0.5 * wish_.surface.y;
}

void StudyFinger::use(OpenDevice& open) {
    opening_ = false;
    if (!reaches(open)) {
        const QString about = in_persons_language(open.listed.about);
        connector_.release(
            std::make_unique<DeviceDrive>(std::move(open.device), open.can, settings_.device_servo));
        give_back();
        return emit refused(
            tr("The device does not reach all of the experiment's surface, %1 by %2 millimetres: %3. "
               "Write a smaller surface into the experiment's file, or use the mouse.")
                .arg(wish_.surface.x)
                .arg(wish_.surface.y)
                .arg(about));
    }
    ServoSettings servo = settings_.device_servo;
    servo.device_to_surface = middle_on_middle(open.can);
    QStringList about{QString::fromStdString(open.listed.about)};
    if (!open.can.serial_number.empty())
        about << QString::fromStdString(open.can.serial_number);
    const double device_n = open.can.max_force;
    calibration_ = words_of(servo.device_to_surface);
    connector_.release(
        servo_->use(std::make_unique<DeviceDrive>(std::move(open.device), open.can, servo, settings_.time)));
    choose_limit(device_n);
    about_ = recorded(about);
    emit taken();
}

void StudyFinger::give_back() {
    connector_.cancel();
    opening_ = false;
    if (servo_ == nullptr)
        return;
    stop();
    if (servo_->real())
        connector_.release(servo_->use_simulated());
    servo_.reset();
}

std::string StudyFinger::about() const { return about_; }

std::string StudyFinger::lay(FingerServo::Make make) {
    servo_->disengage();
    std::string problem = servo_->render(std::move(make));
    servo_->park();
    return problem;
}

void StudyFinger::bring(Vec2 place) {
    if (!servo_->real())
        return;
    servo_->engage();
    servo_->lead_to(place);
}

bool StudyFinger::brought() {
    if (!servo_->real())
        return true;
    if (!servo_->has_led())
        return false;
    stop();
    return true;
}

void StudyFinger::feel(Vec2 start) {
    servo_->place(start);
    servo_->engage();
}

void StudyFinger::stop() {
    if (servo_ == nullptr)
        return;
    servo_->disengage();
    servo_->let_go();
    servo_->park();
}

void StudyFinger::move_by(Vec2 way) {
    if (servo_ != nullptr)
        servo_->move(servo_->pointer() + way);
}

void StudyFinger::watch(double now) {
    if (servo_ == nullptr)
        return;
    const Fault fault = servo_->snapshot().fault;
    const bool tell = faults_.must_tell(fault, now);
    if (!tell)
        return;
    const QString why = fault == Fault::motors_off ? in_persons_language(servo_->complaint()) : QString();
    emit troubled(why.isEmpty() ? fault_words(fault) : why, disables(fault));
}

void StudyFinger::pass(double seconds) {
    if (servo_ != nullptr)
        servo_->pass(seconds);
}

} // namespace tp
