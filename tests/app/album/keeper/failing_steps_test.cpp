// SPDX-License-Identifier: Apache-2.0
// Steps on an album whose disk refuses in the middle: all of a step is done, or none, or it is said what was left.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/name_languages.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "audio/recordings/recording_file.hpp"
#include "named_place.hpp"

#include <QTest>

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <string_view>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

std::string refused; ///< no file with this in its path is moved or gets its name; empty: each is
int let_through = 0; ///< as many are all the same
int refusals = 0;    ///< as many at most

bool is_refused(int folder, const char* name) {
    if (refused.empty() || test::named_place(folder, name).find(refused) == std::string_view::npos ||
        let_through-- > 0 || refusals-- <= 0)
        return false;
    errno = ENOSPC;
    return true;
}

} // namespace

extern "C" int renameat2(int old_folder, const char* from, int new_folder, const char* to,
                         unsigned flags) noexcept {
    if (is_refused(new_folder, to))
        return -1;
    return static_cast<int>(::syscall(SYS_renameat2, old_folder, from, new_folder, to, flags));
}

extern "C" int renameat(int old_folder, const char* from, int new_folder, const char* to) noexcept {
    return ::renameat2(old_folder, from, new_folder, to, 0);
}

class FailingStepsTest : public QObject {
    Q_OBJECT

    static PhotoRecord record_of(const fs::path& photo) {
        const auto record = read_record(photo);
        return record ? *record : PhotoRecord{};
    }
    /// What a step says while the disk refuses.
    template <typename Step>
    static std::string said(const std::string& part, int through, Step step, int times = 1'000) {
        refused = part;
        let_through = through;
        refusals = times;
        std::string problem = step();
        refused.clear();
        return problem;
    }
    static bool is_full(const std::string& problem) {
        return problem.find("the disk is full.") != std::string::npos;
    }

private slots:
    void init() { refused.clear(); }
    void cleanup() { init(); }

    void companions_go_along_all_or_none() {
        const AlbumFolder album;
        const fs::path from = album / "a.jpg", to = album.write("2026/b.jpg", "photo");
        album.write("a.jpg.contours.svg", "svg");
        album.write("a.jpg.tags/1.flac", "sound");
        album.write("a.jpg.xmp", "sidecar");
        const auto before = album.files();
        AlbumKeeper keeper(album.path());
        for (const char* stuck : {"b.jpg.contours.svg", "b.jpg.tags", "b.jpg.xmp"}) {
            const std::string problem = said(stuck, 0, [&] { return keeper.move_companions(from, to); });
            QVERIFY2(problem.find(" cannot be moved: the disk is full.") != std::string::npos,
                     problem.c_str());
            QVERIFY2(album.files() == before, stuck);
        }
        QCOMPARE(keeper.move_companions(from, to), std::string());
        QCOMPARE(companions_of(to).size(), std::size_t{3});
        album.write("a.jpg.xmp", "another");
        QVERIFY(keeper.move_companions(from, to).ends_with(" already exists, so nothing was moved."));
        QCOMPARE(album.read("2026/b.jpg.xmp"), std::string("sidecar"));
    }

