// SPDX-License-Identifier: Apache-2.0
#include "care_bench.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "heard_earcon.hpp"
#include "sound_files.hpp"

#include <QColor>
#include <QImage>
#include <QPainter>
#include <QPoint>

#include <chrono>

using namespace tp;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

fs::path a_picture(const AlbumFolder& folder, const fs::path& name, int number) {
    QImage image(240, 160, QImage::Format_RGB32);
    image.fill(QColor::fromHsv((number * 67) % 360, 120, 180));
    QPainter painter(&image);
    painter.setBrush(QColor(230, 200, 180));
    painter.drawEllipse(QPoint(120, 80), 40, 55);
    painter.end();
    const fs::path file = folder / name;
    fs::create_directories(file.parent_path());
    if (!image.save(QString::fromStdString(file.string())))
        qFatal("cannot write %s", file.c_str());
    return file;
}

CareGround::CareGround(const std::vector<std::string>& names, bool with_folder, bool pictures)
    : recorder([this] {
          auto made = std::make_unique<tp::testing::FakeMicrophone>();
          microphone = made.get();
          return made;
      }) {
    fs::create_directories(folder / "album");
    int number = 0;
    for (const std::string& name : names) {
        ++number;
        if (pictures)
            a_picture(folder, fs::path("album") / name, number);
        else
            a_photo(folder, fs::path("album") / name, number);
    }
    if (with_folder)
        preferences.change(
            [this](Choices& choices) { choices.folders << QString::fromStdString((folder / "album").string()); });
    preferences.change([](Choices& choices) { choices.language = "en"; });
    open_album();
}

void CareGround::open_album() {
    groups.reset();
    album.reset();
    album = std::make_unique<OpenAlbum>(folder / "cache", preferences, AlbumWatcher::Times{0ms, 1h});
    CARE_TRY_VERIFY(!album->scanning());
    groups = std::make_unique<AlbumFaces>(*album);
}

void CareParts::open(const std::string& name) {
    cared.open({photo(name), &album->keeper_for(photo(name))});
    CARE_TRY_VERIFY(rests());
}

bool CareParts::rests() {
    return QTest::qWaitFor([this] { return !steps.busy() && !album->scanning(); }, 60'000);
}

TwoRecordings::TwoRecordings()
    : memo(add_sound("a.jpg", 2.0, 300.0, RecordingKind::memo)),
      story(add_sound("a.jpg", 1.0, 500.0, RecordingKind::story)) {
    open("a.jpg");
}

fs::path TwoRecordings::file(const std::string& recording) const {
    return tags_folder(photo("a.jpg")) / recording;
}

CareBench::CareBench(const std::vector<std::string>& names, bool with_folder, bool pictures)
    : CareGround(names, with_folder, pictures) {
    session =
        std::make_unique<CareSession>(*album, *groups, narrator, earcons, recorder, player, preferences);
}

void CareBench::start() {
    session.reset();
    open_album();
    session =
        std::make_unique<CareSession>(*album, *groups, narrator, earcons, recorder, player, preferences);
}

void CareBench::open(const std::string& name) {
    session->open_photo(photo(name));
    CARE_TRY_VERIFY(rests());
}

bool CareBench::rests() {
    return QTest::qWaitFor([this] { return !session->busy() && !album->scanning(); }, 60'000);
}

PhotoRecord CareGround::record(const std::string& name) const {
    auto record = read_record(photo(name));
    return record ? *record : PhotoRecord{};
}

std::string CareGround::add_sound(const std::string& name, double seconds, double hertz, RecordingKind kind) {
    const fs::path sound = a_sound(folder, "sounds/" + std::to_string(hertz) + ".wav", seconds, hertz);
    const auto added = album->keeper_for(photo(name)).add_recording(photo(name), sound, {kind, {}, {}, {}, {}, {}});
    return added ? added->tag.file : added.error();
}

void CareGround::hear(double seconds) {
    CARE_TRY_VERIFY(microphone.load() != nullptr);
    CARE_TRY_VERIFY(recorder.state() != RecorderState::idle);
    tp::testing::FakeMicrophone* const made = microphone;
    QMetaObject::invokeMethod(
        made, [made, seconds] { made->hear(tp::testing::tone(440.0, seconds, sound_rate)); }, Qt::BlockingQueuedConnection);
    CARE_TRY_COMPARE(recorder.state(), RecorderState::recording);
}

bool CareGround::sounded(Earcon earcon) { return testing::heard_earcon(earcon_loudspeaker, earcon); }
