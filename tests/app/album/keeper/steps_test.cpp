// SPDX-License-Identifier: Apache-2.0
// Photographs that are added, what each step is called, and steps that are taken back and made again more than once.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/importer.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "audio/recordings/recording_file.hpp"

#include <QTest>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <tuple>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

/// Another program holds every folder, and each look at its lock takes so long that patience ends.
bool somebody_works = false;
std::time_t waited_s = 0;

} // namespace

extern "C" int flock(int folder, int operation) noexcept {
    if (!somebody_works)
        return static_cast<int>(::syscall(SYS_flock, folder, operation));
    waited_s += 11;
    errno = EWOULDBLOCK;
    return -1;
}

extern "C" int clock_gettime(clockid_t clock, timespec* now) noexcept {
    const int failed = static_cast<int>(::syscall(SYS_clock_gettime, clock, now));
    now->tv_sec += waited_s;
    return failed;
}

namespace {

PhotoRecord record_of(const fs::path& photo) {
    const auto record = read_record(photo);
    return record ? *record : PhotoRecord{};
}

/// The bytes of a photograph.
std::string picture(int number) {
    const AlbumFolder place;
    a_photo(place, "a.jpg", number);
    return place.read("a.jpg");
}

/// What `step` returns where no file may become longer than so many bytes.
template <typename Step>
auto without_room(rlim_t bytes, Step step) {
    const auto previous = std::signal(SIGXFSZ, SIG_IGN);
    struct rlimit before {};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const struct rlimit small { bytes, before.rlim_max };
    ::setrlimit(RLIMIT_FSIZE, &small);
    auto said = step();
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, previous);
    return said;
}

} // namespace

class StepsTest : public QObject {
    Q_OBJECT

