// SPDX-License-Identifier: Apache-2.0
// A person under another name, wherever it stands: on faces, in the list, in recordings; and which faces are one.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/keeper/tag_note.hpp"
#include "app/album/metadata/motion_photo.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/album/metadata/write_sidecar.hpp"
#include "audio/recordings/recording_file.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace renamed_people_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

PhotoRecord record_of(const fs::path& photo) {
    const auto record = read_record(photo);
    return record ? *record : PhotoRecord{};
}

std::string faces_of(const fs::path& photo) {
    std::string names;
    for (const FaceRegion& face : record_of(photo).faces)
        names += face.name + " ";
    return names;
}

std::vector<std::string> persons_of(const fs::path& photo) {
    auto names = record_of(photo).persons;
    std::sort(names.begin(), names.end());
    return names;
}

RecordingLabel about(const char* person, const char* speaker) {
    return {RecordingKind::memo, person, speaker, {}, {}, {}};
}

} // namespace

class RenamedPeopleTest : public QObject {
    Q_OBJECT
private slots:
    /// Three tenths of what both cover together, wherever they lie and however they are shaped.
    void faces_of_any_shape_are_one_where_they_cover_each_other() {
        const FaceRegion tall{0.5, 0.5, 0.2, 0.4, "Ana"}, wide{0.5, 0.5, 0.4, 0.2, "Ana"},
            large{0.5, 0.5, 0.4, 0.4, "Ana"};
        const auto one = [](const FaceRegion& first, const FaceRegion& second) {
            const AlbumFolder album;
            const fs::path photo = a_photo(album, "a.jpg", 1);
            AlbumKeeper keeper(album.path());
            return keeper.name_face(photo, first).empty() && keeper.name_face(photo, second).empty() &&
                   record_of(photo).faces.size() == 1;
        };
        QVERIFY(one(tall, {0.5, 0.5, 0.42, 0.2, "Tom"}) && !one(tall, {0.5, 0.5, 0.5, 0.2, "Tom"}));
        QVERIFY(one(wide, {0.5, 0.5, 0.2, 0.42, "Tom"}) && !one(wide, {0.5, 0.5, 0.2, 0.5, "Tom"}));
        for (const double place : {0.4, 0.6}) {
            QVERIFY(one(large, {place, 0.5, 0.2, 0.26, "Tom"}) &&
                    !one(large, {place, 0.5, 0.2, 0.22, "Tom"}));
            QVERIFY(one(large, {0.5, place, 0.26, 0.2, "Tom"}) &&
                    !one(large, {0.5, place, 0.22, 0.2, "Tom"}));
            QVERIFY(one({place, 0.5, 0.2, 0.26, "Tom"}, large) &&
                    !one({place, 0.5, 0.2, 0.22, "Tom"}, large));
        }
        for (const double side : {-1.0, 1.0}) { // half of it beside the other
            QVERIFY(one(large, {0.5 + side * 0.2, 0.5, 0.2, 0.4, "Tom"}) == false);
            QVERIFY(one(large, {0.5 + side * 0.16, 0.5, 0.2, 0.4, "Tom"}));
            QVERIFY(one(large, {0.5, 0.5 + side * 0.16, 0.4, 0.2, "Tom"}));
            QVERIFY(!one(large, {0.5, 0.5 + side * 0.2, 0.4, 0.2, "Tom"}));
        }
        QVERIFY(!one({0.2, 0.2, 0.2, 0.2, "Ana"}, {0.8, 0.8, 0.2, 0.2, "Tom"}));
        QVERIFY(!one({0.2, 0.2, 0.2, 0.2, "Ana"}, {0.2, 0.8, 0.2, 0.2, "Tom"}));
    }