    void a_person_is_renamed_everywhere_or_nowhere() {
        const AlbumFolder album;
        std::vector<fs::path> photos;
        AlbumKeeper keeper(album.path());
        for (const char* name : {"a.jpg", "b.jpg", "c.jpg"}) {
            photos.push_back(a_photo(album, name, 1));
            QCOMPARE(keeper.name_face(photos.back(), {0.5, 0.5, 0.2, 0.2, "Anna"}), std::string());
        }
        const auto names = [&] {
            std::string all;
            for (const fs::path& photo : photos)
                all += record_of(photo).faces.at(0).name + " " + record_of(photo).persons.at(0) + " ";
            return all;
        };
        const std::size_t steps = keeper.history().steps();
        const std::string problem = said(
            "c.jpg.xmp", 0, [&] { return keeper.rename_person(photos, "Anna", "Eva").error(); }, 1);
        QVERIFY2(is_full(problem) && problem.find("kept the new name") == std::string::npos, problem.c_str());
        QCOMPARE(names(), std::string("Anna Anna Anna Anna Anna Anna "));
        QCOMPARE(keeper.history().steps(), steps);
        const std::string stuck =
            said(".jpg.xmp", 2, [&] { return keeper.rename_person(photos, "Anna", "Eva").error(); });
        QVERIFY2(is_full(stuck) && stuck.find(" Some photographs kept the new name: ") != std::string::npos,
                 stuck.c_str());
        QCOMPARE(names(), std::string("Eva Eva Eva Eva Anna Anna "));
        QCOMPARE(keeper.rename_person(photos, "Anna", "Eva").value(), std::size_t{1});
        QVERIFY(is_full(said("c.jpg.xmp", 0, [&] { return keeper.history().undo(); })));
        QCOMPARE(keeper.history().undo(), std::string());
        QVERIFY(is_full(said("c.jpg.xmp", 0, [&] { return keeper.history().redo(); })));
        QCOMPARE(names(), std::string("Eva Eva Eva Eva Anna Anna "));
        QCOMPARE(keeper.history().redo(), std::string());
        QCOMPARE(names(), std::string("Eva Eva Eva Eva Eva Eva "));
    }

    void faces_are_named_all_or_none() {
        const AlbumFolder album;
        const fs::path a = a_photo(album, "a.jpg", 1), b = a_photo(album, "b.jpg", 2);
        AlbumKeeper keeper(album.path());
        const std::vector<AlbumKeeper::FaceToName> faces{{a, {0.5, 0.5, 0.2, 0.2, "Eva"}},
                                                         {b, {0.3, 0.3, 0.2, 0.2, "Eva"}}};
        const auto count = [&] { return record_of(a).faces.size() + record_of(b).faces.size(); };
        const std::string problem = said("b.jpg.xmp", 0, [&] { return keeper.name_faces(faces); });
        QVERIFY2(is_full(problem) && problem.find("kept the new name") == std::string::npos, problem.c_str());
        QCOMPARE(count(), std::size_t{0});
        QCOMPARE(keeper.history().steps(), std::size_t{0});
        const std::string stuck = said(".jpg.xmp", 1, [&] { return keeper.name_faces(faces); });
        QVERIFY2(stuck.find(" Some photographs kept the new name: ") != std::string::npos, stuck.c_str());
        QCOMPARE(count(), std::size_t{1});
        QCOMPARE(keeper.name_faces(faces), std::string());
        const std::string left = said("b.jpg.xmp", 0, [&] { return keeper.history().undo(); });
        QVERIFY2(is_full(left), left.c_str());
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(count(), std::size_t{1}); // the one that had the name before
        QCOMPARE(keeper.history().redo(), std::string());
        QCOMPARE(count(), std::size_t{2});
    }

