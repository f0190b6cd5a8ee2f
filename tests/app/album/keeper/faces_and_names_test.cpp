// SPDX-License-Identifier: Apache-2.0
// Which faces are one, which are in the picture, where a name is kept: the first and the last of each.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace faces_and_names_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

PhotoRecord record_of(const fs::path& photo) {
    const auto record = read_record(photo);
    return record ? *record : PhotoRecord{};
}

} // namespace

class FacesAndNamesTest : public QObject {
    Q_OBJECT
private slots:
    /// Three tenths of what both cover together.
    void a_face_that_lies_nearly_there_is_the_same_face() {
        for (const double apart : {0.104, 0.112})
            for (const bool upright : {false, true}) {
                const AlbumFolder album;
                const fs::path photo = a_photo(album, "a.jpg", 1);
                AlbumKeeper keeper(album.path());
                QCOMPARE(keeper.name_face(photo, {0.4, 0.4, 0.2, 0.2, "Ana"}), std::string());
                QCOMPARE(keeper.name_face(photo, {upright ? 0.4 : 0.4 + apart, upright ? 0.4 - apart : 0.4,
                                                  0.2, 0.2, "Tom"}),
                         std::string());
                QCOMPARE(record_of(photo).faces.size(), apart < 0.11 ? std::size_t{1} : std::size_t{2});
            }
    }