    /// Takes the last step back and makes it again, three times; `gone` tells whether it is taken back.
    template <typename Gone>
    static void back_and_forth(UndoHistory& history, Gone gone) {
        for (int time = 0; time < 3; ++time) {
            QCOMPARE(history.undo(), std::string());
            QVERIFY(gone());
            QCOMPARE(history.redo(), std::string());
            QVERIFY(!gone());
        }
    }

private slots:
    void a_photograph_that_was_taken_is_kept_with_who_is_on_it() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        const auto added =
            keeper.add_photo(album / "2026/may/new.jpg", picture(1), {{0.4, 0.5, 0.2, 0.3, "Anna"}});
        QVERIFY2(added.ok(), added.error().c_str());
        QCOMPARE(added->photo, album / "2026/may/new.jpg");
        QCOMPARE(added->warning, std::string());
        QCOMPARE(album.read("2026/may/new.jpg"), picture(1));
        QCOMPARE(record_of(added->photo).faces.at(0).name, std::string("Anna"));
        QCOMPARE(record_of(added->photo).content_hash, *content_hash(added->photo));
        QCOMPARE(keeper.history().next_undo(), std::string("new.jpg was added"));
        back_and_forth(keeper.history(), [&] { return !fs::exists(album / "2026/may/new.jpg"); });
        QCOMPARE(album.read("2026/may/new.jpg"), picture(1));
        QCOMPARE(record_of(added->photo).faces.at(0).name, std::string("Anna"));
        const auto nobody = keeper.add_photo(album / "b.jpg", picture(2), {});
        QVERIFY(nobody && record_of(nobody->photo).faces.empty());
        QCOMPARE(record_of(nobody->photo).content_hash, *content_hash(nobody->photo));
    }

    /// Neither a photograph nor what was left of one is taken for the new one's.
    void an_added_photograph_takes_the_first_free_name() {
        const AlbumFolder album;
        album.write("a.jpg", "another");
        album.write("a (2).jpg.tags/1.flac", "whose photograph is gone");
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.add_photo(album / "a.jpg", "new", {})->photo, album / "a (3).jpg");
        QCOMPARE(keeper.add_photo(album / "a.jpg", "newer", {})->photo, album / "a (4).jpg");
        QCOMPARE(album.read("a.jpg"), std::string("another"));
        QCOMPARE(album.read("a (3).jpg"), std::string("new"));
    }

    /// The last of ten thousand of one name, less one; then it is said, and nothing is written over.
    void there_is_an_end_to_photographs_of_one_name() {
        const AlbumFolder album;
        std::ofstream(album / "a.jpg");
        for (int number = 2; number < 9'999; ++number)
            std::ofstream(album / ("a (" + std::to_string(number) + ").jpg"));
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.add_photo(album / "a.jpg", "last", {})->photo, album / "a (9999).jpg");
        const std::string problem = keeper.add_photo(album / "a.jpg", "one more", {}).error();
        QVERIFY2(problem.ends_with("there are too many photographs of that name in the album."),
                 problem.c_str());
        QCOMPARE(album.read("a (9999).jpg"), std::string("last"));
        const AlbumFolder card;
        card.write("a.jpg", "of a card");
        const auto full = import_photos(album.path(), {}, {card.path()}, {});
        QVERIFY2(
            full->photos.at(0).problem.ends_with("there are too many photographs of that name in the album."),
            full->photos.at(0).problem.c_str());
        fs::remove(album / "a (9999).jpg");
        QCOMPARE(import_photos(album.path(), {}, {card.path()}, {})->photos.at(0).place,
                 album / "a (9999).jpg");
    }

    void what_cannot_be_added_leaves_nothing() {
        const AlbumFolder album, other;
        album.write("file", "no folder");
        const auto before = album.files();
        AlbumKeeper keeper(album.path());
        for (const fs::path& place : {other / "a.jpg", album.path(), album / "../a.jpg"})
            QVERIFY(keeper.add_photo(place, "x", {}).error().find(" is not in the album ") !=
                    std::string::npos);
        QVERIFY(keeper.add_photo(album / "file/a.jpg", "x", {}).error().find(" cannot be added: ") !=
                std::string::npos);
        const std::string longest = std::string(300, 'x') + ".jpg";
        QVERIFY(keeper.add_photo(album / longest, "x", {}).error().find(" cannot be added: ") !=
                std::string::npos);
        QVERIFY(album.files() == before && other.files().empty());
        QCOMPARE(keeper.history().steps(), std::size_t{0});
    }

    /// The disk has room for the photograph, and not for the words about it.
    void a_photograph_without_its_words_is_kept_and_said() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        const auto added = without_room(200, [&] {
            return keeper.add_photo(album / "a.jpg", picture(3), {{0.5, 0.5, 0.2, 0.2, "Anna"}});
        });
        QVERIFY2(added.ok(), added.error().c_str());
        QVERIFY(added->warning.ends_with('.'));
        QCOMPARE(album.read("a.jpg"), picture(3));
        QVERIFY(companions_of(added->photo).empty());
        QCOMPARE(keeper.history().undo(), std::string());
        QVERIFY(!fs::exists(album / "a.jpg"));
    }

    void each_step_goes_back_and_forth_more_than_once() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1);
        const fs::path sound = a_sound(album, "s.wav", 0.5, 300.0),
                       longer = a_sound(album, "l.wav", 0.8, 300.0);
        AlbumKeeper keeper(album.path());
        const auto recordings = [&] { return record_of(photo).tags.size(); };
        const auto there = [&](const std::string& file) { return fs::exists(tags_folder(photo) / file); };

        const auto added = keeper.add_recording(photo, sound, {});
        QVERIFY2(added.ok(), added.error().c_str());
        const std::string file = added->tag.file;
        back_and_forth(keeper.history(), [&] { return recordings() == 0 && !there(file); });
        const auto part = keeper.trim_recording(photo, file, 0.1, 0.4);
        QVERIFY2(part.ok(), part.error().c_str());
        back_and_forth(keeper.history(),
                       [&] { return there(file) && !there(part->file) && recordings() == 1; });
        QCOMPARE(keeper.delete_recording(photo, part->file), std::string());
        QVERIFY(keeper.is_in_trash(photo, part->file) && !keeper.is_in_trash(photo, "other.flac"));
        back_and_forth(keeper.history(), [&] { return there(part->file) && recordings() == 1; });
        QCOMPARE(keeper.delete_photo(photo), std::string());
        QCOMPARE(keeper.history().next_undo(), std::string("a.jpg was deleted"));
        back_and_forth(keeper.history(), [&] { return fs::exists(photo); });

        const auto seconds = [&](const std::string& person) {
            const auto name = keeper.name_recording(person);
            return name ? about_recording(*name)->seconds() : 0.0;
        };
        QCOMPARE(keeper.keep_name_recording("Ana", sound), std::string());
        back_and_forth(keeper.history(), [&] { return seconds("Ana") == 0.0; });
        QCOMPARE(keeper.keep_name_recording("Ana", longer), std::string());
        back_and_forth(keeper.history(), [&] { return seconds("Ana") == 0.5; });
        QCOMPARE(keeper.history().next_undo(), std::string("the name of Ana was recorded"));
        QCOMPARE(keeper.keep_name_recording("Tom", sound), std::string());
        QCOMPARE(keeper.rename_name_recording("Ana", "Tom"), std::string());
        QCOMPARE(keeper.history().next_undo(), std::string("how somebody says Ana was deleted"));
        back_and_forth(keeper.history(), [&] { return seconds("Ana") == 0.8; });
        QCOMPARE(keeper.rename_name_recording("Tom", "Eva"), std::string());
        QCOMPARE(keeper.history().next_undo(), std::string("the recorded name of Tom became that of Eva"));
        back_and_forth(keeper.history(), [&] { return seconds("Tom") == 0.5 && seconds("Eva") == 0.0; });
    }

    /// There is room for recordings and lists, and none for a photograph's long words.
    void where_the_words_cannot_be_written_each_step_says_so_and_is_none() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1), sound = a_sound(album, "s.wav", 0.5, 300.0);
        AlbumKeeper keeper(album.path());
        const std::string one = keeper.add_recording(photo, sound, {})->tag.file;
        const std::string two = keeper.add_recording(photo, sound, {})->tag.file;
        QCOMPARE(keeper.name_face(photo, {0.5, 0.5, 0.2, 0.2, "Anna"}), std::string());
        QCOMPARE(keeper.describe(photo, "de", "Garten", std::string(200'000, 'x')), std::string());
        const auto before = album.files();
        const std::size_t steps = keeper.history().steps();
        const auto said = without_room(100'000, [&] {
            return std::vector<std::string>{
                keeper.add_recording(photo, sound, {}).error(),
                keeper.order_recordings(photo, {two, one}),
                keeper.delete_recording(photo, one),
                keeper.trim_recording(photo, one, 0.1, 0.4).error(),
                keeper.name_face(photo, {0.5, 0.5, 0.2, 0.2, "Eva"}),
                keeper.rename_person({photo}, "Anna", "Eva").error(),
                keeper.describe(photo, "de", "Haus", std::string(150'000, 'y')),
                keeper.label_recording(photo, one, {RecordingKind::story, "Anna", {}, {}, {}, {}}),
            };
        });
        for (std::size_t i = 0; i < said.size(); ++i)
            QVERIFY2(said[i].ends_with('.'), std::to_string(i).c_str());
        QCOMPARE(keeper.history().steps(), steps);
        QVERIFY(fs::exists(tags_folder(photo) / one) && fs::exists(tags_folder(photo) / two));
        QCOMPARE(album.read("a.jpg.xmp"), before.at("a.jpg.xmp"));
        QVERIFY(keeper.trash().entries().empty());
        // Those two, and the one that was said to be kept.
        QCOMPARE(std::distance(fs::directory_iterator(tags_folder(photo)), {}), 3);
        QCOMPARE(keeper.order_recordings(photo, {two, one}), std::string()); // with room again
    }

    void what_another_program_works_on_is_left_alone() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1), moved = a_photo(album, "moved/b.jpg", 1);
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.describe(photo, "de", "Garten", ""), std::string());
        const auto before = album.files();
        somebody_works = true;
        const std::vector<std::string> said{keeper.add_photo(album / "new.jpg", "new", {}).error(),
                                            keeper.delete_photo(photo), keeper.move_companions(photo, moved),
                                            keeper.describe(photo, "de", "Haus", "")};
        somebody_works = false;
        for (const std::string& problem : said)
            QVERIFY2(problem.find("nother program is ") != std::string::npos, problem.c_str());
        QVERIFY(album.files() == before);
        QCOMPARE(keeper.history().steps(), std::size_t{1});
        QCOMPARE(keeper.delete_photo(photo), std::string()); // later
    }

    /// As other programs list who is on a photograph, without a place.
    void a_person_without_a_face_is_renamed_and_back() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1);
        SidecarChanges listed;
        listed.persons = std::vector<std::string>{"Anna", "Tom"};
        QCOMPARE(write_sidecar(photo, listed), std::string());
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.rename_person({photo}, "Anna", "Eva").value(), std::size_t{1});
        const auto persons = [&] {
            auto names = record_of(photo).persons;
            std::sort(names.begin(), names.end());
            return names;
        };
        QCOMPARE(persons(), (std::vector<std::string>{"Eva", "Tom"}));
        QCOMPARE(keeper.history().next_undo(), std::string("Anna became Eva"));
        back_and_forth(keeper.history(), [&] {
            return persons() == std::vector<std::string>{"Anna", "Tom"};
        });
        QCOMPARE(persons(), (std::vector<std::string>{"Eva", "Tom"}));
        QCOMPARE(keeper.rename_person({photo}, "Eva", "Tom").value(), std::size_t{1}); // two become one
        QCOMPARE(persons(), std::vector<std::string>{"Tom"});
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(persons(), (std::vector<std::string>{"Eva", "Tom"}));
        for (const auto& [from, to] : {std::pair{"", "x"}, std::pair{"Tom", ""}, std::pair{"Tom", "Tom"}})
            QVERIFY(!keeper.rename_person({photo}, from, to).ok());
    }

    void a_recording_keeps_what_it_says_of_itself() {
        const AlbumFolder album, other;
        const fs::path photo = a_photo(album, "a.jpg", 1), elsewhere = a_photo(other, "b.jpg", 2);
        AlbumKeeper keeper(album.path()), there(other.path());
        const RecordingLabel label{RecordingKind::story,        "Anna", "Tom", "de",
                                   "2020-02-03T04:05:06+01:00", "Text"};
        const auto first = there.add_recording(elsewhere, a_sound(other, "s.wav", 0.5, 300.0), label);
        const fs::path flac = tags_folder(elsewhere) / first->tag.file;
        RecordingNotes notes = about_recording(flac)->notes;
        notes.chapters = {{0.0, "in the garden"}, {0.2, "in the house"}};
        QCOMPARE(relabel_recording(flac, notes), std::string());
        const auto added = keeper.add_recording(photo, flac, label);
        QVERIFY2(added.ok(), added.error().c_str());
        const fs::path file = tags_folder(photo) / added->tag.file;
        QVERIFY(about_recording(file)->notes == notes);
        RecordingLabel other_label = label;
        other_label.person = "Eva";
        QCOMPARE(keeper.label_recording(photo, added->tag.file, other_label), std::string());
        QVERIFY(about_recording(file)->notes.chapters == notes.chapters);
        // What lies there already is listed by its own words.
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(keeper.history().undo(), std::string());
        fs::copy_file(flac, tags_folder(photo) / "2020.flac");
        QVERIFY(keeper.list_recording(photo, "2020.flac")->label == label);
        QCOMPARE(record_of(photo).tags.size(), std::size_t{1});
        fs::remove(tags_folder(photo) / "2020.flac");
        QCOMPARE(keeper.forget_recording(photo, "2020.flac"), std::string());
        QVERIFY(record_of(photo).tags.empty());
        QVERIFY(!keeper.list_recording(photo, "2020.flac").ok());
    }

    /// Its part from the first sample on, or up to the last; what lies beyond is none.
    void a_recording_is_trimmed_to_the_sample() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1), sound = a_sound(album, "s.wav", 0.5, 300.0);
        AlbumKeeper keeper(album.path());
        for (const auto& [begin, end, left] :
             {std::tuple{0.0, 0.2, 0.2}, std::tuple{0.3, 99.0, 0.2}, std::tuple{0.1, 0.4, 0.3}}) {
            const auto added = keeper.add_recording(photo, sound, {});
            const auto part = keeper.trim_recording(photo, added->tag.file, begin, end);
            QVERIFY2(part.ok(), part.error().c_str());
            QCOMPARE(about_recording(tags_folder(photo) / part->file)->frames,
                     std::uint64_t(48'000 * left + 0.5));
        }
        const auto added = keeper.add_recording(photo, sound, {});
        QVERIFY(!keeper.trim_recording(photo, added->tag.file, 0.2, 0.2).ok());
        QVERIFY(!keeper.trim_recording(photo, added->tag.file, -0.1, 0.2).ok());
        QVERIFY(keeper.trim_recording(photo, added->tag.file, 0.4, 0.1)
                    .error()
                    .ends_with(" cannot be trimmed: the part must begin before it ends."));
    }

    void a_step_is_called_by_what_was_done_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("of_nobody");
        QTest::addColumn<QString>("of_anna");
        const auto row = [](RecordingKind kind, const char* of_nobody, const char* of_anna) {
            QTest::newRow(of_nobody) << static_cast<int>(kind) << QString::fromUtf8(of_nobody)
                                     << QString::fromUtf8(of_anna);
        };
        row(RecordingKind::memo, "the memo", "the memo about Anna");
        row(RecordingKind::person, "the recording of who it is", "the recording of who Anna is");
        row(RecordingKind::place, "the recording of the place", "the recording of the place (Anna)");
        row(RecordingKind::story, "the story", "the story about Anna");
        row(RecordingKind::ambient, "the recording of background sounds",
            "the recording of background sounds (Anna)");
    }
    void a_step_is_called_by_what_was_done() {
        QFETCH(int, kind);
        QFETCH(QString, of_nobody);
        QFETCH(QString, of_anna);
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1), sound = a_sound(album, "s.wav", 0.5, 300.0);
        AlbumKeeper keeper(album.path());
        for (const bool anna : {false, true}) {
            const std::string what = (anna ? of_anna : of_nobody).toStdString();
            const RecordingLabel label{static_cast<RecordingKind>(kind), anna ? "Anna" : "", {}, {}, {}, {}};
            const auto added = keeper.add_recording(photo, sound, label);
            QVERIFY2(added.ok(), added.error().c_str());
            QCOMPARE(keeper.history().next_undo(), what + " was added");
            QCOMPARE(keeper.label_recording(photo, added->tag.file, label), std::string());
            QCOMPARE(keeper.history().next_undo(), what + " was labelled");
            const auto part = keeper.trim_recording(photo, added->tag.file, 0.0, 0.4);
            QCOMPARE(keeper.history().next_undo(), what + " was trimmed");
            QCOMPARE(keeper.delete_recording(photo, part->file), std::string());
            QCOMPARE(keeper.history().next_undo(), what + " was deleted");
            QCOMPARE(keeper.trash().entries().at(0).what, what + " of a.jpg");
        }
    }
};

QTEST_GUILESS_MAIN(StepsTest)
#include "steps_test.moc"