    void a_recording_that_cannot_be_put_away_stays_on_its_photograph() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1), sound = a_sound(album, "s.wav", 0.5, 300.0);
        AlbumKeeper keeper(album.path());
        const std::string file = keeper.add_recording(photo, sound, {})->tag.file;
        const auto before = album.files();
        for (const char* stuck : {"a.jpg.xmp", "list.json", "/0"}) {
            QVERIFY2(is_full(said(stuck, 0, [&] { return keeper.delete_recording(photo, file); })), stuck);
            QVERIFY2(album.files() == before, stuck);
            QVERIFY(keeper.trash().entries().empty());
            QVERIFY2(is_full(said(stuck, 0, [&] { return keeper.history().undo(); })), stuck);
            QVERIFY2(album.files() == before, stuck);
        }
        QCOMPARE(keeper.history().steps(), std::size_t{1});
        QCOMPARE(keeper.delete_recording(photo, file), std::string());
        QVERIFY(is_full(said("a.jpg.tags", 0, [&] { return keeper.history().undo(); })));
        QCOMPARE(keeper.history().undo(), std::string());
        QVERIFY(is_full(said("list.json", 0, [&] { return keeper.history().redo(); })));
        QCOMPARE(record_of(photo).tags.size(), std::size_t{1});
        QCOMPARE(keeper.history().redo(), std::string());
        QVERIFY(record_of(photo).tags.empty());
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(record_of(photo).tags.size(), std::size_t{1});
    }

    void a_part_is_of_no_use_beside_the_whole() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1), sound = a_sound(album, "s.wav", 0.5, 300.0);
        AlbumKeeper keeper(album.path());
        const std::string file = keeper.add_recording(photo, sound, {})->tag.file;
        for (const char* stuck : {"a.jpg.xmp", "list.json"}) {
            const std::string problem =
                said(stuck, 0, [&] { return keeper.trim_recording(photo, file, 0.1, 0.4).error(); });
            QVERIFY2(is_full(problem), problem.c_str());
            QCOMPARE(std::distance(fs::directory_iterator(tags_folder(photo)), {}), std::ptrdiff_t{1});
            QCOMPARE(record_of(photo).tags.at(0).file, file);
            QCOMPARE(record_of(photo).tags.size(), std::size_t{1});
        }
        QCOMPARE(keeper.history().steps(), std::size_t{1});
        const auto part = keeper.trim_recording(photo, file, 0.1, 0.4);
        QVERIFY2(part.ok(), part.error().c_str());
        QVERIFY(is_full(said("a.jpg.tags/" + file, 0, [&] { return keeper.history().undo(); })));
        QCOMPARE(record_of(photo).tags.at(0).file, part->file);
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(record_of(photo).tags.at(0).file, file);
    }

    /// The one before stays what is said; nothing else is left beside it.
    void a_name_that_cannot_be_saved_leaves_the_earlier_one() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        const fs::path sound = a_sound(album, "s.wav", 0.5, 300.0),
                       longer = a_sound(album, "l.wav", 0.8, 300.0);
        QVERIFY(is_full(said("Anna.flac", 0, [&] { return keeper.keep_name_recording("Anna", sound); })));
        QVERIFY(!keeper.name_recording("Anna"));
        QCOMPARE(keeper.keep_name_recording("Anna", sound), std::string());
        const std::size_t steps = keeper.history().steps();
        const auto before = album.files();
        for (const char* stuck : {"list.json", "/0", "Anna.flac"}) {
            const std::string problem = said(
                stuck, 0, [&] { return keeper.keep_name_recording("Anna", longer); }, 1);
            QVERIFY2(problem.starts_with("The name cannot be saved: ") && is_full(problem), problem.c_str());
            QVERIFY2(album.files() == before, stuck);
        }
        const std::string problem =
            said("Anna.flac", 0, [&] { return keeper.keep_name_recording("Anna", longer); });
        QVERIFY2(problem.find(" stays in the trash: ") != std::string::npos, problem.c_str());
        QCOMPARE(keeper.restore(keeper.trash().entries().at(0).id), std::string());
        QVERIFY(album.files() == before);
        QCOMPARE(keeper.history().steps(), steps);
        QCOMPARE(keeper.keep_name_recording("", longer),
                 std::string("A person needs a name before it can be recorded."));
        QCOMPARE(keeper.keep_name_recording("Anna", longer), std::string());
        QVERIFY(is_full(said("list.json", 0, [&] { return keeper.history().undo(); })));
        QCOMPARE(about_recording(*keeper.name_recording("Anna"))->seconds(), 0.8);
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(about_recording(*keeper.name_recording("Anna"))->seconds(), 0.5);
        QVERIFY(is_full(said("Eva.flac", 0, [&] { return keeper.rename_name_recording("Anna", "Eva"); })));
        QVERIFY(keeper.name_recording("Anna") && !keeper.name_recording("Eva"));
    }

    void a_language_that_cannot_be_saved_is_said() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        NameLanguages names(keeper);
        QVERIFY(is_full(said("Anna.language", 0, [&] { return names.choose("Anna", "de"); })));
        QCOMPARE(names.of("Anna").value(), std::string());
        QCOMPARE(names.choose("Anna", "de"), std::string());
        QVERIFY(is_full(said("Eva.language", 0, [&] { return names.rename("Anna", "Eva"); })));
        QCOMPARE(names.of("Anna").value(), std::string("de"));
        QCOMPARE(names.choose("Eva", "fr"), std::string());
        const std::size_t steps = keeper.history().steps();
        QVERIFY(is_full(said("list.json", 0, [&] { return names.rename("Anna", "Eva"); })));
        QCOMPARE(names.of("Anna").value(), std::string("de"));
        QCOMPARE(keeper.history().steps(), steps);
    }

    void what_can_neither_be_deleted_nor_put_back_is_known_to_be_in_the_trash() {
        const AlbumFolder album;
        album.write("a.jpg", "a");
        album.write("b.jpg", "b");
        Trash trash(album.path());
        const std::string problem = said(album.path().string(), 2, [&] {
            return trash.put({"a.jpg", "b.jpg"}, "both").error();
        });
        QCOMPARE(problem,
                 std::string("\"a.jpg\" cannot be restored and stays in the trash: the disk is full."));
        QCOMPARE(trash.entries().size(), std::size_t{1});
        QCOMPARE(trash.restore(trash.entries()[0].id), std::string());
        QCOMPARE(album.files(), (std::map<std::string, std::string>{{"a.jpg", "a"}, {"b.jpg", "b"}}));
    }

    /// A photograph without one of its recordings would not be missed by the next import.
    void a_photograph_comes_with_all_its_recordings_or_not() {
        for (const char* stuck : {"1.flac", "2.flac", "a.jpg.xmp"}) {
            const AlbumFolder card, album;
            card.write("a.jpg", "photo");
            card.write("a.jpg.xmp", "sidecar");
            card.write("a.jpg.tags/1.flac", "1");
            card.write("a.jpg.tags/2.flac", "2");
            ImportReport report;
            said((album.path() / "").string() +
                     (std::string_view(stuck) == "a.jpg.xmp" ? "" : "a.jpg.tags/") + stuck,
                 0, [&] {
                     report = import_photos(album.path(), {}, {card.path()}, {}).value();
                     return std::string();
                 });
            QCOMPARE(report.count(ImportedPhoto::Fate::failed), std::size_t{1});
            QVERIFY(is_full(report.photos.at(0).problem));
            QVERIFY2(!fs::exists(album / "a.jpg"), stuck);
            QCOMPARE(go_on_importing(album.path(), report.id, {})->count(ImportedPhoto::Fate::imported),
                     std::size_t{1});
            QVERIFY(album.files() == card.files());
        }
    }

    void a_photograph_that_cannot_be_added_or_deleted_is_said() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        QVERIFY(
            is_full(said("a.jpg", 0, [&] { return keeper.add_photo(album / "a.jpg", "new", {}).error(); })));
        QVERIFY(album.files().empty());
        const fs::path photo = a_photo(album, "a.jpg", 1);
        QCOMPARE(keeper.describe(photo, "de", "Garten", ""), std::string());
        const auto before = album.files();
        QVERIFY(is_full(said("/1", 0, [&] { return keeper.delete_photo(photo); })));
        QVERIFY(album.files() == before);
        QCOMPARE(keeper.history().steps(), std::size_t{1});
        QCOMPARE(keeper.delete_photo(photo), std::string());
        QVERIFY(is_full(said("a.jpg", 0, [&] { return keeper.history().undo(); })));
        QCOMPARE(keeper.history().undo(), std::string());
        QVERIFY(album.files() == before);
    }
};

QTEST_GUILESS_MAIN(FailingStepsTest)
#include "failing_steps_test.moc"
