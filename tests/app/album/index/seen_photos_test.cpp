// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/seen_photos.hpp"
#include "test_album.hpp"
#include "test_program.hpp"

#include <QTest>

#include <memory>
#include <string>

namespace seen_photos_test {

using namespace tp;
using namespace tp::testing;

namespace {

constexpr const char* worded = "en 1";

SeenPhoto two_people() {
    SeenPhoto seen;
    seen.width = 4000;
    seen.height = 3000;
    seen.turned_degrees = 90;
    seen.light = Light::bright_background;
    seen.colours = Colours::violet;
    seen.blurred = true;
    SeenFace face;
    face.part = {Vec2(0.125, -0.25), Vec2(0.5, 1.0 / 3.0)};
    face.cut_off = true;
    face.mien = Mien::perhaps_laughing;
    face.eyes = Eyes::shut;
    face.facing = Facing::right;
    seen.faces = {face, SeenFace()};
    return seen;
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
        if (!album.scan(*index))
            qFatal("no scan");
    }
    SeenPhotos seen(int look = 1) { return SeenPhotos(*index, look); }
    PhotoSummary summary(const std::string& name) {
        AlbumQueries queries(*index);
        const auto entry = queries.find(fs::canonical(album.root()) / name);
        return queries.summary(entry.value()->id).value().value();
    }
    std::size_t found(const char* typed) { return AlbumQueries(*index).search(typed, 10).value().size(); }
    /// Names of what is to be worded, newest first.
    std::string to_word(const char* how = worded) {
        std::string names;
        std::optional<PlaceInList> before;
        for (int i = 0; i < 10; ++i) {
            const auto next = seen().next(how, before);
            if (!next || !*next)
                break;
            names += (*next)->summary.entry.path.stem().string();
            before = (*next)->summary.entry.place;
        }
        return names;
    }
};

} // namespace

class SeenPhotosTest : public QObject {
    Q_OBJECT
private slots:
    void what_was_seen_is_kept_as_it_is() {
        Bench bench;
        QVERIFY(!bench.summary("a.jpg").seen);
        QCOMPARE(bench.seen().put(bench.summary("a.jpg").sha256, {two_people(), {}}), std::string());
        QVERIFY(bench.summary("a.jpg").seen == two_people());
        SeenPhoto one = two_people();
        one.faces.pop_back();
        QCOMPARE(bench.seen().put(bench.summary("a.jpg").sha256, {one, {}}), std::string());
        QVERIFY(bench.summary("a.jpg").seen == one);
        QCOMPARE(faults_of(*bench.index), std::string());
    }

    void photographs_with_the_same_bytes_are_seen_at_once() {
        Bench bench;
        bench.seen().put(bench.summary("b.jpg").sha256, {two_people(), {}});
        QVERIFY(bench.summary("c.jpg").seen == two_people());
        const auto next = bench.seen().of(bench.summary("c.jpg").entry.id, worded);
        QVERIFY(next.value() && !next.value()->to_look);
    }

    void the_newest_is_next_until_all_are_worded() {
        Bench bench;
        QCOMPARE(bench.to_word().size(), std::size_t(3));
        const std::string all = bench.to_word();
        for (const char name : all) {
            QCOMPARE(bench.to_word().front(), name);
            const PhotoSummary photo = bench.summary(std::string(1, name) + ".jpg");
            QCOMPARE(bench.seen().put_words(photo.entry.id, worded, "three people"), std::string());
        }
        QCOMPARE(bench.to_word(), std::string());
        QCOMPARE(bench.to_word("de 1").size(), std::size_t(3)); // in another language they are not
    }

    void what_an_older_look_saw_is_looked_at_again() {
        Bench bench;
        const PhotoSummary photo = bench.summary("a.jpg");
        bench.seen(1).put(photo.sha256, {two_people(), {}});
        QVERIFY(!bench.seen(1).of(photo.entry.id, worded).value()->to_look);
        QVERIFY(bench.seen(2).of(photo.entry.id, worded).value()->to_look);
    }

    void the_search_knows_what_was_seen() {
        Bench bench;
        const PhotoSummary photo = bench.summary("a.jpg");
        bench.seen().put_words(photo.entry.id, worded, "Three people, all smiling");
        QCOMPARE(bench.found("three smiling"), std::size_t(1));
        bench.seen().put_words(photo.entry.id, "de 1", "Drei Personen");
        QCOMPARE(bench.found("smiling"), std::size_t(0));
        QCOMPARE(bench.found("person"), std::size_t(1));
        QCOMPARE(faults_of(*bench.index), std::string());
    }

