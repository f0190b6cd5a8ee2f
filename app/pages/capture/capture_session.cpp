// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_session.hpp"

#include "app/pages/capture/aim_words.hpp"

#include <QLocale>
#include <QString>

#include <utility>

namespace tp {

namespace {

constexpr double step_deg = 2.0; ///< of a key, at a desk
constexpr double turn_deg = 3.0;
constexpr double step_m = 0.1;

} // namespace

CaptureSession::CaptureSession(Narrator& narrator, EarconPlayer& earcons, SonifiedGuide& guide,
                               Recorder& recorder, MomentRecorder& moment, Preferences& preferences,
                               Parts parts)
    : preferences_(preferences), teller_(narrator, earcons), choices_(preferences, teller_),
      camera_(std::move(parts.camera), std::move(parts.make_look)),
      touch_(choices_, teller_, std::move(parts.touch)), aiming_(choices_, teller_, guide, touch_),
      album_(std::move(parts.folder)), shutter_(album_, std::move(parts.people), teller_),
      memo_(album_, recorder, teller_), moment_(album_, choices_, moment, teller_),
      sight_(camera_, touch_, aiming_, shutter_, memo_, moment_, teller_) {
    connect(&aiming_, &CaptureAiming::take_asked, this, [this] {
        if (!memo_.running() && shutter_.shown() < 0)
            take();
    });
    connect(&shutter_, &CaptureShutter::touched, this, &CaptureSession::touched);
    connect(&shutter_, &CaptureShutter::kept, &moment_, &CaptureMoment::keep);
    connect(&shutter_, &CaptureShutter::not_kept, &moment_, &CaptureMoment::drop);
    connect(&moment_, &CaptureMoment::touched, this, &CaptureSession::touched);
    connect(&memo_, &CaptureMemo::touched, this, &CaptureSession::touched);
    connect(&memo_, &CaptureMemo::changed, this, &CaptureSession::keepingChanged);
    connect(&moment_, &CaptureMoment::changed, this, &CaptureSession::keepingChanged);
    connect(&album_, &CaptureAlbum::changed, this, &CaptureSession::keepingChanged);
    connect(&camera_, &CaptureCamera::failed, this, [this] {
        teller_.problem(camera_.problem() + ' ' + tr("Press I to import photographs of another camera."));
    });
}

CaptureSession::~CaptureSession() { camera_.switch_off(); }

void CaptureSession::enter() {
    greet();
    sight_.enter();
}

void CaptureSession::greet() {
    if (preferences_.choices().capture_told)
        return teller_.tell(tr("Take a photograph. %1.").arg(choices_.aims()[choices_.aim_index()]) +
                            (choices_.moment() ? ' ' + tr("The microphone is on.") : QString()));
    preferences_.change([](Choices& choices) { choices.capture_told = true; });
    teller_.tell(
        tr("Take a photograph. Point the camera at somebody, and listen where to move it. When all is "
           "well, the photograph is taken automatically; press S if you do not want that. Space takes it "
           "at once."));
}

void CaptureSession::take() {
    if (memo_.finish())
        return;
    if (camera_.state() != CaptureCamera::On)
        return tellAll();
    if (shutter_.taking())
        return;
    moment_.shutter();
    teller_.sound(Earcon::contour_crossed);
    aiming_.taken();
    shutter_.take({camera_.last_frames(), camera_.held(), camera_.name()});
}

void CaptureSession::recordMemo() {
    if (memo_.finish())
        return;
    if (shutter_.photo().empty())
        return teller_.answer(tr("Take a photograph first; then you can record a memo for it."));
    const QString& chosen = preferences_.choices().language;
    memo_.start(shutter_.photo(), chosen.isEmpty() ? QLocale().bcp47Name() : chosen);
}

bool CaptureSession::stop() {
    if (memo_.finish() || shutter_.look_away())
        return true;
    const bool spoke = teller_.speaking();
    teller_.silence();
    return (camera_.state() == CaptureCamera::On && aiming_.hush()) || spoke;
}

void CaptureSession::tellAll() {
    if (camera_.state() == CaptureCamera::On)
        return aiming_.tell_all();
    teller_.answer(camera_.state() == CaptureCamera::Failed ? camera_.problem()
                                                            : tr("The camera is starting."));
}

void CaptureSession::turnRound() {
    if (!camera_.both())
        return camera_.state() == CaptureCamera::On ? teller_.answer(tr("There is only one camera."))
                                                    : tellAll();
    camera_.turn_round();
    teller_.answer(camera_.front() ? tr("Front camera.") : tr("Back camera."));
}

void CaptureSession::setLight(bool on) {
    if (camera_.state() != CaptureCamera::On)
        return tellAll();
    if (!camera_.torch())
        return teller_.answer(tr("This camera has no light."));
    camera_.light(on);
    teller_.answer(on ? tr("Light on.") : tr("Light off."));
}

void CaptureSession::moveCamera(double right, double up, double clockwise, double closer) {
    HeldPose way;
    way.pan_deg = step_deg * right;
    way.tilt_deg = step_deg * up;
    way.roll_deg = turn_deg * clockwise;
    way.forward_m = step_m * closer;
    camera_.move_by(way);
}

} // namespace tp
