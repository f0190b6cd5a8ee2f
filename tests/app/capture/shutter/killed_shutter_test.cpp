// SPDX-License-Identifier: Apache-2.0
// A photograph of which "taken" was said is never lost, and none is ever half there: a process that takes photographs is killed just
// before one of its calls to the disk, or half-way through a write, or that call and all later ones fail. TP_MOMENTS=300 tries as
// many moments.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "checked_album.hpp"
#include "faces/decode/picture.hpp"
#include "faulty_run.hpp"
#include "places.hpp"

#include <QTest>

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

struct Told {
    std::vector<std::string> photos; ///< that were acknowledged with their sidecars
    std::vector<std::string> bare;   ///< whose sidecars could not be written, as was said
    std::string moment;
    std::set<std::string> away; ///< taken back, or about to be
    bool ended = false;
    bool said_why = true; ///< each refusal was a sentence
};

Told told_in(const QByteArray& output) {
    Told told;
    for (const QByteArray& line : output.split('\n')) {
        const std::string text = line.toStdString();
        const auto rest = [&text](const char* begin) { return text.substr(std::string(begin).size()); };
        if (text.starts_with("ACK photo "))
            told.photos.push_back(rest("ACK photo "));
        else if (text.starts_with("ACK bare "))
            told.bare.push_back(rest("ACK bare "));
        else if (text.starts_with("ACK moment "))
            told.moment = rest("ACK moment ");
        else if (text.starts_with("TRY undo "))
            told.away.insert(rest("TRY undo "));
        else if (text.starts_with("SAID "))
            told.said_why = told.said_why && text.size() > 20 && text.ends_with('.');
        else if (text == "END")
            told.ended = true;
    }
    return told;
}

struct Scene {
    AlbumFolder album, place;
    fs::path sound = a_sound(place, "moment.wav", 0.2, 440.0);

    Told run(const QByteArray& fault, long* calls = nullptr) {
        const QByteArray said = test::faulty_run(
            test::in_build("tests/app/capture/shutter/shutter_worker"),
            {QString::fromStdString(album.path().string()), QString::fromStdString(sound.string())},
            album.path(), fault, place / "calls");
        if (calls)
            *calls = test::calls_in(place / "calls");
        return told_in(said);
    }
    fs::path taken(const std::string& name) const { return album / "taken" / name; }
};

/// Empty, or why this is not a whole photograph.
std::string half(const fs::path& photo) {
    const auto picture = read_picture(photo);
    const auto record = read_record(photo);
    if (!picture)
        return picture.error();
    return picture->cols == 800 && record && record->taken.starts_with("2026-11-26T14:03:22") ? ""
                                                                                              : "no EXIF";
}

/// What is wrong after that, whatever happened; empty: nothing.
std::string wrong_with(const Scene& scene, const Told& told) {
    if (!told.said_why)
        return "a refusal was no sentence";
    for (const auto& file : fs::recursive_directory_iterator(scene.album.path()))
        if (file.path().extension() == ".jpg" && !is_temporary(file.path()))
            if (const std::string why = half(file.path()); !why.empty())
                return file.path().string() + " is half a photograph: " + why;
    test::checked(scene.album.path(), true);
    if (const auto left = test::checked(scene.album.path(), false).findings; !left.empty())
        return "left after mending: " + left.front().sentence;
    const auto lost = [&](const std::string& name) {
        return !fs::exists(scene.taken(name)) && !told.away.contains(name);
    };
    for (const std::string& name : told.photos) {
        if (lost(name))
            return "lost: " + name;
        if (told.away.contains(name)) // half-way to the trash, its sidecar may be there already
            continue;
        const auto record = read_record(scene.taken(name));
        if (!record || record->content_hash != *content_hash(scene.taken(name)) ||
            record->persons.size() != 1)
            return "the sidecar is lost of " + name;
    }
    for (const std::string& name : told.bare)
        if (lost(name))
            return "lost: " + name;
    if (!told.moment.empty()) {
        const auto record =
            read_record(scene.taken(told.photos.empty() ? told.bare.front() : told.photos.front()));
        if (!record || record->tags.size() != 1 || record->tags[0].file != told.moment)
            return "lost: the sound of the moment";
    }
    return {};
}

} // namespace

class KilledShutterTest : public QObject {
    Q_OBJECT
private slots:
    void a_process_that_is_left_alone_acknowledges_everything() {
        Scene scene;
        long calls = 0;
        const Told told = scene.run("none@1", &calls);
        QVERIFY(calls > 30);
        QVERIFY(told.ended && told.bare.empty() && !told.moment.empty());
        QCOMPARE(told.photos.size(), std::size_t{4});
        QCOMPARE(wrong_with(scene, told), std::string());
    }

    void nothing_acknowledged_is_lost() {
        long calls = 0;
        {
            Scene scene;
            scene.run("none@1", &calls);
        }
        const std::vector<QByteArray> faults = test::random_faults(60, calls, test::mostly_kills, 20261126);
        std::size_t cut_off = 0;
        for (const QByteArray& fault : faults) {
            Scene scene;
            const Told told = scene.run(fault);
            cut_off += !told.ended;
            const std::string wrong = wrong_with(scene, told);
            QVERIFY2(wrong.empty(), (fault.toStdString() + ": " + wrong).c_str());
        }
        QVERIFY2(cut_off >= faults.size() / 3, "the faults did not reach the process");
    }
};

QTEST_GUILESS_MAIN(KilledShutterTest)
#include "killed_shutter_test.moc"
