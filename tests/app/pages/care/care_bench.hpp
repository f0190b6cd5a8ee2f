// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "album_parts.hpp"
#include "app/album/grouping/album_faces.hpp"
#include "app/album/metadata/photo_record.hpp"
#include "app/album/open/open_album.hpp"
#include "app/pages/care/care_history.hpp"
#include "app/pages/care/care_session.hpp"
#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/cared_photo.hpp"
#include "app/pages/care/keeper_steps.hpp"
#include "app/pages/care/listening.hpp"
#include "app/pages/care/recording_list.hpp"
#include "app/pages/care/recording_wait.hpp"
#include "app/pages/care/take.hpp"
#include "app/parts/controls/notification_announcer.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/player.hpp"
#include "audio/sound/recorder.hpp"
#include "audio/speech/recording_voice.hpp"
#include "fake_loudspeaker.hpp"
#include "fake_microphone.hpp"
#include "inline_filler.hpp"

#include <QStringList>
#include <QTest>
#include <QUrl>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// A drawn picture of 240 × 160 px as a PNG; another `number`, other colours.
std::filesystem::path a_picture(const tp::AlbumFolder& folder, const std::filesystem::path& name, int number);

/// An album of a person with everything that the care page's parts need; the microphone and the loudspeakers are the
/// test's.
struct CareGround {
    /// `names` of the photographs, 1 × 1 px unless `pictures`; the album's folder is "album" in `folder`.
    explicit CareGround(const std::vector<std::string>& names = {"a.jpg"}, bool with_folder = true,
                        bool pictures = false);

    /// The album anew, as after a start of the program; nothing may use the one before.
    void open_album();
    std::filesystem::path photo(const std::string& name) const { return root() / name; }
    std::filesystem::path root() const { return std::filesystem::canonical(folder / "album"); }
    /// The record as it is on the disk.
    tp::PhotoRecord record(const std::string& name = "a.jpg") const;
    /// A sound of so many seconds becomes a recording of the photograph.
    std::string add_sound(const std::string& name, double seconds, double hertz,
                          tp::RecordingKind kind = tp::RecordingKind::memo);
    /// The microphone hears a tone.
    void hear(double seconds);
    /// Of the sounds that were begun since the last call, whether this one is among them; all of them are forgotten.
    bool sounded(tp::Earcon earcon);
    QString last_said() const { return voice.said().isEmpty() ? QString() : voice.said().back(); }

    tp::AlbumFolder folder;
    tp::Preferences preferences;
    tp::RecordingVoice voice;
    tp::NotificationAnnouncer announcer;
    tp::Narrator narrator{voice, announcer};
    tp::testing::FakeLoudspeaker loudspeaker, earcon_loudspeaker;
    tp::testing::InlineFiller filler;
    tp::EarconPlayer earcons{earcon_loudspeaker};
    tp::Player player{loudspeaker, filler};
    std::atomic<tp::testing::FakeMicrophone*> microphone{nullptr};
    tp::Recorder recorder;
    std::unique_ptr<tp::OpenAlbum> album;
    std::unique_ptr<tp::AlbumFaces> groups;
};

inline QUrl url(const std::filesystem::path& file) {
    return QUrl::fromLocalFile(QString::fromStdString(file.string()));
}

/// What a list of recordings says of each.
inline QStringList texts(const tp::RecordingList& list) {
    QStringList texts;
    for (const QVariant& row : list.rows())
        texts << row.toMap()["text"].toString();
    return texts;
}

/// The parts on which those that act on the open photograph stand, with none open yet.
struct CareParts : CareGround {
    using CareGround::CareGround;

    /// Opens a photograph and waits until its record is read.
    void open(const std::string& name = "a.jpg");
    bool rests();

    tp::CareTeller teller{narrator, earcons};
    tp::KeeperSteps steps;
    tp::CaredPhoto cared{steps};
    tp::RecordingList recordings{cared, teller};
    tp::Listening listening{player, teller};
    tp::Take take{cared, recordings, recorder, teller, [] { return QString("en"); }};
    tp::RecordingWait recording{take, listening, teller};
    tp::CareHistory history{steps, cared, *album, recording, teller};
};

/// An album whose photograph has a memo of 2 s and a story of 1 s; it is open.
struct TwoRecordings : CareParts {
    std::string memo, story;
    TwoRecordings();
    std::filesystem::path file(const std::string& recording) const;
};

/// A session of that person.
struct CareBench : CareGround {
    explicit CareBench(const std::vector<std::string>& names = {"a.jpg"}, bool with_folder = true,
                       bool pictures = false);

    /// The program begins: album, session.
    void start();
    /// Opens a photograph and waits until its record is read.
    void open(const std::string& name);
    /// All steps asked for are done.
    bool rests();

    std::unique_ptr<tp::CareSession> session;
};

/// Waits, however busy the machine is.
#define CARE_TRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, 60'000)
#define CARE_TRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, 60'000)
