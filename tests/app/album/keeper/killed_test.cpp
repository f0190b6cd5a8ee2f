// SPDX-License-Identifier: Apache-2.0
// Nothing that was acknowledged is lost: a process at work on an album is killed just before one of its calls
// to the disk, or half-way through a write, or that call and all later ones fail. TP_MOMENTS=1000 tries as
// many moments. That process is this program too, so that what is killed is the room as it is linked here.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "album_worker.hpp"
#include "app/album/check/album_check.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/name_languages.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "audio/recordings/recording_file.hpp"
#include "faulty_run.hpp"
#include "made_video.hpp"

#include <QCoreApplication>
#include <QTest>

#include <algorithm>
#include <set>
#include <string_view>

using namespace tp;
namespace fs = std::filesystem;
using Kind = Finding::Kind;

namespace {

constexpr const char* works = "works-on-an-album"; ///< as the first word: this is the process that is killed

struct Told {
    std::vector<std::string> acknowledged;
    std::vector<std::string> refused;
    std::string last_try; ///< what was being done when it ended; empty: it ended by itself
    bool said_why = true; ///< each refusal was a sentence
    bool disk_worked = true;
};

Told told_in(const QByteArray& output) {
    Told told;
    for (const QByteArray& line : output.split('\n')) {
        const std::string text = line.toStdString();
        if (text.starts_with("TRY "))
            told.last_try = text.substr(4);
        else if (text.starts_with("ACK "))
            told.acknowledged.push_back(text.substr(4));
        else if (text.starts_with("SAID ")) {
            told.refused.push_back(text.substr(5, text.find(": ") - 5));
            told.said_why = told.said_why && text.size() > 20 && text.ends_with('.');
        } else if (text == "END")
            told.last_try.clear();
    }
    return told;
}

/// A photograph with a video in it that sounds.
const std::string& motion_photo() {
    static const std::string photo = [] {
        const AlbumFolder place;
        if (!test::make_video(place / "video"))
            qFatal("ffmpeg, which makes the test's video, is not installed or fails");
        const std::string video = place.read("video");
        return test::made_motion_photo(test::motion_photo_1(video.size()), video);
    }();
    return photo;
}

/// One album, one card, and a process that works on them.
struct Scene {
    AlbumFolder album, card, place;
    fs::path sound = a_sound(place, "memo.wav", 0.5, 440.0);
    std::map<std::string, std::string> card_files;

    Scene() {
        a_photo(card, "IMG_1.JPG", 1);
        card.write("IMG_1.JPG.contours.svg", "<svg/>");
        a_photo(card, "IMG_2.JPG", 2);
        a_sound(card, "IMG_2.WAV", 0.3, 300.0);
        card.write("IMG_3.JPG", motion_photo());
        card_files = card.files();
    }

    fs::path bundle() const { return album / "export" / "b.touchphoto"; }

    Told run(const QByteArray& fault, long* calls = nullptr) {
        fs::create_directory(album / "export");
        const fs::path count = place / "calls";
        Told told = told_in(test::faulty_run(
            QCoreApplication::applicationFilePath(),
            {QString::fromLatin1(works), QString::fromStdString(album.path().string()),
             QString::fromStdString(card.path().string()), QString::fromStdString(sound.string()),
             QString::fromStdString(bundle().string())},
            album.path(), fault, count));
        if (calls)
            *calls = test::calls_in(count);
        told.disk_worked = !fault.startsWith('E');
        return told;
    }
};

std::string as_text(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings)
        text += std::string(name_of(finding.kind)) + ": " + finding.sentence + " " + finding.problem + "\n";
    return text;
}

CheckReport checked(const fs::path& album, bool mend) {
    CheckOptions options;
    options.mend = mend;
    const auto report = check_album(album, options);
    return report
               ? *report
               : CheckReport{0, 0, {{Kind::damaged_trash, album, report.error(), {}, false, {}}}, {}, false};
}

/// All FLAC files of the album, the trash too.
std::vector<fs::path> sounds_in(const fs::path& album) {
    std::vector<fs::path> sounds;
    for (const auto& file : fs::recursive_directory_iterator(album))
        if (file.is_regular_file() && about_recording(file.path()).ok())
            sounds.push_back(file.path());
    return sounds;
}

} // namespace

class KilledTest : public QObject {
    Q_OBJECT

