// SPDX-License-Identifier: Apache-2.0
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/motion_photo.hpp"
#include "app/album/metadata/read_record.hpp"
#include "audio/recordings/recording_file.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <functional>
#include <random>
#include <stop_token>

namespace album_keeper_test {

using namespace tp;
namespace fs = std::filesystem;

class AlbumKeeperTest : public QObject {
    Q_OBJECT

    static PhotoRecord record_of(const fs::path& photo) {
        const auto record = read_record(photo);
        return record ? *record : PhotoRecord{};
    }

private slots:
    void a_recording_is_added_labelled_ordered_trimmed_and_deleted() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "2026/IMG_1.jpg", 1);
        const std::string bytes = album.read("2026/IMG_1.jpg");
        const fs::path sound = a_sound(album, "from/memo.wav", 2.0, 440.0);
        AlbumKeeper keeper(album.path());
        RecordingLabel label{
            RecordingKind::memo,  "Anna", "Grandma; Tom", "de-AT", "2026-05-01T10:15:00+02:00",
            "Das war\nim Garten."};
        const auto added = keeper.add_recording(photo, sound, label);
        QVERIFY2(added.ok(), added.error().c_str());
        QCOMPARE(added->warning, std::string());
        QCOMPARE(added->tag.duration_s, 2.0);
        QVERIFY(added->tag.label == label);
        QVERIFY(fs::exists(tags_folder(photo) / added->tag.file));
        QVERIFY(record_of(photo).tags == std::vector<Tag>{added->tag});
        QCOMPARE(record_of(photo).content_hash, *content_hash(photo));

        label.kind = RecordingKind::story;
        label.person = "Anna Maria";
        QCOMPARE(keeper.label_recording(photo, added->tag.file, label), std::string());
        QVERIFY(record_of(photo).tags.at(0).label == label);
        QVERIFY(about_recording(tags_folder(photo) / added->tag.file)->notes.label == label);

        const auto second = keeper.add_recording(photo, sound, {});
        QCOMPARE(keeper.order_recordings(photo, {second->tag.file, added->tag.file}), std::string());
        for (const Tag& tag : record_of(photo).tags)
            QCOMPARE(tag.order, tag.file == second->tag.file ? 1 : 2);

        const auto part = keeper.trim_recording(photo, second->tag.file, 0.5, 1.25);
        QVERIFY2(part.ok(), part.error().c_str());
        QCOMPARE(part->duration_s, 0.75);
        QCOMPARE(part->order, 1);
        QCOMPARE(record_of(photo).tags.size(), std::size_t{2});
        QVERIFY(!fs::exists(tags_folder(photo) / second->tag.file));

