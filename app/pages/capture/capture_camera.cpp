// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_camera.hpp"

#include "app/capture/camera/small_picture.hpp"
#include "audio/sentences/sentences.hpp"

#include <QMetaObject>
#include <QTimer>

#include <string>
#include <utility>

namespace tp {

namespace {

constexpr int picture_px = 800; ///< longer side of what the page shows

/// Made where it looks, because its nets take a while.
FrameLook made_late(CaptureCamera::MakeLook make) {
    return [make = std::move(make), look = FrameLook()](const CameraFrame& frame) mutable {
        if (!look)
            look = make();
        return look(frame);
    };
}

} // namespace

CaptureCamera::CaptureCamera(std::unique_ptr<Camera> camera, MakeLook make_look)
    : camera_(std::move(camera)), make_look_(std::move(make_look)) {}

CaptureCamera::~CaptureCamera() { switch_off(); }

std::vector<CameraFrame> CaptureCamera::last_frames() const {
    return watch_ ? watch_->last_frames() : std::vector<CameraFrame>();
}

void CaptureCamera::switch_on() {
    if (state_ == Begins || state_ == On)
        return;
    set_state(Begins);
    QTimer::singleShot(0, this, [this, run = run_] {
        if (run == run_)
            begin();
    });
}

void CaptureCamera::begin() {
    auto source = camera_->open(side_);
    if (!source)
        return fail(in_persons_language(source.error()));
    CameraTold told;
    told.seen = [this, run = run_](const AimFrame& seen, const CameraFrame& frame) {
        QMetaObject::invokeMethod(this, [this, run, seen, picture = small_picture(frame.pixels, picture_px)] {
            if (run == run_)
                take(seen, picture);
        });
    };
    told.ended = [this, run = run_](const std::string& why) {
        QMetaObject::invokeMethod(this, [this, run, why] {
            if (run == run_)
                fail(why.empty() ? tr("The camera has stopped.") : in_persons_language(why));
        });
    };
    side_ = (*source)->held().front ? CameraSide::front : CameraSide::back;
    watch_ = std::make_unique<CameraWatch>(std::move(source).value(), made_late(make_look_), std::move(told));
}

void CaptureCamera::switch_off() {
    if (state_ == Off)
        return;
    ++run_;
    watch_.reset();
    camera_->close();
    lit_ = false;
    if (!std::exchange(picture_, {}).isNull())
        emit pictureChanged();
    set_state(Off);
}

void CaptureCamera::turn_round() {
    if (!both_)
        return;
    side_ = front() ? CameraSide::back : CameraSide::front;
    switch_off();
    switch_on();
}

void CaptureCamera::light(bool on) {
    if (state_ != On || !torch_ || on == lit_)
        return;
    camera_->light(on);
    lit_ = on;
    emit changed();
}

void CaptureCamera::take(const AimFrame& frame, const QImage& picture) {
    picture_ = picture;
    if (state_ == Begins) {
        both_ = camera_->has_both();
        torch_ = camera_->has_torch();
        set_state(On);
        emit began();
    }
    emit pictureChanged();
    emit seen(frame);
}

void CaptureCamera::fail(const QString& why) {
    switch_off();
    problem_ = why;
    set_state(Failed);
    emit failed();
}

void CaptureCamera::set_state(State state) {
    if (state != Failed)
        problem_.clear();
    state_ = state;
    emit changed();
}

} // namespace tp