    /// What the test holds an album to, whatever happened to the process that worked on it. Empty, or what is
    /// wrong.
    static std::string wrong_with(Scene& scene, const Told& told) {
        const fs::path album = scene.album.path(), photo = album / "IMG_1.JPG";
        if (scene.card.files() != scene.card_files)
            return "the card was changed";
        if (!told.said_why)
            return "a refusal was no sentence";
        // Before anything is mended: nothing half-written has its place, and nothing listed is gone
        // unexplained.
        for (const Finding& finding : checked(album, false).findings)
            if (finding.kind == Kind::unreadable_recording || finding.kind == Kind::unreadable_sidecar ||
                finding.kind == Kind::changed_photo || finding.kind == Kind::damaged_trash ||
                (finding.kind == Kind::missing_recording && finding.mend.empty()))
                return "found: " + as_text({finding});
        for (int i = 1; i <= 3; ++i) {
            const std::string name = "IMG_" + std::to_string(i) + ".JPG";
            if (fs::exists(album / name) && scene.album.read(name) != scene.card_files.at(name))
                return name + " is half-written";
        }
        if (const AlbumFolder out; fs::exists(scene.bundle()))
            if (const std::string problem = unpack_bundle(scene.bundle(), out.path()); !problem.empty())
                return "half a bundle: " + problem;
        // The next start mends what was in flight.
        checked(album, true);
        for (const std::string& id : unfinished_imports(album))
            if (const auto report = go_on_importing(album, id, {});
                !report || report->count(ImportedPhoto::Fate::failed))
                return "the import cannot go on";
        checked(album, true);
        if (const auto left = checked(album, false).findings; !left.empty())
            return "left after mending: " + as_text(left);
        for (const char* name : {"IMG_2.JPG", "IMG_3.JPG"}) // their sound: once, and after a kill not never
            if (fs::exists(album / name)) {
                const auto record = read_record(album / name);
                const std::size_t sounds = record ? record->tags.size() : 0;
                if (sounds > 1 || (sounds == 0 && told.refused.empty() && told.disk_worked))
                    return std::to_string(sounds) + " sounds came with " + name;
            }
        return lost(scene, told);
    }

    /// What was acknowledged and is not there.
    static std::string lost(const Scene& scene, const Told& told) {
        const fs::path album = scene.album.path(), photo = album / "IMG_1.JPG";
        const auto record = fs::exists(photo) ? read_record(photo) : Result<PhotoRecord>(PhotoRecord{});
        if (!record)
            return record.error();
        const std::vector<fs::path> sounds = sounds_in(album);
        double longest = 0.0;
        for (const fs::path& sound : sounds)
            longest = std::max(longest, about_recording(sound)->seconds());
        std::set<std::string> listed;
        for (const Tag& tag : record->tags)
            listed.insert(tag.file);
        std::set<std::string> away; // a person wanted them in the trash, and there they may be
        const auto put_away = [&](const std::string& step) {
            if (step.starts_with("delete ") || step.starts_with("trim "))
                away.insert(step.substr(step.find(' ') + 1));
        };
        for (const std::string& step : told.acknowledged)
            if (step.starts_with("restore "))
                away.erase(step.substr(8));
            else
                put_away(step);
        for (const std::string& step : told.refused) // a disk that fails may not let it be taken back
            put_away(step);
        put_away(told.last_try);
        if (told.last_try.starts_with("restore "))
            away.insert(told.last_try.substr(8));
        for (const std::string& step : told.acknowledged) {
            if (step.starts_with("photo ") && !fs::exists(album / step.substr(6)))
                return "lost: " + step;
            if (step.starts_with("frames ") && longest * 48'000.0 < std::stod(step.substr(7)))
                return "lost sound: " + step + " of " + std::to_string(longest * 48'000.0);
            if (step.starts_with("tag ") && !listed.contains(step.substr(4)) &&
                !away.contains(step.substr(4)))
                return "lost from the list: " + step;
            if (step == "face Anna" && (record->faces.empty() || record->faces[0].name != "Anna"))
                return "lost: " + step;
            if (step.starts_with("name Anna") && !AlbumKeeper(album).name_recording("Anna"))
                return "lost: " + step;
            if (step.starts_with("language ")) {
                AlbumKeeper keeper(album);
                const auto language = NameLanguages(keeper).of("Anna"); // this one, or the one that was tried next
                if (!language || (*language != "de" && *language != step.substr(9)))
                    return "lost: " + step;
            }
            if (step == "text" && !record->alt_text.contains("x-default"))
                return "lost: " + step;
            if (step.starts_with("bundle") && !fs::exists(scene.bundle()))
                return "lost: " + step;
        }
        std::size_t acknowledged_tags = 0;
        for (const std::string& step : told.acknowledged)
            acknowledged_tags += step.starts_with("tag ");
        return sounds.size() >= acknowledged_tags ? std::string{} : "a recording is lost";
    }

private slots:
    void a_process_that_is_left_alone_acknowledges_everything() {
        Scene scene;
        long calls = 0;
        const Told told = scene.run("none@1", &calls);
        QVERIFY(calls > 100);
        QCOMPARE(told.last_try, std::string());
        QCOMPARE(told.acknowledged.size(), std::size_t{22});
        QCOMPARE(wrong_with(scene, told), std::string());
    }

    void nothing_acknowledged_is_lost() {
        long calls = 0;
        {
            Scene scene;
            scene.run("none@1", &calls);
        }
        const std::vector<QByteArray> faults = test::random_faults(100, calls, test::mostly_kills, 20261121);
        std::size_t cut_off = 0;
        for (const QByteArray& fault : faults) {
            Scene scene;
            const Told told = scene.run(fault);
            cut_off += !told.last_try.empty();
            const std::string wrong = wrong_with(scene, told);
            QVERIFY2(wrong.empty(), (fault.toStdString() + " while " + told.last_try + ": " + wrong).c_str());
        }
        QVERIFY2(cut_off >= faults.size() / 3, "the faults did not reach the process");
    }
};

int main(int count, char** words) {
    if (count == 6 && std::string_view(words[1]) == works) {
        test::work_on_album(words[2], words[3], words[4], words[5]);
        return 0;
    }
    const QCoreApplication app(count, words);
    KilledTest killed;
    return QTest::qExec(&killed, count, words);
}
#include "killed_test.moc"
