// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/seeing/known_people.hpp"
#include "app/pages/capture/capture_aiming.hpp"
#include "app/pages/capture/capture_album.hpp"
#include "app/pages/capture/capture_camera.hpp"
#include "app/pages/capture/capture_choices.hpp"
#include "app/pages/capture/capture_memo.hpp"
#include "app/pages/capture/capture_moment.hpp"
#include "app/pages/capture/capture_shutter.hpp"
#include "app/pages/capture/capture_sight.hpp"
#include "app/pages/capture/capture_teller.hpp"
#include "app/pages/capture/capture_touch.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/guide/sonified_guide.hpp"
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/moment_recorder.hpp"
#include "audio/sound/recorder.hpp"

#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <memory>

namespace tp {

/// A photograph being taken: the parts that decide what the page shows and tells, and what concerns several of them. A part
/// knows those before it. The page only binds and draws.
class CaptureSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::CaptureChoices* choices READ choices CONSTANT)
    Q_PROPERTY(tp::CaptureCamera* camera READ camera CONSTANT)
    Q_PROPERTY(tp::CaptureAiming* aiming READ aiming CONSTANT)
    Q_PROPERTY(tp::CaptureShutter* shutter READ shutter CONSTANT)
    Q_PROPERTY(tp::CaptureMemo* memo READ memo CONSTANT)
    Q_PROPERTY(tp::CaptureMoment* moment READ moment CONSTANT)
public:
    /// What a program or a test gives to the page.
    struct Parts {
        std::unique_ptr<Camera> camera;
        CaptureCamera::MakeLook make_look;
        CaptureAlbum::Folder folder; ///< where photographs are kept
        /// Who may be known on what was taken.
        std::shared_ptr<const KnownPeople> people = std::make_shared<KnownPeople>();
        TouchAccess touch = {}; ///< outputs that tick; without one nothing is felt
    };

    /// All must outlive the session.
    CaptureSession(Narrator& narrator, EarconPlayer& earcons, SonifiedGuide& guide, Recorder& recorder,
                   MomentRecorder& moment, Preferences& preferences, Parts parts);
    ~CaptureSession() override;

    CaptureChoices* choices() { return &choices_; }
    CaptureCamera* camera() { return &camera_; }
    CaptureAiming* aiming() { return &aiming_; }
    CaptureShutter* shutter() { return &shutter_; }
    CaptureMemo* memo() { return &memo_; }
    CaptureMoment* moment() { return &moment_; }
    const CaptureTouch& touch() const { return touch_; }
    /// A photograph that was taken, or a sound that belongs to one, is not on the disk yet.
    bool keeping() const { return memo_.running() || moment_.keeping() || album_.busy(); }

    /// The page comes into sight: says where one is; the camera goes on.
    Q_INVOKABLE void enter();
    /// The page goes out of sight: the camera goes off, and nothing of what it saw is kept.
    Q_INVOKABLE void leave() { sight_.leave(); }
    /// The window is hidden or minimised, or is there again.
    Q_INVOKABLE void setInSight(bool in_sight) { sight_.show_window(in_sight); }

    /// Takes the photograph; ends a memo that is being recorded.
    Q_INVOKABLE void take();
    /// Begins a memo for the last photograph, or ends and keeps it.
    Q_INVOKABLE void recordMemo();
    /// Ends a memo, which is kept, or looking through a burst; else silence: neither words nor tone until the next key. False:
    /// it was silent already.
    Q_INVOKABLE bool stop();
    /// Something was done on the page: it may speak.
    Q_INVOKABLE void listen() { aiming_.listen(); }
    Q_INVOKABLE void tellAll();
    /// The other camera, where there is one.
    Q_INVOKABLE void turnRound();
    Q_INVOKABLE void setLight(bool on);
    Q_INVOKABLE void tryAgain() { sight_.try_again(); }
    /// Whoever has no camera brings photographs of another one.
    Q_INVOKABLE void importInstead() { emit importAsked(); }
    /// At a desk: by so many steps to the right, up, clockwise and closer.
    Q_INVOKABLE void moveCamera(double right, double up, double clockwise, double closer);

signals:
    void keepingChanged();
    void importAsked();
    /// Something about this photograph was changed on the disk.
    void touched(const std::filesystem::path& photo);

private:
    void greet();

    Preferences& preferences_;
    CaptureTeller teller_;
    CaptureChoices choices_;
    CaptureCamera camera_;
    CaptureTouch touch_;
    CaptureAiming aiming_;
    CaptureAlbum album_;
    CaptureShutter shutter_;
    CaptureMemo memo_;
    CaptureMoment moment_;
    CaptureSight sight_;
};

} // namespace tp
