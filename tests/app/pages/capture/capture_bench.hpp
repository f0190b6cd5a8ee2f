// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/capture_session.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "audio/speech/recording_voice.hpp"
#include "fake_loudspeaker.hpp"
#include "fake_microphone.hpp"
#include "sound_files.hpp"
#include "touch_socket.hpp"

#include <QDir>
#include <QMetaObject>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

#include <opencv2/core/mat.hpp>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What the test's camera gives, from the test to the thread that pulls. A frame's pixels say nothing; what is seen on it goes
/// beside it.
class Film {
public:
    void show(tp::AimFrame seen) { put(std::move(seen)); }
    void fail(const std::string& why) {
        const std::lock_guard lock(mutex_);
        why_ = why;
        came_.notify_all();
    }
    void end() {
        const std::lock_guard lock(mutex_);
        ended_ = true;
        came_.notify_all();
    }
    tp::Result<std::optional<tp::CameraFrame>> next() {
        std::unique_lock lock(mutex_);
        came_.wait(lock, [this] { return given_ < shown_.size() || ended_ || !why_.empty(); });
        if (ended_)
            return std::optional<tp::CameraFrame>();
        if (!why_.empty())
            return tp::Error{why_};
        tp::CameraFrame frame;
        frame.pixels = cv::Mat(36, 64, CV_8UC3, cv::Scalar(90, 120, 150));
        frame.time_s = shown_[given_++].time_s;
        return std::optional(std::move(frame));
    }
    tp::AimFrame seen_on(const tp::CameraFrame& frame) {
        const std::lock_guard lock(mutex_);
        for (const tp::AimFrame& seen : shown_)
            if (seen.time_s == frame.time_s)
                return seen;
        return {};
    }

private:
    void put(tp::AimFrame seen) {
        const std::lock_guard lock(mutex_);
        shown_.push_back(std::move(seen));
        came_.notify_all();
    }
    std::mutex mutex_;
    std::condition_variable came_;
    std::deque<tp::AimFrame> shown_;
    std::size_t given_ = 0;
    std::string why_;
    bool ended_ = false;
};

class FilmSource final : public tp::FrameSource {
public:
    FilmSource(std::shared_ptr<Film> film, tp::HeldCamera held) : film_(std::move(film)), held_(held) {}
    tp::Result<std::optional<tp::CameraFrame>> next() override { return film_->next(); }
    tp::HeldCamera held() const override { return held_; }
    void interrupt() override { film_->end(); }

private:
    std::shared_ptr<Film> film_;
    tp::HeldCamera held_;
};

class FakeCamera final : public tp::Camera {
public:
    tp::Result<std::unique_ptr<tp::FrameSource>> open(tp::CameraSide side) override {
        if (!why_not.empty())
            return tp::Error{why_not};
        on = true;
        ++opened;
        film = std::make_shared<Film>();
        return std::unique_ptr<tp::FrameSource>(
            std::make_unique<FilmSource>(film, tp::HeldCamera{side == tp::CameraSide::front, false}));
    }
    void close() override { on = false; }
    bool has_both() const override { return both; }
    bool has_torch() const override { return torch; }
    void light(bool wanted) override { lit = wanted; }
    bool move_by(const tp::HeldPose& way) override {
        moved.pan_deg += way.pan_deg;
        moved.tilt_deg += way.tilt_deg;
        moved.roll_deg += way.roll_deg;
        moved.forward_m += way.forward_m;
        return movable;
    }
    bool moved_by_keys() const override { return movable; }

    std::string why_not;
    bool on = false, both = false, torch = false, lit = false, movable = false;
    int opened = 0;
    tp::HeldPose moved;
    std::shared_ptr<Film> film = std::make_shared<Film>(); ///< of the camera that was opened last
};

/// The page's session before a camera of the test's, in the frames' time.
struct CaptureBench {
    explicit CaptureBench(tp::Choices choices = told()) {
        preferences.set(choices);
        auto made = std::make_unique<FakeCamera>();
        camera = made.get();
        tp::CaptureSession::Parts parts;
        parts.camera = std::move(made);
        parts.make_look = [this] {
            return [this](const tp::CameraFrame& frame) { return camera->film->seen_on(frame); };
        };
        parts.folder = [this] { return std::filesystem::path(album().toStdString()); };
        parts.touch = touch.access();
        session = std::make_unique<tp::CaptureSession>(narrator, earcons, guide, recorder, moment,
                                                       preferences, std::move(parts));
    }
    static tp::Choices told() {
        tp::Choices choices;
        choices.capture_told = true;
        choices.language = "en";
        return choices;
    }