        QCOMPARE(keeper.delete_recording(photo, part->file), std::string());
        QCOMPARE(record_of(photo).tags.size(), std::size_t{1});
        QCOMPARE(album.read("2026/IMG_1.jpg"), bytes);
        QVERIFY(!fs::exists(album / "from/memo.flac"));
    }

    void labelling_that_is_stopped_changes_nothing() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1), sound = a_sound(album, "s.wav", 0.5, 300.0);
        AlbumKeeper keeper(album.path());
        const auto added = keeper.add_recording(photo, sound, {});
        QVERIFY2(added.ok(), added.error().c_str());
        const std::string step = keeper.history().next_undo();
        std::stop_source person;
        person.request_stop();
        const RecordingLabel label{RecordingKind::story, "Anna", {}, {}, {}, {}};
        const std::string said = keeper.label_recording(photo, added->tag.file, label, person.get_token());
        QVERIFY2(said.ends_with(".flac\" cannot be changed: it was stopped."), said.c_str());
        QVERIFY(record_of(photo).tags == std::vector<Tag>{added->tag});
        QVERIFY(about_recording(tags_folder(photo) / added->tag.file)->notes.label == added->tag.label);
        QCOMPARE(keeper.history().next_undo(), step);
    }

    /// Random steps, all taken back, then all done again: what the album says is what it said each time.
    void sixty_steps_go_back_and_forth() {
        const AlbumFolder album;
        std::vector<fs::path> photos;
        for (int i = 0; i < 4; ++i)
            photos.push_back(a_photo(album, "IMG_" + std::to_string(i) + ".jpg", i));
        const fs::path sound = a_sound(album, "sounds/a.wav", 0.5, 300.0);
        AlbumKeeper keeper(album.path());
        const auto all = [&] {
            std::vector<PhotoRecord> records;
            for (const fs::path& photo : photos) {
                PhotoRecord record = fs::exists(photo) ? record_of(photo) : PhotoRecord{};
                record.content_hash.clear(); // stays once it is known
                std::sort(record.tags.begin(), record.tags.end(),
                          [](const Tag& a, const Tag& b) { return a.file < b.file; });
                std::sort(record.persons.begin(), record.persons.end());
                for (const Tag& tag : record.tags)
                    if (!fs::exists(tags_folder(photo) / tag.file))
                        record.problems.push_back("the file of " + tag.file + " is missing");
                records.push_back(record);
            }
            return records;
        };
        const std::vector<std::string> names{"Anna", "Tom", "Jörg", "שרה"};
        std::mt19937 random(11);
        const auto some_tag = [&](const fs::path& photo) {
            const auto tags = record_of(photo).tags;
            return tags.empty() ? std::string("none") : tags[random() % tags.size()].file;
        };
        std::vector<std::vector<PhotoRecord>> history{all()};
        while (keeper.history().steps() < 60) {
            const fs::path photo = photos[random() % photos.size()];
            const std::size_t before = keeper.history().steps();
            const std::string name = names[random() % names.size()];
            switch (random() % 8) {
            case 0:
            case 1:
                static_cast<void>(
                    keeper.add_recording(photo, sound, {RecordingKind::memo, name, {}, {}, {}, {}}));
                break;
            case 2:
                keeper.delete_recording(photo, some_tag(photo));
                break;
            case 3:
                keeper.label_recording(photo, some_tag(photo),
                                       {RecordingKind::story, name, name, {}, {}, "x"});
                break;
            case 4: {
                const double x = 0.2 + 0.3 * static_cast<double>(random() % 3);
                keeper.name_face(photo, {x, 0.5, 0.2, 0.3, name});
                break;
            }
            case 5:
                static_cast<void>(keeper.rename_person(photos, name, names[random() % names.size()]));
                break;
            case 6:
                keeper.describe(photo, random() % 2 ? "de" : "x-default", name, "long text");
                break;
            case 7:
                static_cast<void>(keeper.trim_recording(photo, some_tag(photo), 0.1, 0.4));
                break;
            }
            if (keeper.history().steps() > before)
                history.push_back(all());
            else
                QVERIFY2(all() == history.back(), "a step that was refused changed something");
        }
        for (const auto& records : history)
            for (const PhotoRecord& record : records)
                QVERIFY2(record.problems.empty(), record.problems.empty() ? "" : record.problems[0].c_str());
        for (std::size_t i = 60; i-- > 0;) {
            const std::string what = keeper.history().next_undo();
            QCOMPARE(keeper.history().undo(), std::string());
            QVERIFY2(all() == history[i], ("undoing step " + std::to_string(i) + ": " + what).c_str());
        }
        for (std::size_t i = 1; i <= 60; ++i) {
            const std::string what = keeper.history().next_redo();
            QCOMPARE(keeper.history().redo(), std::string());
            QVERIFY2(all() == history[i], ("doing again step " + std::to_string(i) + ": " + what).c_str());
        }
    }

    void a_deleted_photograph_comes_back_after_the_program_ended() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "IMG_1.jpg", 1);
        const fs::path sound = a_sound(album, "s.wav", 0.5, 300.0);
        AlbumKeeper first(album.path());
        const auto added = first.add_recording(photo, sound, {});
        QCOMPARE(first.delete_recording(photo, added->tag.file), std::string());
        const auto second = first.add_recording(photo, sound, {});
        const fs::path copy =
            album.write("IMG_1.jpg.sync-conflict-20260501-101500-ABCDEFG.xmp", album.read("IMG_1.jpg.xmp"));
        album.write("IMG_10.jpg.xmp", "another's");
        QCOMPARE(first.delete_photo(photo), std::string());
        QVERIFY(!fs::exists(photo) && !fs::exists(tags_folder(photo)) && !fs::exists(copy));
        QVERIFY(fs::exists(album / "IMG_10.jpg.xmp"));
        AlbumKeeper later(album.path());
        const auto entries = later.trash().entries();
        QCOMPARE(entries.size(), std::size_t{2});
        QVERIFY(!later.restore(entries[1].id)
                     .empty()); // the recording before its photograph: nothing to list it on
        QCOMPARE(later.restore(entries[0].id), std::string());
        QVERIFY(record_of(photo).tags.size() >= 1);
        for (const TrashEntry& entry : later.trash().entries())
            QCOMPARE(later.restore(entry.id), std::string());
        QCOMPARE(record_of(photo).tags.size(), std::size_t{2});
        Q_UNUSED(second)
    }

    void people_are_named_merged_and_taken_apart() {
        const AlbumFolder album;
        const fs::path a = a_photo(album, "a.jpg", 1), b = a_photo(album, "b.jpg", 2);
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.name_face(a, {0.3, 0.4, 0.2, 0.2, "Ana"}), std::string());
        QCOMPARE(keeper.name_face(a, {0.31, 0.41, 0.2, 0.2, "Anna"}), std::string()); // the same face
        QCOMPARE(keeper.name_face(a, {0.8, 0.4, 0.2, 0.2, "Tom"}), std::string());
        QCOMPARE(keeper.name_face(b, {0.5, 0.5, 0.5, 0.5, "Annie"}), std::string());
        QCOMPARE(record_of(a).faces.size(), std::size_t{2});
        QCOMPARE(record_of(a).persons, (std::vector<std::string>{"Anna", "Tom"}));
        QCOMPARE(*keeper.rename_person({a, b}, "Annie", "Anna"), std::size_t{1});
        QCOMPARE(record_of(b).faces.at(0).name, std::string("Anna"));
        QCOMPARE(*keeper.rename_person({b}, "Anna", "Anna Maria"), std::size_t{1});
        QCOMPARE(record_of(a).faces.at(0).name, std::string("Anna"));
        QCOMPARE(record_of(b).persons, std::vector<std::string>{"Anna Maria"});
        QCOMPARE(*keeper.rename_person({a, b}, "nobody", "x"), std::size_t{0});
        QVERIFY(!keeper.rename_person({a}, "Anna", "").ok());
        QVERIFY(!keeper.name_face(a, {1.5, 0.4, 0.2, 0.2, "x"}).empty());
        const fs::path sound = a_sound(album, "anna.wav", 0.6, 500.0);
        for (const std::string& name :
             {std::string("Anna/Maria"), std::string("..."), std::string(300, 'x'), std::string("Jörg")}) {
            QCOMPARE(keeper.keep_name_recording(name, sound), std::string());
            QCOMPARE(about_recording(*keeper.name_recording(name))->notes.label.person, name);
        }
        QCOMPARE(keeper.keep_name_recording("Jörg", a_sound(album, "2.wav", 0.8, 500.0)), std::string());
        QCOMPARE(about_recording(*keeper.name_recording("Jörg"))->seconds(), 0.8);
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(about_recording(*keeper.name_recording("Jörg"))->seconds(), 0.6);
        QCOMPARE(keeper.history().redo(), std::string());
        QCOMPARE(about_recording(*keeper.name_recording("Jörg"))->seconds(), 0.8);
        QVERIFY(!keeper.name_recording("Tom"));
    }

    void a_recorded_name_goes_where_its_person_goes() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        const fs::path sound = a_sound(album, "s.wav", 0.5, 300.0);
        const auto whose = [&](const std::string& person) {
            const auto file = keeper.name_recording(person);
            return file ? about_recording(*file)->notes.label.person : std::string("nobody's");
        };
        QCOMPARE(keeper.rename_name_recording("Ana", "Anna"), std::string()); // there is none
        QCOMPARE(keeper.keep_name_recording("Ana", sound), std::string());
        for (int i = 0; i < 2; ++i) {
            QCOMPARE(i == 0 ? keeper.rename_name_recording("Ana", "Anna/Maria") : keeper.history().redo(),
                     std::string());
            QCOMPARE(whose("Anna/Maria"), std::string("Anna/Maria"));
            QVERIFY(!keeper.name_recording("Ana"));
            QCOMPARE(keeper.history().undo(), std::string());
            QCOMPARE(whose("Ana"), std::string("Ana"));
            QVERIFY(!keeper.name_recording("Anna/Maria"));
        }
        QCOMPARE(keeper.keep_name_recording("Tom", a_sound(album, "2.wav", 0.8, 500.0)), std::string());
        QCOMPARE(keeper.rename_name_recording("Ana", "Tom"), std::string()); // two became one
        QVERIFY(!keeper.name_recording("Ana"));
        QCOMPARE(about_recording(*keeper.name_recording("Tom"))->seconds(), 0.8);
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(whose("Ana"), std::string("Ana"));
        album.write(".touchphoto/people/Ana.flac", "no sound");
        QVERIFY(keeper.rename_name_recording("Ana", "Eva").ends_with('.'));
        QVERIFY(!keeper.name_recording("Eva"));
    }

    void what_makes_no_sense_changes_nothing() {
        const AlbumFolder album, other;
        const fs::path photo = a_photo(album, "a.jpg", 1), outside = a_photo(other, "b.jpg", 2);
        const fs::path sound = a_sound(album, "s.wav", 0.5, 300.0);
        album.write("text.wav", "this is no sound at all");
        AlbumKeeper keeper(album.path());
        const auto added = keeper.add_recording(photo, sound, {});
        const auto before = album.files();
        QVERIFY(!keeper.add_recording(photo, album / "text.wav", {}).ok());
        QVERIFY(!keeper.add_recording(photo, album / "missing.wav", {}).ok());
        const auto before_outside = other.files();
        for (const std::string& said :
             {keeper.add_recording(outside, sound, {}).error(),
              keeper.add_video_sound(outside, sound, {0, fs::file_size(sound)}, {}).error()})
            QVERIFY2(said.find(" is not in the album ") != std::string::npos, said.c_str());
        QVERIFY(other.files() == before_outside);
        QVERIFY(!keeper.add_recording(album / "missing.jpg", sound, {}).ok());
        QVERIFY(!keeper.label_recording(photo, "../a.jpg", {}).empty());
        QVERIFY(!keeper.delete_recording(photo, "../../etc/passwd").empty());
        QVERIFY(!keeper.order_recordings(photo, {"missing.flac"}).empty());
        QVERIFY(!keeper.trim_recording(photo, added->tag.file, 0.4, 0.1).ok());
        QVERIFY(!keeper.trim_recording(photo, added->tag.file, std::nan(""), 1.0).ok());
        QVERIFY(!keeper.delete_photo(outside).empty());
        QVERIFY(!keeper.forget_recording(photo, added->tag.file).empty());
        QVERIFY(album.files() == before);
        QCOMPARE(keeper.history().steps(), std::size_t{1});
        // A step is not taken back where somebody else deleted what it was about.
        QCOMPARE(keeper.label_recording(photo, added->tag.file, {}), std::string());
        QCOMPARE(AlbumKeeper(album.path()).delete_recording(photo, added->tag.file), std::string());
        QVERIFY(keeper.history().undo().ends_with('.'));
        QCOMPARE(keeper.history().steps(), std::size_t{2});
    }
};

} // namespace album_keeper_test

TP_TEST(album_keeper_test, AlbumKeeperTest, event_loop)
#include "album_keeper_test.moc"
