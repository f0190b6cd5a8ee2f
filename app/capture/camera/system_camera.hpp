// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/camera/camera.hpp"
#include "app/capture/camera/newest_frame.hpp"

#include <QCamera>
#include <QCameraDevice>
#include <QMediaCaptureSession>
#include <QMediaDevices>
#include <QObject>
#include <QVideoSink>

#include <memory>
#include <string>

namespace tp {

/// A camera of this machine.
class SystemCamera final : public QObject, public Camera {
    Q_OBJECT
public:
    SystemCamera();
    ~SystemCamera() override;

    Result<std::unique_ptr<FrameSource>> open(CameraSide side) override;
    void close() override;
    std::string name() const override;
    bool has_both() const override;
    bool has_torch() const override;
    void light(bool on) override;

private:
    struct Running;
    void look_for_it();

    std::unique_ptr<QMediaDevices> devices_; ///< made when it is opened first: it starts a thread of Qt's
    std::unique_ptr<Running> running_;
};

} // namespace tp
