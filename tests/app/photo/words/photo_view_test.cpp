// SPDX-License-Identifier: Apache-2.0
#include "app/photo/words/photo_view.hpp"

#include <QTest>

using namespace tp;

namespace {

/// Faces of that size in the middles given, 0 … 1.
SeenPhoto seen_with(const std::vector<Vec2>& middles, double size = 0.2) {
    SeenPhoto seen;
    seen.width = 1500;
    seen.height = 1000;
    for (const Vec2 middle : middles) {
        SeenFace face;
        face.part = {middle - 0.5 * size, middle + 0.5 * size};
        seen.faces.push_back(face);
    }
    return seen;
}

PhotoView view_of(const std::optional<SeenPhoto>& seen, const PhotoRecord& record = {}) {
    return tp::view_of(seen, record, QLocale::English);
}

std::vector<Spot::Kind> spots(const PhotoView& view) {
    std::vector<Spot::Kind> kinds;
    for (const PersonShown& person : view.people)
        kinds.push_back(person.spot.kind);
    return kinds;
}

using Kind = Spot::Kind;
using Kinds = std::vector<Kind>;

} // namespace

class PhotoViewTest : public QObject {
    Q_OBJECT
private slots:
    void places_are_those_of_who_looks_at_the_picture() {
        QCOMPARE(spots(view_of(seen_with({{0.2, 0.5}}))), Kinds{Kind::left});
        QCOMPARE(spots(view_of(seen_with({{0.5, 0.5}}))), Kinds{Kind::middle});
        QCOMPARE(spots(view_of(seen_with({{0.8, 0.5}}))), Kinds{Kind::right});
        QCOMPARE(spots(view_of(seen_with({{0.6, 0.5}, {0.4, 0.5}}))), (Kinds{Kind::left, Kind::right}));
        QCOMPARE(spots(view_of(seen_with({{0.52, 0.2}, {0.5, 0.8}}))), (Kinds{Kind::below, Kind::above}));
        QCOMPARE(spots(view_of(seen_with({{0.9, 0.5}, {0.1, 0.5}, {0.4, 0.5}}))),
                 (Kinds{Kind::left, Kind::middle, Kind::right}));
        const PhotoView four = view_of(seen_with({{0.1, 0.5}, {0.3, 0.5}, {0.6, 0.5}, {0.9, 0.5}}));
        QCOMPARE(spots(four), (Kinds{Kind::far_left, Kind::from_left, Kind::from_left, Kind::far_right}));
        QCOMPARE(four.people[2].spot.number, std::size_t(3));
    }

    void names_go_to_the_faces_that_they_were_given_to() {
        PhotoRecord record;
        record.faces = {{0.8, 0.5, 0.2, 0.2, "Tom"}, {0.1, 0.9, 0.05, 0.05, "Eva"}};
        record.persons = {"Tom", "Anna"};
        const PhotoView view = view_of(seen_with({{0.2, 0.5}, {0.8, 0.5}}), record);
        QCOMPARE(view.people.size(), std::size_t(3)); // Eva was seen by a person alone
        QCOMPARE(view.people[0].name, QString("Eva"));
        QCOMPARE(view.people[1].name, QString());
        QCOMPARE(view.people[2].name, QString("Tom"));
        QVERIFY(view.people[0].further_back && !view.people[1].further_back);
        QCOMPARE(view.elsewhere, QStringList("Anna"));
    }

    void names_go_along_when_the_picture_had_to_be_turned() {
        SeenPhoto seen = seen_with({{0.2, 0.5}});
        seen.turned_degrees = 90; // what is at the left now was at the bottom
        PhotoRecord record;
        record.faces = {{0.5, 0.8, 0.2, 0.2, "Tom"}};
        const PhotoView view = view_of(seen, record);
        QCOMPARE(view.people.size(), std::size_t(1));
        QCOMPARE(view.people[0].name, QString("Tom"));
    }

    void what_nobody_has_looked_at_or_could_be_read_says_nothing_of_itself() {
        QVERIFY(!view_of({}).seen);
        SeenPhoto unreadable = seen_with({{0.5, 0.5}});
        unreadable.width = 0;
        const PhotoView view = view_of(unreadable);
        QVERIFY(!view.seen && view.people.empty());
        QCOMPARE(shape_of(view), Shape::unknown);
    }

    void only_what_is_sure_counts_as_a_smile() {
        SeenPhoto seen = seen_with({{0.1, 0.5}, {0.3, 0.5}, {0.5, 0.5}, {0.7, 0.5}});
        seen.faces[0].mien = Mien::perhaps_smiling;
        seen.faces[1].mien = Mien::smiling;
        seen.faces[2].mien = Mien::perhaps_laughing; // a broad smile it is
        QCOMPARE(smiling(view_of(seen)), std::size_t(2));
    }

    void shapes() {
        SeenPhoto seen = seen_with({});
        const auto shape = [&](int width, int height) {
            seen.width = width;
            seen.height = height;
            return shape_of(view_of(seen));
        };
        QCOMPARE(shape(3000, 4000), Shape::upright);
        QCOMPARE(shape(1000, 1000), Shape::square);
        QCOMPARE(shape(4000, 3000), Shape::wide);
        QCOMPARE(shape(9000, 3000), Shape::panorama);
    }

    void times_of_day_are_known_only_where_a_camera_said_so() {
        const auto view = [](const std::string& taken) {
            PhotoRecord record;
            record.taken = taken;
            return view_of({}, record);
        };
        QCOMPARE(view("2019-05-12T19:30:00+02:00").date, QDate(2019, 5, 12));
        QCOMPARE(view("2019-05-12T19:30:00+02:00").time, QTime(19, 30));
        QVERIFY(!view("2019-05-12T00:00:00").time.isValid());
        QVERIFY(view("2019-05-12T00:00:07").time.isValid());
        QVERIFY(!view("2019-05-12").time.isValid());
        QVERIFY(!view("2019-13-12T19:30:00").date.isValid());
        QVERIFY(!view("2019-13-12T19:30:00").time.isValid());
        QVERIFY(!view("yesterday").date.isValid());
    }

    void a_place_that_somebody_wrote_goes_before_the_nearest_town() {
        PhotoRecord record;
        record.place = Place{48.2085, 16.3721};
        QCOMPARE(tp::view_of({}, record, QLocale::English).town, QString("Vienna"));
        QCOMPARE(tp::view_of({}, record, QLocale::German).town, QString("Wien"));
        QCOMPARE(tp::view_of({}, record, QLocale::Korean).town, QString("비엔나"));
        QCOMPARE(tp::view_of({}, record, QLocale::English).where, NearTown::Where::in);
        record.place_name = "Grandmother's garden, Vienna";
        QCOMPARE(tp::view_of({}, record, QLocale::German).town, QString("Grandmother's garden"));
        record.place_name.clear();
        record.place = Place{-48.0, -128.0};
        QCOMPARE(tp::view_of({}, record, QLocale::German).town, QString());
    }
};

QTEST_APPLESS_MAIN(PhotoViewTest)
#include "photo_view_test.moc"
