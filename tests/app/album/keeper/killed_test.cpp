// SPDX-License-Identifier: Apache-2.0
// Nothing that was acknowledged is lost: a process at work on an album is killed just before one of its calls
// to the disk, or half-way through a write, or that call and all later ones fail; alone, with exiftool beside
// it and with a second process of ours. TP_MOMENTS=1000 tries as many moments. Those processes are this program
// too, so that what is killed is the room as it is linked here.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "album_worker.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/bundle.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/name_languages.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "checked_album.hpp"
#include "faulty_run.hpp"
#include "made_video.hpp"

#include <QCoreApplication>
#include <QProcess>
#include <QStandardPaths>
#include <QTest>

#include <algorithm>
#include <random>
#include <set>
#include <string_view>

using namespace tp;
namespace fs = std::filesystem;
using Kind = Finding::Kind;
using tp::test::checked;
using tp::test::sounds_in;

namespace {

constexpr const char* works = "works-on-an-album"; ///< as the first word: this is the process that is killed
constexpr const char* joins = "joins-in";          ///< and this the one that works beside it

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

    /// `from_face`: the calls are those from the step "face Anna" on.
    Told run(const QByteArray& fault, long* calls = nullptr, const QString& beside = {},
             bool from_face = false) {
        fs::create_directory(album / "export");
        const fs::path count = place / "calls";
        QProcessEnvironment surroundings = QProcessEnvironment::systemEnvironment();
        if (!beside.isEmpty())
            surroundings.insert("TP_BESIDE", beside);
        if (from_face)
            surroundings.insert("TP_FAULT_WAITS", "1");
        Told told = told_in(test::faulty_run(
            QCoreApplication::applicationFilePath(),
            {QString::fromLatin1(works), QString::fromStdString(album.path().string()),
             QString::fromStdString(card.path().string()), QString::fromStdString(sound.string()),
             QString::fromStdString(bundle().string())},
            album.path(), fault, count, surroundings));
        if (calls)
            *calls = test::calls_in(count);
        told.disk_worked = !fault.startsWith('E');
        return told;
    }

    /// The same, and another process adds, labels and names at the same photograph until it is killed too.
    Told run_in_company(const QByteArray& fault) {
        QProcess other;
        other.start(QCoreApplication::applicationFilePath(),
                    {QString::fromLatin1(joins), QString::fromStdString((album / "IMG_1.JPG").string()),
                     QString::fromStdString(sound.string())});
        Told told = run(fault);
        other.kill();
        other.waitForFinished();
        const Told others = told_in(other.readAllStandardOutput());
        told.acknowledged.insert(told.acknowledged.end(), others.acknowledged.begin(),
                                 others.acknowledged.end());
        told.said_why = told.said_why && others.said_why;
        return told;
    }

    /// A program that adds this keyword to the photograph's sidecar with exiftool, where there is one, and
    /// acknowledges it.
    QString exiftool_adds(const std::string& keyword) {
        const fs::path program = place / "exiftool_adds";
        place.write("exiftool_adds", "#!/bin/sh\n"
                                     "sidecar='" +
                                         (album / "IMG_1.JPG.xmp").string() +
                                         "'\n"
                                         "[ -e \"$sidecar\" ] || exit 0\n"
                                         "exiftool -q -q -overwrite_original -XMP-dc:Subject+=" +
                                         keyword + " \"$sidecar\" && echo \"ACK keyword " + keyword + "\"\n");
        fs::permissions(program, fs::perms::owner_exec, fs::perm_options::add);
        return QString::fromStdString(program.string());
    }
};