    /// A sidecar that says something else is put in words again, and not looked at again.
    void another_name_means_other_words() {
        Bench bench;
        const PhotoSummary photo = bench.summary("a.jpg");
        bench.seen().put(photo.sha256, {two_people(), {}});
        bench.seen().put_words(photo.entry.id, worded, "smiling");
        TestAlbum::set_people(bench.album.root() / "a.jpg", {"Anna"});
        QVERIFY(bench.album.settles());
        QVERIFY(bench.album.scan(*bench.index));
        const auto next = bench.seen().of(photo.entry.id, worded);
        QVERIFY(next.value() && !next.value()->to_look);
        QCOMPARE(bench.found("smiling"), std::size_t(0)); // until it is worded
        QCOMPARE(bench.found("Anna"), std::size_t(1));
    }

    void a_look_that_was_begun_twice_is_not_begun_again() {
        Bench bench;
        const PhotoSummary photo = bench.summary("a.jpg");
        QCOMPARE(bench.seen().begin(photo.sha256), std::string());
        QVERIFY(bench.seen().of(photo.entry.id, worded).value()->to_look); // the program may have been closed
        QCOMPARE(bench.seen().begin(photo.sha256), std::string());
        QVERIFY(!bench.seen().of(photo.entry.id, worded).value()->to_look);
        QCOMPARE(bench.summary("a.jpg").seen->width, 0);
        QCOMPARE(bench.seen().forget(photo.sha256), std::string());
        QVERIFY(bench.seen().of(photo.entry.id, worded).value()->to_look);
    }

    /// Each way of looking may begin twice; what was seen since, and nothing, is an end.
    void beginnings_are_counted_for_one_way_of_looking_and_end_with_a_look() {
        Bench bench;
        const PhotoSummary photo = bench.summary("a.jpg");
        const auto to_look = [&](int look, bool marks) {
            return SeenPhotos(*bench.index, look, marks).of(photo.entry.id, worded).value()->to_look;
        };
        bench.seen().begin(photo.sha256);
        SeenPhotos(*bench.index, 9, true).begin(photo.sha256);
        QVERIFY(to_look(9, true));
        SeenPhotos(*bench.index, 9, true).begin(photo.sha256);
        QVERIFY(!to_look(9, true));
        bench.seen().put(photo.sha256, {}); // nothing to be seen
        QVERIFY(!bench.seen().of(photo.entry.id, worded).value()->to_look);
        bench.seen().begin(photo.sha256); // the first one again
        bench.seen().put(photo.sha256, {two_people(), {}});
        QVERIFY(!bench.seen().of(photo.entry.id, worded).value()->to_look);
    }

    void what_is_gone_for_good_is_forgotten() {
        Bench bench;
        bench.seen().put(bench.summary("a.jpg").sha256, {two_people(), {}});
        bench.seen().put(bench.summary("b.jpg").sha256, {two_people(), {}});
        fs::remove(bench.album.root() / "a.jpg");
        fs::remove(bench.album.root() / "b.jpg"); // its bytes are in c.jpg too
        QVERIFY(bench.album.scan(*bench.index));
        QVERIFY(forgets_missing(*bench.index));
        SqlRun run = bench.index->connection().run("SELECT count(*) FROM seen");
        QVERIFY(run.next());
        QCOMPARE(run.integer(0), std::int64_t(1));
        SqlRun faces = bench.index->connection().run("SELECT count(*) FROM seen_faces");
        QVERIFY(faces.next());
        QCOMPARE(faces.integer(0), std::int64_t(2));
        QVERIFY(bench.summary("c.jpg").seen == two_people());
    }

    void numbers_that_mean_nothing_become_what_says_nothing() {
        Bench bench;
        bench.seen().put(bench.summary("a.jpg").sha256, {two_people(), {}});
        bench.index->connection().run_once("UPDATE seen SET light = 99, colours = -1");
        bench.index->connection().run_once("UPDATE seen_faces SET mien = 5, eyes = 'x', facing = 1e30");
        const SeenPhoto seen = bench.summary("a.jpg").seen.value();
        QCOMPARE(seen.light, Light::usual);
        QCOMPARE(seen.colours, Colours::many);
        QCOMPARE(seen.faces[0].mien, Mien::unknown);
        QCOMPARE(seen.faces[0].eyes, Eyes::unknown);
        QCOMPARE(seen.faces[0].facing, Facing::unknown);
    }
};

} // namespace seen_photos_test

TP_TEST(seen_photos_test, SeenPhotosTest, event_loop)
#include "seen_photos_test.moc"
