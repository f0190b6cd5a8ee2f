// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/capture_session.hpp"
#include "capture_ground.hpp"
#include "fake_camera.hpp"

#include <QTest>

#include <memory>
#include <utility>
#include <vector>

/// The page's session before a camera of the test's, in the frames' time.
struct CaptureBench : CaptureGround {
    explicit CaptureBench(const tp::Choices& choices = told()) : CaptureGround(choices) {
        auto made = std::make_unique<FakeCamera>();
        camera = made.get();
        tp::CaptureSession::Parts parts;
        parts.camera = std::move(made);
        parts.make_look = camera->look();
        parts.folder = album_folder();
        parts.touch = touch.access();
        session = std::make_unique<tp::CaptureSession>(narrator, earcons, guide, recorder, moment_recorder,
                                                       preferences, std::move(parts));
    }

    /// The page is entered, its greeting is over.
    void enter() {
        session->enter();
        QTRY_VERIFY(camera->on);
    }
    void see(const std::vector<tp::Vec2>& faces, double size = 0.25) {
        camera->show(*session->camera(), frame(faces, size));
    }
    void see_for(double seconds, const std::vector<tp::Vec2>& faces, double size = 0.25) {
        for (double end = time_s + seconds - 1e-6; time_s < end;)
            see(faces, size);
    }
    /// Nothing is on its way to the disk.
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(!session->shutter()->taking(), 60000); }

    FakeCamera* camera = nullptr; ///< the session's
    std::unique_ptr<tp::CaptureSession> session;
};