    /// The page is entered, its greeting is over.
    void enter() {
        session->enter();
        QTRY_VERIFY(camera->on);
    }
    /// A frame `after_s` after the last one with faces of these middles, seen by the page.
    void see(std::vector<tp::Vec2> faces, double size = 0.25, double after_s = 0.1) {
        tp::AimFrame frame;
        frame.time_s = time_s += after_s;
        frame.aspect = 16.0 / 9.0;
        frame.sharpness = 1.0;
        frame.motion = 0.0;
        for (const tp::Vec2 middle : faces) {
            tp::AimFace face;
            const tp::Vec2 half(0.5 * size / frame.aspect, 0.5 * size);
            face.box = {middle - half, middle + half};
            face.brightness = 0.5;
            face.name = frame.faces.size() < names.size() ? names[frame.faces.size()] : std::string();
            frame.faces.push_back(face);
        }
        int heard = 0;
        const auto counts = QObject::connect(session->camera(), &tp::CaptureCamera::seen, session->camera(),
                                             [&] { ++heard; });
        camera->film->show(frame);
        QTRY_COMPARE(heard, 1);
        QObject::disconnect(counts);
    }
    void see_for(double seconds, const std::vector<tp::Vec2>& faces, double size = 0.25) {
        for (double end = time_s + seconds - 1e-6; time_s < end;)
            see(faces, size);
    }
    /// What is said is over when the voice is set to be no longer busy.
    void speak_slowly() {
        QObject::connect(&narrator, &tp::Narrator::told, &voice, [this] { voice.set_busy(true); });
    }
    /// Where photographs are kept; not there before the first.
    QString album() const { return folder.filePath("Family"); }
    QStringList photographs() const {
        QStringList paths;
        for (const QString& name : QDir(album()).entryList({"*.jpg"}, QDir::Files, QDir::Name))
            paths << album() + '/' + name;
        return paths;
    }
    /// Nothing is on its way to the disk.
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(!session->shutter()->taking(), 60000); }
    /// The microphone hears a tone.
    void hear(double seconds) {
        QTRY_VERIFY_WITH_TIMEOUT(microphone.load() != nullptr, 60000);
        QTRY_VERIFY_WITH_TIMEOUT(recorder.state() != tp::RecorderState::idle, 60000);
        tp::testing::FakeMicrophone* const made = microphone;
        QMetaObject::invokeMethod(
            made, [made, seconds] { made->hear(tp::testing::tone(440.0, seconds, tp::sound_rate)); },
            Qt::BlockingQueuedConnection);
        QTRY_COMPARE_WITH_TIMEOUT(recorder.state(), tp::RecorderState::recording, 60000);
    }
    /// The moment's microphone hears a tone.
    void hear_moment(double seconds) {
        QTRY_VERIFY_WITH_TIMEOUT(moment_microphone.load() != nullptr, 60000);
        tp::testing::FakeMicrophone* const made = moment_microphone;
        QMetaObject::invokeMethod(
            made, [made, seconds] { made->hear(tp::testing::tone(440.0, seconds, tp::sound_rate)); },
            Qt::BlockingQueuedConnection);
    }
    QString last_said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }

    QTemporaryDir folder;
    tp::RecordingVoice voice;
    tp::RecordingAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::testing::FakeLoudspeaker earcon_speaker, guide_speaker;
    tp::EarconPlayer earcons{earcon_speaker};
    tp::testing::TouchSocket touch; ///< what ticks
    tp::SonifiedGuide guide{guide_speaker};
    tp::Preferences preferences;
    std::atomic<tp::testing::FakeMicrophone*> microphone{nullptr}; ///< on the recorder's thread
    tp::Recorder recorder{[this] {
        auto made = std::make_unique<tp::testing::FakeMicrophone>();
        microphone = made.get();
        return made;
    }};
    std::atomic<tp::testing::FakeMicrophone*> moment_microphone{nullptr}; ///< on the moment's thread
    tp::MomentRecorder moment{[this] {
        auto made = std::make_unique<tp::testing::FakeMicrophone>();
        moment_microphone = made.get();
        return made;
    }};
    FakeCamera* camera = nullptr; ///< the session's
    double time_s = 0.0;
    std::vector<std::string> names; ///< of the faces that are seen, in their order, as far as they are known
    std::unique_ptr<tp::CaptureSession> session;
};
