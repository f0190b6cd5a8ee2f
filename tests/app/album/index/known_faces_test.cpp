// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/known_faces.hpp"
#include "app/album/index/seen_photos.hpp"
#include "test_album.hpp"
#include "test_program.hpp"

#include <QDir>
#include <QFile>
#include <QStringList>
#include <QTest>

#include <algorithm>
#include <memory>
#include <string>

namespace known_faces_test {

using namespace tp;
using namespace tp::testing;

namespace {

/// `marks`: "f" a face that may be guessed, "b" a blurred one.
Looked seen_with(const std::string& marks) {
    Looked looked;
    looked.seen.width = looked.seen.height = 100;
    looked.seen.turned_degrees = 90;
    double left = 0.0;
    for (const char mark : marks) {
        SeenFace face;
        face.part = {Vec2(left, 0.25), Vec2(left + 0.25, 0.5)};
        left += 0.25;
        looked.seen.faces.push_back(face);
        looked.marks.push_back(mark == 'f' ? FaceMark{NoGuess::none, std::string(128, mark)}
                                           : FaceMark{NoGuess::blurred, {}});
    }
    return looked;
}

/// An album with three photographs, the last two with the same bytes.
struct Bench {
    TestAlbum album;
    std::unique_ptr<AlbumIndex> index;

    Bench() {
        album.add("a.jpg", "first");
        album.add("b.jpg", "second");
        album.add("c.jpg", "second");
        index = std::make_unique<AlbumIndex>(AlbumIndex::in_memory().value());
        scan();
    }
    void scan() {
        if (!album.scan(*index))
            qFatal("no scan");
    }
    void look(const std::string& name, const std::string& marks) {
        QCOMPARE(SeenPhotos(*index, 1, true).put(sha256_of(name), seen_with(marks)), std::string());
    }
    std::string sha256_of(const std::string& name) {
        AlbumQueries queries(*index);
        return queries.summary(queries.find(path(name)).value()->id).value()->sha256;
    }
    fs::path path(const std::string& name) { return fs::canonical(album.root()) / name; }
    KnownFaces faces() { return KnownFaces(*index); }
    /// All that is to be grouped, and says so to the index.
    std::vector<FacesToGroup> take_all(std::int64_t group = 1) {
        std::vector<FacesToGroup> all;
        GroupsKept kept;
        std::string after;
        while (const auto next = faces().next(after).value()) {
            after = next->hash;
            kept.done.push_back(*next);
            for (const FacesToGroup::Face& face : next->faces)
                kept.groups_of.emplace_back(face.stored.id, group);
            all.push_back(*next);
        }
        kept.names[group] = "Anna";
        kept.last = group;
        kept.taken_away = faces().gone().value();
        if (const std::string problem = faces().keep(kept); !problem.empty())
            qFatal("%s", problem.c_str());
        return all;
    }
};

} // namespace

class KnownFacesTest : public QObject {
    Q_OBJECT
private slots:
    void faces_that_may_be_guessed_are_to_be_grouped_once() {
        Bench bench;
        bench.look("a.jpg", "fbf");
        const auto all = bench.take_all();
        QCOMPARE(all.size(), std::size_t(1));
        QCOMPARE(all[0].faces.size(), std::size_t(2));
        QCOMPARE(all[0].turned_degrees, 90);
        QCOMPARE(all[0].faces[0].stored.numbers, std::string(128, 'f'));
        QCOMPARE(all[0].faces[1].part.min.x, 0.5);
        QVERIFY(!bench.faces().next().value());
        QCOMPARE(bench.faces().not_guessed().value(), std::size_t(1));
        QCOMPARE(bench.faces().to_look().value(), std::size_t(2));
        bench.look("b.jpg", "");
        QCOMPARE(bench.faces().to_look().value(), std::size_t(0)); // c has the same bytes
    }

