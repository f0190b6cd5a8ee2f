// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/camera/camera.hpp"
#include "app/capture/seeing/camera_watch.hpp"
#include "core/aiming/aim_frame.hpp"

#include <QImage>
#include <QObject>
#include <QString>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tp {

/// The camera of the page: on while one aims, and what it sees. Its frames are looked at on threads of their own; all calls and
/// signals are on the page's.
///
/// |         | switch_on | a frame | trouble | switch_off |
/// |---------|-----------|---------|---------|------------|
/// | off     | begins    |         |         |            |
/// | begins  |           | on      | failed  | off        |
/// | on      |           |         | failed  | off        |
/// | failed  | begins    |         |         | off        |
class CaptureCamera final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(State state READ state NOTIFY changed)
    Q_PROPERTY(QString problem READ problem NOTIFY changed) ///< why it failed, in a sentence
    Q_PROPERTY(bool both READ both NOTIFY changed)          ///< there is a front and a back one
    Q_PROPERTY(bool torch READ torch NOTIFY changed)        ///< there is a light
    Q_PROPERTY(bool lit READ lit NOTIFY changed)            ///< and it is on
    Q_PROPERTY(bool front READ front NOTIFY changed)
    Q_PROPERTY(bool movedByKeys READ moved_by_keys CONSTANT)
    Q_PROPERTY(QVariant picture READ picture NOTIFY pictureChanged) ///< a QImage: what is seen now
public:
    enum State { Off, Begins, On, Failed };
    Q_ENUM(State)
    /// Called on the thread that looks, when it begins.
    using MakeLook = std::function<FrameLook()>;

    CaptureCamera(std::unique_ptr<Camera> camera, MakeLook make_look);
    ~CaptureCamera() override;

    State state() const { return state_; }
    const QString& problem() const { return problem_; }
    bool both() const { return both_; }
    bool torch() const { return torch_; }
    bool lit() const { return lit_; }
    bool front() const { return side_ == CameraSide::front; }
    std::string name() const { return camera_->name(); }
    bool moved_by_keys() const { return camera_->moved_by_keys(); }
    QVariant picture() const { return picture_; }
    HeldCamera held() const { return watch_ ? watch_->held() : HeldCamera{}; }
    /// The last ones, the oldest first.
    std::vector<CameraFrame> last_frames() const;

    /// Begins soon: what is to be said first can be.
    void switch_on();
    /// Nothing of what it saw is kept. Waits for a look that is under way.
    void switch_off();
    /// The other one, where there are two.
    void turn_round();
    void light(bool on);
    /// A person at a desk moves the simulated camera.
    void move_by(const HeldPose& way) { camera_->move_by(way); }

signals:
    void changed();
    void pictureChanged();
    /// It is on.
    void began();
    void seen(const tp::AimFrame& frame);
    /// `problem` says why.
    void failed();

private:
    void begin();
    void take(const AimFrame& frame, const QImage& picture);
    void fail(const QString& why);
    void set_state(State state);

    std::unique_ptr<Camera> camera_;
    MakeLook make_look_;
    State state_ = Off;
    CameraSide side_ = CameraSide::back;
    QString problem_;
    bool both_ = false, torch_ = false, lit_ = false;
    QImage picture_;
    quint64 run_ = 0; ///< what a watch from before posted is not heard
    std::unique_ptr<CameraWatch> watch_;
};

} // namespace tp
