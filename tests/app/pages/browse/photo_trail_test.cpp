// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/photo_trail.hpp"
#include "drawn_album.hpp"
#include "test_program.hpp"

#include <QTest>

namespace photo_trail_test {

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;

namespace {

struct Walk {
    DrawnAlbum drawn;
    DrawnAlbum::Five five = drawn.five();
    Walk() { drawn.open(); }

    AlbumIndex& index() { return drawn.album->index(); }
    PhotoEntry entry(const fs::path& photo) { return *drawn.album->queries().find(photo).value(); }
    std::string hash(const fs::path& photo) {
        return drawn.album->queries().summary(entry(photo).id).value()->sha256;
    }
    /// Other programs' changes have come into the index.
    bool knows(std::size_t photos) {
        return QTest::qWaitFor(
            [&] { return !drawn.album->scanning() && index().totals().value().photos == photos; }, 30'000);
    }
};

std::string at(const PhotoTrail& trail) {
    return trail.here() ? trail.here()->path.filename().string() + " " + std::to_string(trail.position()) +
                              "/" + std::to_string(trail.count())
                        : "nowhere of " + std::to_string(trail.count());
}

} // namespace

class PhotoTrailTest : public QObject {
    Q_OBJECT
private slots:
    void from_end_to_end_with_every_place_counted() {
        Walk walk;
        PhotoTrail trail(walk.index(), AllByTime{});
        QVERIFY(*trail.to_first());
        std::vector<std::string> way{at(trail)};
        while (*trail.next())
            way.push_back(at(trail));
        QCOMPARE(way, (std::vector<std::string>{"tower.jpg 1/5", "sea.jpg 2/5", "cat.jpg 3/5",
                                                "garden.jpg 4/5", "walk.png 5/5"}));
        QVERIFY(!*trail.next());
        while (*trail.previous())
            way.pop_back();
        QCOMPARE(at(trail), way.front());
        QCOMPARE(way.size(), std::size_t{1});
        QVERIFY(*trail.to_last());
        QVERIFY(*trail.to(walk.entry(walk.five.cat)));
        QCOMPARE(at(trail), std::string("cat.jpg 3/5"));
    }

    void a_persons_photographs_and_a_years() {
        Walk walk;
        PhotoTrail anna(walk.index(), OfTopic{"person", "Anna"});
        QVERIFY(*anna.to_first());
        QVERIFY(*anna.next());
        QCOMPARE(at(anna), std::string("walk.png 2/2"));
        PhotoTrail year(walk.index(), OfYear{2025});
        QVERIFY(*year.to_last());
        QCOMPARE(at(year), std::string("cat.jpg 2/2"));
        PhotoTrail nobody(walk.index(), OfTopic{"person", "Nobody"});
        QVERIFY(!*nobody.to_first());
        QCOMPARE(at(nobody), std::string("nowhere of 0"));
        QVERIFY(!*nobody.next());
    }

    void what_was_found_is_gone_through_in_its_order() {
        Walk walk;
        PhotoTrail trail(walk.index(),
                         PhotoTrail::Found{walk.entry(walk.five.walk), walk.entry(walk.five.sea)});
        QVERIFY(*trail.to_first());
        QCOMPARE(at(trail), std::string("walk.png 1/2"));
        QVERIFY(*trail.next());
        QVERIFY(!*trail.next());
        QCOMPARE(at(trail), std::string("sea.jpg 2/2"));
        QVERIFY(!*trail.to(walk.entry(walk.five.cat)));
        QCOMPARE(at(trail), std::string("sea.jpg 2/2"));
        fs::remove(walk.five.sea);
        QVERIFY(walk.knows(4));
        QVERIFY(!*trail.look_again({}));
        QCOMPARE(at(trail), std::string("walk.png 1/1"));
        fs::remove(walk.five.walk);
        QVERIFY(walk.knows(3));
        QVERIFY(!*trail.look_again({}));
        QCOMPARE(at(trail), std::string("nowhere of 0"));
    }

    void a_photograph_that_goes_gives_way_to_the_next_and_the_last_to_the_one_before() {
        Walk walk;
        PhotoTrail trail(walk.index(), AllByTime{});
        QVERIFY(*trail.to(walk.entry(walk.five.cat)));
        QVERIFY(*trail.look_again({}));
        fs::remove(walk.five.cat);
        QVERIFY(walk.knows(4));
        QVERIFY(!*trail.look_again({}));
        QCOMPARE(at(trail), std::string("garden.jpg 3/4"));
        QVERIFY(*trail.to_last());
        fs::remove(walk.five.walk);
        QVERIFY(walk.knows(3));
        QVERIFY(!*trail.look_again({}));
        QCOMPARE(at(trail), std::string("garden.jpg 3/3"));
    }

    void one_that_other_programs_renamed_is_the_same_photograph() {
        Walk walk;
        PhotoTrail trail(walk.index(), AllByTime{});
        QVERIFY(*trail.to(walk.entry(walk.five.sea)));
        const std::string hash = walk.hash(walk.five.sea);
        const fs::path there = walk.drawn.root() / "Trieste.jpg";
        fs::rename(walk.five.sea, there);
        fs::rename(walk.five.sea.string() + ".xmp", there.string() + ".xmp");
        QTRY_VERIFY(walk.drawn.album->queries().find(there).value().has_value());
        QVERIFY(walk.knows(5));
        QVERIFY(*trail.look_again(hash));
        QCOMPARE(at(trail), std::string("Trieste.jpg 2/5"));
    }

    void one_that_leaves_its_list_is_left() {
        Walk walk;
        PhotoTrail trail(walk.index(), OfTopic{"person", "Tom"});
        QVERIFY(*trail.to_first());
        walk.drawn.name(walk.five.garden, "Thomas", 0.7);
        walk.drawn.album->touched(walk.five.garden);
        QTRY_VERIFY(walk.drawn.album->queries().page(OfTopic{"person", "Tom"}, {}, 1).value().empty());
        QVERIFY(!*trail.look_again(walk.hash(walk.five.garden)));
        QCOMPARE(at(trail), std::string("nowhere of 0"));
    }

    void pictures_are_read_ahead_on_the_way_one_goes() {
        Walk walk;
        PhotoTrail trail(walk.index(), AllByTime{});
        QVERIFY(trail.ahead(false).empty());
        QVERIFY(*trail.to(walk.entry(walk.five.cat)));
        QCOMPARE(trail.ahead(false),
                 (std::vector<fs::path>{walk.five.garden, walk.five.walk, walk.five.sea}));
        QCOMPARE(trail.ahead(true),
                 (std::vector<fs::path>{walk.five.sea, walk.five.tower, walk.five.garden}));
    }
};

} // namespace photo_trail_test

TP_TEST(photo_trail_test, PhotoTrailTest, window)
#include "photo_trail_test.moc"