    void groups_are_kept_as_they_are() {
        Bench bench;
        bench.look("a.jpg", "ff");
        bench.look("b.jpg", "f");
        bench.take_all(7);
        const StoredGroups all = bench.faces().all().value();
        QCOMPARE(all.faces.size(), std::size_t(3));
        QVERIFY(std::ranges::all_of(all.faces, [](const StoredFace& face) { return face.group == 7; }));
        QCOMPARE(all.names.at(7), std::string("Anna"));
        QCOMPARE(all.last, std::int64_t(7));
        GroupsKept kept;
        kept.apart = {{all.faces[0].id, 7}, {all.faces[1].id, 3}, {999, 3}}; // there is no face 999
        kept.names[7] = std::nullopt;
        kept.said = {{all.faces[0].id, "Bert"}};
        QCOMPARE(bench.faces().keep(kept), std::string());
        kept = {};
        kept.no_more_apart = {{all.faces[1].id, 3}};
        QCOMPARE(bench.faces().keep(kept), std::string());
        const StoredGroups after = bench.faces().all().value();
        QVERIFY(after.names.empty());
        QCOMPARE(after.apart, (std::vector<std::pair<std::int64_t, std::int64_t>>{{all.faces[0].id, 7}}));
        QCOMPARE(after.faces[0].said, std::string("Bert"));
        QCOMPARE(after.last, std::int64_t(7)); // never smaller
    }

    void a_face_lies_where_its_photographs_do() {
        Bench bench;
        bench.look("b.jpg", "f");
        const auto placed = bench.faces().placed().value();
        QCOMPARE(placed.size(), std::size_t(2)); // two files with the same bytes
        QCOMPARE(placed[0].id, placed[1].id);
        QCOMPARE(bench.faces().placed_on(bench.path("c.jpg")).value().size(), std::size_t(1));
        QCOMPARE(bench.faces().placed_on(bench.path("c.jpg")).value()[0].photo, bench.path("c.jpg"));
        QVERIFY(bench.faces().placed_on(bench.path("a.jpg")).value().empty());
        fs::remove(bench.path("b.jpg"));
        bench.scan();
        QCOMPARE(bench.faces().placed().value().size(), std::size_t(1));
    }

    void the_numbers_of_a_face_go_with_its_last_photograph() {
        Bench bench;
        bench.look("a.jpg", "ff");
        bench.look("b.jpg", "f");
        bench.take_all();
        fs::rename(bench.path("a.jpg"), bench.path("moved.jpg"));
        fs::remove(bench.path("b.jpg"));
        bench.scan();
        QCOMPARE(bench.faces().all().value().faces.size(), std::size_t(3)); // c has the same bytes as b
        fs::remove(bench.path("c.jpg"));
        bench.scan();
        QCOMPARE(bench.faces().all().value().faces.size(), std::size_t(2));
        fs::remove(bench.path("moved.jpg"));
        bench.scan();
        QVERIFY(bench.faces().all().value().faces.empty());
        bench.album.add("again.jpg", "first"); // is looked at again, as one that was never there
        bench.scan();
        QCOMPARE(bench.faces().to_look().value(), std::size_t(1));
    }

    void what_is_forgotten_is_in_no_file() {
        TestAlbum album;
        album.add("a.jpg", "first");
        const fs::path cache = album.cache();
        AlbumIndex index = AlbumIndex::open(cache).value();
        AlbumIndex of_the_page = index.another().value(); // so that SQLite's log stays
        QVERIFY(album.scan(index));
        AlbumQueries queries(index);
        const std::string sha256 =
            queries.summary(queries.find(fs::canonical(album.root()) / "a.jpg").value()->id).value()->sha256;
        const auto files_with = [&](const std::string& bytes) {
            QStringList names;
            for (const QString& name : QDir(QString::fromStdString(cache.string())).entryList(QDir::Files)) {
                QFile file(QString::fromStdString(cache.string()) + '/' + name);
                if (file.open(QIODevice::ReadOnly) &&
                    file.readAll().contains(QByteArray::fromStdString(bytes)))
                    names << name;
            }
            return names;
        };
        const std::string numbers(128, 'f');
        QCOMPARE(SeenPhotos(index, 1, true).put(sha256, seen_with("ff")), std::string());
        GroupsKept kept;
        kept.names[1] = "Anastasia Unmistakable";
        QCOMPARE(KnownFaces(index).keep(kept), std::string());
        QFile aside(QString::fromStdString((cache / "album.sqlite.aside").string()));
        QVERIFY(aside.open(QIODevice::WriteOnly) && aside.write("Anastasia Unmistakable") > 0);
        aside.close();
        QVERIFY(!files_with(numbers).isEmpty());
        QVERIFY(files_with("Anastasia Unmistakable").size() >= 2);
        QVERIFY(KnownFaces(index).forget().value());
        QCOMPARE(files_with(numbers), QStringList());
        QCOMPARE(files_with("Anastasia Unmistakable"), QStringList());
        QCOMPARE(KnownFaces(of_the_page).to_look().value(), std::size_t(1));
    }