    void of_two_faces_the_nearer_one_is_renamed() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1);
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.name_face(photo, {0.3, 0.5, 0.2, 0.2, "Ana"}), std::string());
        QCOMPARE(keeper.name_face(photo, {0.42, 0.5, 0.2, 0.2, "Tom"}), std::string());
        QCOMPARE(keeper.name_face(photo, {0.38, 0.5, 0.2, 0.2, "Eva"}), std::string());
        const auto faces = record_of(photo).faces;
        QCOMPARE(faces.size(), std::size_t{2});
        QCOMPARE(faces[0].name, std::string("Ana"));
        QCOMPARE(faces[1].name, std::string("Eva"));
        QCOMPARE(faces[1].x, 0.42); // its place stays
    }

    void faces_on_many_photographs_are_named_in_one_step() {
        const AlbumFolder album;
        const fs::path a = a_photo(album, "a.jpg", 1), b = a_photo(album, "b.jpg", 2);
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.name_face(b, {0.3, 0.3, 0.2, 0.2, "Ana"}), std::string());
        QCOMPARE(keeper.name_faces({{a, {0.5, 0.5, 0.2, 0.2, "Eva"}}, {b, {0.3, 0.3, 0.2, 0.2, "Eva"}}}),
                 std::string());
        QCOMPARE(keeper.history().next_undo(), std::string("2 faces were named Eva"));
        QCOMPARE(record_of(a).persons, std::vector<std::string>{"Eva"});
        QCOMPARE(record_of(b).persons, std::vector<std::string>{"Eva"});
        for (int i = 0; i < 2; ++i) {
            QCOMPARE(keeper.history().undo(), std::string());
            QVERIFY(record_of(a).faces.empty() && record_of(a).persons.empty());
            QCOMPARE(record_of(b).faces.at(0).name, std::string("Ana"));
            QCOMPARE(record_of(b).persons, std::vector<std::string>{"Ana"});
            QCOMPARE(keeper.history().redo(), std::string());
            QCOMPARE(record_of(a).faces.at(0).name, std::string("Eva"));
            QCOMPARE(record_of(b).faces.at(0).name, std::string("Eva"));
        }
        QCOMPARE(keeper.name_faces({}), std::string());
        QCOMPARE(keeper.history().next_undo(), std::string("2 faces were named Eva"));
    }

    void where_one_of_many_cannot_be_named_none_is() {
        const AlbumFolder album;
        const fs::path a = a_photo(album, "a.jpg", 1), b = a_photo(album, "b.jpg", 2);
        fs::create_directory(b.string() + ".xmp"); // no sidecar can be there
        AlbumKeeper keeper(album.path());
        QVERIFY(
            !keeper.name_faces({{a, {0.5, 0.5, 0.2, 0.2, "Eva"}}, {b, {0.3, 0.3, 0.2, 0.2, "Eva"}}}).empty());
        QVERIFY(record_of(a).faces.empty() && record_of(a).persons.empty());
        QCOMPARE(keeper.history().next_undo(), std::string());
        QVERIFY(
            !keeper.name_faces({{a, {0.5, 0.5, 0.2, 0.2, "Eva"}}, {b, {0.5, 0.5, 2.0, 0.2, "Eva"}}}).empty());
        QVERIFY(record_of(a).faces.empty());
    }

    /// A hundredth over the edge is how other programs round.
    void a_face_must_lie_in_the_picture() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1);
        AlbumKeeper keeper(album.path());
        const auto taken = [&](double x, double y, double width, double height) {
            return keeper.name_face(photo, {x, y, width, height, "Ana"}).empty();
        };
        for (const double near : {0.095, 0.905}) {
            QVERIFY(taken(near, 0.5, 0.2, 0.2));
            QVERIFY(taken(0.5, near, 0.2, 0.2));
        }
        for (const double far : {0.085, 0.915, std::nan(""), HUGE_VAL}) {
            QVERIFY(!taken(far, 0.5, 0.2, 0.2));
            QVERIFY(!taken(0.5, far, 0.2, 0.2));
        }
        for (const double size : {0.0, -0.1, std::nan("")}) {
            QVERIFY(!taken(0.5, 0.5, size, 0.2));
            QVERIFY(!taken(0.5, 0.5, 0.2, size));
        }
    }

    /// Numbers that are exact: three tenths are one face, a whole hundredth over the edge is outside.
    void at_the_borders_themselves() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1);
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.name_face(photo, {0.5, 0.5, 1.0, 0.625, "Ana"}), std::string());
        QCOMPARE(keeper.name_face(photo, {0.5, 0.5, 0.75, 0.25, "Tom"}), std::string());
        QCOMPARE(record_of(photo).faces.size(), std::size_t{1});
        for (const double edge : {0.0, 1.0}) {
            QVERIFY(!keeper.name_face(photo, {edge, 0.5, 0.02, 0.2, "Eva"}).empty());
            QVERIFY(!keeper.name_face(photo, {0.5, edge, 0.2, 0.02, "Eva"}).empty());
            QCOMPARE(keeper.name_face(photo, {edge, 0.5, 0.0198, 0.2, ""}), std::string());
        }
    }

    void a_name_stays_in_the_list_while_another_face_bears_it() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1);
        AlbumKeeper keeper(album.path());
        QCOMPARE(keeper.name_face(photo, {0.2, 0.2, 0.2, 0.2, "Anna"}), std::string());
        QCOMPARE(keeper.name_face(photo, {0.8, 0.8, 0.2, 0.2, "Anna"}), std::string());
        QCOMPARE(record_of(photo).persons, std::vector<std::string>{"Anna"});
        QCOMPARE(keeper.name_face(photo, {0.2, 0.2, 0.2, 0.2, "Tom"}), std::string());
        QCOMPARE(record_of(photo).persons, (std::vector<std::string>{"Anna", "Tom"}));
        QCOMPARE(keeper.name_face(photo, {0.8, 0.8, 0.2, 0.2, ""}), std::string());
        QCOMPARE(record_of(photo).persons, std::vector<std::string>{"Tom"});
        QCOMPARE(keeper.history().next_undo(), std::string("a face lost its name"));
        QCOMPARE(keeper.history().undo(), std::string());
        QCOMPARE(record_of(photo).persons, (std::vector<std::string>{"Tom", "Anna"}));
        QCOMPARE(record_of(photo).faces.at(1).name, std::string("Anna"));
    }

    void a_name_is_kept_where_a_person_finds_it_and_every_name_has_a_place() {
        const AlbumFolder album;
        const AlbumKeeper keeper(album.path());
        const auto kept = [&](const std::string& person) {
            return keeper.place_of_name(person).lexically_relative(album / ".touchphoto" / "people").string();
        };
        QCOMPARE(kept("Jörg M."), std::string("Jörg M..flac"));
        QCOMPARE(kept("Anna/Maria"), std::string("Anna%2FMaria.flac"));
        QCOMPARE(kept("100 %"), std::string("100 %25.flac"));
        QCOMPARE(kept("Oma \"Lisl\"?"), std::string("Oma %22Lisl%22%3F.flac")); // on sticks too
        album.write(".touchphoto/people/Tante: Eva.flac", "spoken before");
        QCOMPARE(kept("Tante: Eva"), std::string("Tante: Eva.flac"));
        QCOMPARE(kept(".hidden"), std::string("%2Ehidden.flac"));
        QCOMPARE(kept("J\xF6rg"), std::string("J%F6rg.flac"));
        QCOMPARE(kept(std::string(200, 'x')), std::string(200, 'x') + ".flac");
        const std::string longer = kept(std::string(201, 'x'));
        QVERIFY(longer.starts_with(std::string(200, 'x') + "-"));
        QCOMPARE(longer.size(), std::size_t{200 + 1 + 16 + 5});
        QVERIFY(longer != kept(std::string(202, 'x')));
    }

    void a_recording_whose_place_is_taken_comes_back_beside_it() {
        const AlbumFolder album;
        const fs::path photo = a_photo(album, "a.jpg", 1);
        AlbumKeeper keeper(album.path());
        const auto added = keeper.add_recording(photo, a_sound(album, "s.wav", 0.5, 300.0), {});
        QVERIFY2(added.ok(), added.error().c_str());
        QCOMPARE(keeper.delete_recording(photo, added->tag.file), std::string());
        const fs::path place = tags_folder(photo) / added->tag.file;
        album.write(place.lexically_relative(album.path()), "another's");
        QCOMPARE(keeper.restore(keeper.trash().entries().at(0).id), std::string());
        const std::string second = place.stem().string() + "-2" + place.extension().string();
        QVERIFY(fs::exists(tags_folder(photo) / second));
        QCOMPARE(record_of(photo).tags.at(0).file, second);
    }

    /// FIPS 180-2, its first example, and what is longer than is read at once.
    void the_same_bytes_have_the_same_number() {
        const AlbumFolder album;
        QCOMPARE(*content_hash(album.write("a", "abc")),
                 std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
        const std::string large(200'000, 'q');
        QCOMPARE(*content_hash(album.write("b", large)), *content_hash(album.write("c", large)));
        QVERIFY(*content_hash(album / "b") != *content_hash(album.write("c", large + "r")));
        QCOMPARE(*content_hash(album.write("empty", "")),
                 std::string("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"));
        QVERIFY(!content_hash(album / "missing").ok());
        QVERIFY(!content_hash(album.path()).ok());
        QCOMPARE(size_or_zero(album / "a"), std::uintmax_t{3});
        QCOMPARE(size_or_zero(album / "missing"), std::uintmax_t{0});
    }

    void an_album_is_the_nearest_folder_that_is_one() {
        const AlbumFolder album;
        album.write(".touchphoto/x", "");
        album.write("2026/may/.touchphoto/x", "");
        QCOMPARE(album_around(album / "2026/may/a/b.jpg"), album / "2026/may");
        QCOMPARE(album_around(album / "2026/b.jpg"), album.path());
        const AlbumFolder none;
        QCOMPARE(album_around(none / "deep/b.jpg"), none / "deep");
    }
};

} // namespace faces_and_names_test

TP_TEST(faces_and_names_test, FacesAndNamesTest, event_loop)
#include "faces_and_names_test.moc"