    /// As other programs mark a face: by its middle alone.
    void a_face_that_is_a_point_is_renamed_and_back() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1);
        SidecarChanges marked;
        marked.faces = std::vector<FaceRegion>{
            {0.3, 0.4, 0.0, 0.0, "Anna"}, {0.6, 0.4, 0.0, 0.0, "Tom"}, {0.3, 0.8, 0.0, 0.0, "Ben"}};
        QCOMPARE(write_sidecar(photo, marked), std::string());
        AlbumKeeper keeper(album.path());
        for (const char* name : {"Anna", "Tom", "Ben"}) {
            QCOMPARE(keeper.rename_person({photo}, name, "Eva").value(), std::size_t{1});
            QVERIFY(faces_of(photo) != "Anna Tom Ben ");
            QCOMPARE(keeper.history().undo(), std::string());
            QCOMPARE(faces_of(photo), std::string("Anna Tom Ben "));
        }
    }

    void of_two_who_became_one_each_gets_the_own_name_back() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1);
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.name_face(photo, {0.2, 0.2, 0.2, 0.2, "Anna"}), std::string());
        QCOMPARE(keeper.name_face(photo, {0.8, 0.2, 0.2, 0.2, "Eva"}), std::string());
        QCOMPARE(keeper.name_face(photo, {0.5, 0.8, 0.2, 0.2, "Tom"}), std::string());
        for (int i = 0; i < 2; ++i) {
            if (i == 0)
                QCOMPARE(keeper.rename_person({photo}, "Anna", "Eva").value(), std::size_t{1});
            else
                QCOMPARE(keeper.history().redo(), std::string());
            QCOMPARE(faces_of(photo), std::string("Eva Eva Tom "));
            QCOMPARE(persons_of(photo), (std::vector<std::string>{"Eva", "Tom"}));
            QCOMPARE(keeper.history().undo(), std::string());
            QCOMPARE(faces_of(photo), std::string("Anna Eva Tom "));
            QCOMPARE(persons_of(photo), (std::vector<std::string>{"Anna", "Eva", "Tom"}));
        }
        QCOMPARE(keeper.history().redo(), std::string());
        QCOMPARE(keeper.name_face(photo, {0.2, 0.2, 0.2, 0.2, "Ben"}),
                 std::string()); // somebody else meanwhile
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(faces_of(photo), std::string("Anna Eva Tom "));
    }

    void recordings_name_the_person_anew() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1), sound = a_sound(album, "s.wav", 0.3, 300.0);
        AlbumKeeper keeper(album.path());
        std::vector<std::string> files;
        for (const auto& [person, speaker] :
             {std::pair{"Anna", "Tom"}, {"Tom", "Anna"}, {"Anna", "Anna"}, {"Tom", "Ben"}})
            files.push_back(keeper.add_recording(photo, sound, about(person, speaker))->tag.file);
        const auto labels = [&] {
            std::string listed, own;
            for (const std::string& file : files) {
                for (const Tag& tag : record_of(photo).tags)
                    if (tag.file == file)
                        listed += tag.label.person + "/" + tag.label.speaker + " ";
                const RecordingLabel label = about_recording(tags_folder(photo) / file)->notes.label;
                own += label.person + "/" + label.speaker + " ";
            }
            return listed == own ? listed : listed + " but " + own;
        };
        QCOMPARE(keeper.rename_person({photo}, "nobody", "Eva").value(), std::size_t{0});
        for (int i = 0; i < 2; ++i) {
            QCOMPARE(labels(), std::string("Anna/Tom Tom/Anna Anna/Anna Tom/Ben "));
            if (i == 0)
                QCOMPARE(keeper.rename_person({photo}, "Anna", "Eva").value(), std::size_t{1});
            else
                QCOMPARE(keeper.history().redo(), std::string());
            QCOMPARE(labels(), std::string("Eva/Tom Tom/Eva Eva/Eva Tom/Ben "));
            QCOMPARE(keeper.history().undo(), std::string());
        }
        QVERIFY(record_of(photo).persons.empty()); // of whom no one said that they are seen
    }

    void a_recorded_name_that_goes_nowhere_stays() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.keep_name_recording("Anna", a_sound(album, "s.wav", 0.3, 300.0)), std::string());
        const auto before = album.files();
        for (const auto& [from, to] :
             {std::pair{"Anna", ""}, {"Anna", "Anna"}, {"Tom", "Eva"}, {"Tom", ""}, {"", "Eva"}})
            QCOMPARE(keeper.rename_name_recording(from, to), std::string());
        QVERIFY(album.files() == before);
        QCOMPARE(keeper.history().steps(), std::size_t{1});
        QVERIFY(keeper.keep_name_recording("Tom", album / "none.wav").ends_with('.'));
        QVERIFY(album.files() == before);
    }

    /// Those that nobody put in order stay behind, by kind.
    void an_order_is_taken_back_as_it_was() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1), sound = a_sound(album, "s.wav", 0.3, 300.0);
        AlbumKeeper keeper(album.path());
        std::vector<std::string> files;
        for (int i = 0; i < 3; ++i)
            files.push_back(keeper.add_recording(photo, sound, {})->tag.file);
        const auto orders = [&] {
            std::vector<int> all;
            for (const std::string& file : files)
                for (const Tag& tag : record_of(photo).tags)
                    if (tag.file == file)
                        all.push_back(tag.order);
            return all;
        };
        QCOMPARE(orders(), (std::vector<int>{0, 0, 0}));
        QCOMPARE(keeper.order_recordings(photo, {files[1], files[0]}), std::string());
        QCOMPARE(orders(), (std::vector<int>{2, 1, 0}));
        QCOMPARE(keeper.history().next_undo(), std::string("the recordings of a.jpg were put in order"));
        QCOMPARE(keeper.order_recordings(photo, {files[0], files[2], files[1]}), std::string());
        QCOMPARE(orders(), (std::vector<int>{1, 3, 2}));
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(orders(), (std::vector<int>{2, 1, 0}));
        QCOMPARE(keeper.history().redo(), std::string());
        QCOMPARE(orders(), (std::vector<int>{1, 3, 2}));
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(orders(), (std::vector<int>{0, 0, 0}));
        QVERIFY(keeper.order_recordings(album / "none.jpg", {}).ends_with('.'));
    }

    /// By it a photograph that another program changed is known to be another.
    void the_number_of_a_photograph_s_bytes_is_what_it_was() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1);
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.describe(photo, "de", "Garten", ""), std::string());
        const std::string first = record_of(photo).content_hash;
        QCOMPARE(first, *content_hash(photo));
        album.write("a.jpg", album.read("a.jpg") + "changed");
        QCOMPARE(keeper.describe(photo, "de", "Haus", ""), std::string());
        QCOMPARE(record_of(photo).content_hash, first);
    }

    void a_video_without_sound_is_said_by_where_it_lies() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1), video = album.write("a.mov", "no video at all");
        AlbumKeeper keeper(album.path());
        const auto said = [&](std::uint64_t begin) {
            return keeper.add_video_sound(photo, video, {begin, 5}, {}).error();
        };
        QVERIFY(said(0).starts_with("The sound of the video \"" + video.string() + "\" is not imported: "));
        QVERIFY(
            said(1).starts_with("The sound of the video in \"" + video.string() + "\" is not imported: "));
        QVERIFY(said(7).starts_with("The sound of the video in \""));
        QVERIFY(!fs::exists(tags_folder(photo)));
    }

    void what_the_trash_remembers_of_a_recording() {
        const TagNote note{"2026/a.jpg",
                           {"b.flac",
                            {RecordingKind::story, "Anna", "Tom", "de", "2026-05-01T10:15:00Z", "Text"},
                            2.5,
                            -3.5,
                            4}};
        const auto again = tag_note(note_of(note));
        QVERIFY(again && again->photo == note.photo && again->tag == note.tag);
        const std::string rest = R"("kind":"memo","file":"b.flac")";
        QVERIFY(tag_note(R"({"photo":"a.jpg",)" + rest + "}").has_value());
        for (const std::string& text :
             {std::string(), std::string("{}"), "{" + rest + "}", R"({"photo":"",)" + rest + "}",
              R"({"photo":"../a.jpg",)" + rest + "}", R"({"photo":"/a.jpg",)" + rest + "}",
              R"({"photo":"%:a%2",)" + rest + "}",
              std::string(R"({"photo":"a.jpg","kind":"memo","file":""})"),
              std::string(R"({"photo":"a.jpg","kind":"memo"})"),
              std::string(R"({"photo":"a.jpg","kind":"x","file":"b"})"),
              std::string(R"({"photo":"a.jpg","file":"b"})")})
            QVERIFY2(!tag_note(text), text.c_str());
    }
};

} // namespace renamed_people_test

TP_TEST(renamed_people_test, RenamedPeopleTest, event_loop)
#include "renamed_people_test.moc"