    void what_is_said_while_it_is_grouped_is_not_lost() {
        Bench bench;
        bench.look("a.jpg", "f");
        GroupsKept kept;
        kept.done.push_back(*bench.faces().next().value());
        PhotoRecord record;
        record.faces = {{0.5, 0.5, 0.25, 0.25, "Anna"}};
        write_file(fs::path(bench.path("a.jpg").string() + ".xmp"), sidecar_text(record));
        QVERIFY(bench.album.settles());
        bench.scan();
        QCOMPARE(bench.faces().keep(kept), std::string());
        const auto again = bench.faces().next().value();
        QVERIFY(again);
        QCOMPARE(again->copies[0].regions[0].name, std::string("Anna"));
        kept.done = {*again};
        QCOMPARE(bench.faces().keep(kept), std::string());
        QVERIFY(!bench.faces().next().value());
    }

    void what_somebody_says_of_a_face_makes_it_to_be_grouped_again() {
        Bench bench;
        bench.look("a.jpg", "f");
        bench.take_all();
        PhotoRecord record;
        record.faces = {{0.5, 0.5, 0.25, 0.25, "Anna"}};
        write_file(fs::path(bench.path("a.jpg").string() + ".xmp"), sidecar_text(record));
        QVERIFY(bench.album.settles());
        bench.scan();
        auto next = bench.faces().next().value();
        QVERIFY(next);
        QCOMPARE(next->copies.size(), std::size_t(1));
        QCOMPARE(next->copies[0].regions.at(0).name, std::string("Anna"));
        bench.take_all();
        fs::remove(fs::path(bench.path("a.jpg").string() + ".xmp"));
        bench.scan();
        next = bench.faces().next().value();
        QVERIFY(next && next->copies[0].regions.empty());
    }

    void faces_of_what_is_looked_at_again_are_others_and_the_old_ones_are_told() {
        Bench bench;
        bench.look("a.jpg", "ff");
        const auto first = bench.take_all();
        bench.look("a.jpg", "f");
        QCOMPARE(bench.faces().gone().value().size(), std::size_t(2));
        const auto again = bench.take_all();
        QVERIFY(again.at(0).faces.at(0).stored.id > first.at(0).faces.at(1).stored.id); // none is given twice
        QVERIFY(bench.faces().gone().value().empty());
    }

    void a_photograph_that_is_gone_for_good_takes_its_faces_along() {
        Bench bench;
        bench.look("a.jpg", "ff");
        bench.take_all();
        fs::remove(bench.path("a.jpg"));
        bench.scan();
        QVERIFY(forgets_missing(*bench.index));
        QCOMPARE(bench.faces().gone().value().size(), std::size_t(2));
        QVERIFY(bench.faces().all().value().faces.empty());
    }

    void all_is_forgotten_but_what_can_be_said() {
        Bench bench;
        bench.look("a.jpg", "fb");
        bench.take_all();
        QVERIFY(bench.faces().forget().value());
        QVERIFY(!bench.faces().forget().value());
        QVERIFY(bench.faces().placed().value().empty());
        QVERIFY(bench.faces().all().value().names.empty());
        QCOMPARE(bench.faces().not_guessed().value(), std::size_t(0));
        const PhotoId photo = AlbumQueries(*bench.index).find(bench.path("a.jpg")).value()->id;
        QCOMPARE(AlbumQueries(*bench.index).summary(photo).value()->seen->faces.size(), std::size_t(2));
        QVERIFY(!SeenPhotos(*bench.index, 1).of(photo, "en 1").value()->to_look);
        QVERIFY(SeenPhotos(*bench.index, 1, true)
                    .of(photo, "en 1")
                    .value()
                    ->to_look); // known again: looked at again
    }

    void all_are_grouped_anew_where_that_is_asked_for() {
        Bench bench;
        bench.look("a.jpg", "f");
        bench.look("b.jpg", "f");
        bench.take_all();
        QCOMPARE(bench.faces().begin_anew(), std::string());
        QVERIFY(bench.faces().all().value().faces.empty());
        QCOMPARE(bench.take_all().size(), std::size_t(2));
    }
};

} // namespace known_faces_test

TP_TEST(known_faces_test, KnownFacesTest, event_loop)
#include "known_faces_test.moc"
