// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/capture/capture_aiming.hpp"
#include "app/pages/capture/capture_album.hpp"
#include "app/pages/capture/capture_choices.hpp"
#include "app/pages/capture/capture_memo.hpp"
#include "app/pages/capture/capture_teller.hpp"
#include "app/pages/capture/capture_touch.hpp"
#include "app/parts/controls/recording_announcer.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/guide/sonified_guide.hpp"
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/earcons.hpp"
#include "audio/sound/moment_recorder.hpp"
#include "audio/sound/recorder.hpp"
#include "audio/speech/recording_voice.hpp"
#include "fake_loudspeaker.hpp"
#include "fake_microphone.hpp"
#include "heard_earcon.hpp"
#include "sound_files.hpp"
#include "touch_socket.hpp"

#include <QDir>
#include <QMetaObject>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// What stands below the page's parts: an album's folder, voice, loudspeakers and microphones of the test's, and what a camera
/// may see.
struct CaptureGround {
    explicit CaptureGround(const tp::Choices& choices = told()) { preferences.set(choices); }
    static tp::Choices told() {
        tp::Choices choices;
        choices.capture_told = true;
        choices.language = "en";
        return choices;
    }

    /// A frame `after_s` after the last one with faces of these middles.
    tp::AimFrame frame(const std::vector<tp::Vec2>& faces, double size = 0.25, double after_s = 0.1) {
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
        return frame;
    }
    /// What is said is over when the voice is set to be no longer busy.
    void speak_slowly() {
        QObject::connect(&narrator, &tp::Narrator::told, &voice, [this] { voice.set_busy(true); });
    }
    /// Where photographs are kept; not there before the first.
    QString album() const { return folder.filePath("Family"); }
    tp::CaptureAlbum::Folder album_folder() const {
        return [this] { return std::filesystem::path(album().toStdString()); };
    }
    QStringList photographs() const {
        QStringList paths;
        for (const QString& name : QDir(album()).entryList({"*.jpg"}, QDir::Files, QDir::Name))
            paths << album() + '/' + name;
        return paths;
    }
    /// The microphone hears a tone.
    void hear(double seconds) {
        QTRY_VERIFY_WITH_TIMEOUT(microphone.load() != nullptr, 60000);
        QTRY_VERIFY_WITH_TIMEOUT(recorder.state() != tp::RecorderState::idle, 60000);
        hear_tone(*microphone, seconds);
        QTRY_COMPARE_WITH_TIMEOUT(recorder.state(), tp::RecorderState::recording, 60000);
    }
    /// The moment's microphone hears a tone.
    void hear_moment(double seconds) {
        QTRY_VERIFY_WITH_TIMEOUT(moment_microphone.load() != nullptr, 60000);
        hear_tone(*moment_microphone, seconds);
    }
    static void hear_tone(tp::testing::FakeMicrophone& made, double seconds) {
        QMetaObject::invokeMethod(
            &made, [&made, seconds] { made.hear(tp::testing::tone(440.0, seconds, tp::sound_rate)); },
            Qt::BlockingQueuedConnection);
    }
    /// Of the sounds that were begun since the last call, whether this one is among them; all of them are forgotten.
    bool sounded(tp::Earcon earcon) { return tp::testing::heard_earcon(earcon_speaker, earcon); }
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
    tp::MomentRecorder moment_recorder{[this] {
        auto made = std::make_unique<tp::testing::FakeMicrophone>();
        moment_microphone = made.get();
        return made;
    }};
    double time_s = 0.0;            ///< of the last frame
    std::vector<std::string> names; ///< of the faces that are seen, in their order, as far as they are known
};

/// The page's parts that need no camera, without a session.
struct CaptureParts : CaptureGround {
    using CaptureGround::CaptureGround;

    tp::CaptureTeller teller{narrator, earcons};
    tp::CaptureChoices choices{preferences, teller};
    tp::CaptureTouch pulses{choices, teller, touch.access()};
    tp::CaptureAiming aiming{choices, teller, guide, pulses};
    tp::CaptureAlbum keeping{album_folder()};
    tp::CaptureMemo memo{keeping, recorder, teller};
};