std::string as_text(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings)
        text += std::string(name_of(finding.kind)) + ": " + finding.sentence + " " + finding.problem + "\n";
    return text;
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
        auto left = checked(album, false).findings;
        if (std::ranges::count(told.refused, "face Anna") >
            0) // how her name sounds may have been kept all the same
            std::erase_if(left, [](const Finding& finding) {
                return finding.kind == Kind::left_behind && finding.file.stem() == "Anna";
            });
        if (!left.empty())
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
            if (step.starts_with("face ") && std::ranges::none_of(record->faces, [&](const FaceRegion& face) {
                    return face.name == step.substr(5);
                }))
                return "lost: " + step;
            if (step.starts_with("keyword ") &&
                std::ranges::find(record->keywords, step.substr(8)) == record->keywords.end())
                return "lost: " + step;
            if (step.starts_with("name ") &&
                !AlbumKeeper(album).name_recording(step.starts_with("name Ben") ? "Ben" : "Anna"))
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

    /// Whatever exiftool was told to add, and said that it did, is in the sidecar: before, in the moment of and
    /// after an exchange, and when ours is killed soon after.
    void nothing_that_exiftool_acknowledged_is_lost() {
        if (QStandardPaths::findExecutable("exiftool").isEmpty())
            QSKIP("exiftool is missing (package libimage-exiftool-perl)");
        long calls = 0;
        {
            Scene scene;
            scene.run("none@1", &calls);
        }
        std::mt19937 random(20261128);
        std::size_t added = 0;
        const std::vector<QByteArray> kills = test::random_faults(30, calls, {"kill@"}, 20261129);
        for (const QByteArray& kill : kills) {
            Scene scene;
            const long at = kill.mid(5).toLong();
            const long before = std::min<long>(at - 1, static_cast<long>(random() % 12));
            const QString beside =
                scene.exiftool_adds("Vienna") + QLatin1Char('@') + QString::number(at - before);
            const Told told = scene.run(kill, nullptr, beside);
            added += std::ranges::find(told.acknowledged, "keyword Vienna") != told.acknowledged.end();
            const std::string wrong = wrong_with(scene, told);
            QVERIFY2(wrong.empty(), (kill.toStdString() + ", exiftool " + std::to_string(before) +
                                     " calls before, while " + told.last_try + ": " + wrong)
                                        .c_str());
        }
        QVERIFY2(added >= kills.size() / 3, "exiftool added too seldom");
    }

    /// The same at every call of one step, and so between ours taking the place of theirs and holding both; killed, or
    /// refused once by the disk.
    void what_exiftool_writes_while_ours_is_written_is_not_lost() {
        if (QStandardPaths::findExecutable("exiftool").isEmpty())
            QSKIP("exiftool is missing (package libimage-exiftool-perl)");
        for (const char* ends : {"kill@", "EIO-once@"})
            for (int call = 2; call <= 10; ++call)
                for (int beside = std::max(1, call - 4); beside < call; ++beside) {
                    Scene scene;
                    const QByteArray fault = ends + QByteArray::number(call);
                    const Told told = scene.run(
                        fault, nullptr,
                        scene.exiftool_adds("Vienna") + QLatin1Char('@') + QString::number(beside), true);
                    QVERIFY(std::ranges::count(told.acknowledged, "keyword Vienna") == 1);
                    const std::string wrong = wrong_with(scene, told);
                    QVERIFY2(wrong.empty(), (fault.toStdString() + ", exiftool at " + std::to_string(beside) +
                                             ", while " + told.last_try + ": " + wrong)
                                                .c_str());
                }
    }

    /// Theirs, ours, theirs over ours: what they wrote first stands in neither of the two that lie there then.
    void what_exiftool_writes_twice_while_ours_is_written_is_not_lost() {
        if (QStandardPaths::findExecutable("exiftool").isEmpty())
            QSKIP("exiftool is missing (package libimage-exiftool-perl)");
        for (int first = 2; first <= 4; ++first)
            for (int again = 6; again <= 9; ++again) {
                Scene scene;
                const QString calls = QString("@%1,%2").arg(first).arg(again);
                const Told told = scene.run("none@1", nullptr, scene.exiftool_adds("Vienna$$") + calls, true);
                QVERIFY(std::ranges::count_if(told.acknowledged, [](const std::string& step) {
                            return step.starts_with("keyword Vienna");
                        }) == 2);
                const std::string wrong = wrong_with(scene, told);
                QVERIFY2(wrong.empty(), (calls.toStdString() + ": " + wrong).c_str());
            }
    }

    void nothing_that_two_at_once_acknowledged_is_lost() {
        long calls = 0;
        {
            Scene scene;
            scene.run("none@1", &calls);
        }
        std::size_t others = 0;
        const std::vector<QByteArray> faults = test::random_faults(30, calls, test::mostly_kills, 20261130);
        for (const QByteArray& fault : faults) {
            Scene scene;
            const Told told = scene.run_in_company(fault);
            others += std::ranges::find(told.acknowledged, "face Ben") != told.acknowledged.end();
            const std::string wrong = wrong_with(scene, told);
            QVERIFY2(wrong.empty(), (fault.toStdString() + " while " + told.last_try + ": " + wrong).c_str());
        }
        QVERIFY2(others >= faults.size() / 3, "the other process came too seldom");
    }
};

int main(int count, char** words) {
    if (count == 6 && std::string_view(words[1]) == works) {
        test::work_on_album(words[2], words[3], words[4], words[5]);
        return 0;
    }
    if (count == 4 && std::string_view(words[1]) == joins) {
        test::work_beside(words[2], words[3]);
        return 0;
    }
    const QCoreApplication app(count, words);
    KilledTest killed;
    return QTest::qExec(&killed, count, words);
}
#include "killed_test.moc"
