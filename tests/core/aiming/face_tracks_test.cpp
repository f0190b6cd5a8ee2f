// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/face_tracks.hpp"
#include "frames.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace face_tracks_test {

using namespace tp;
using namespace tp::testing;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

AimFace box_of(Vec2 min, Vec2 max) {
    AimFace face;
    face.box = {min, max};
    return face;
}

} // namespace

class FaceTracksTest : public QObject {
    Q_OBJECT
private slots:
    void a_face_counts_from_its_second_frame_on() {
        FaceTracks tracks;
        tracks.see(frame_of(0.0, {face_at(0.3, 0.4)}));
        QCOMPARE(tracks.faces().size(), std::size_t{0});
        tracks.see(frame_of(0.1, {face_at(0.3, 0.4)}));
        QCOMPARE(tracks.faces().size(), std::size_t{1});
        QCOMPARE(tracks.faces()[0].sightings, 2);
        const Rect seen = face_at(0.3, 0.4).box; // where it was all the time
        QVERIFY(length(tracks.faces()[0].box.min - seen.min) < 1e-12);
        QVERIFY(length(tracks.faces()[0].box.max - seen.max) < 1e-12);
        tracks.forget();
        QVERIFY(tracks.faces().empty());
    }

    void what_is_no_face_is_not_followed_data() {
        QTest::addColumn<double>("x0");
        QTest::addColumn<double>("y0");
        QTest::addColumn<double>("x1");
        QTest::addColumn<double>("y1");
        QTest::addColumn<double>("confidence");
        QTest::newRow("left_is_nan") << no_number << 0.2 << 0.4 << 0.6 << 1.0;
        QTest::newRow("bottom_is_infinite") << 0.2 << 0.2 << 0.4 << inf << 1.0;
        QTest::newRow("no_width") << 0.3 << 0.2 << 0.3 << 0.6 << 1.0;
        QTest::newRow("no_height") << 0.2 << 0.6 << 0.4 << 0.6 << 1.0;
        QTest::newRow("inside_out") << 0.4 << 0.2 << 0.2 << 0.6 << 1.0;
        QTest::newRow("right_of_the_picture") << 1.1 << 0.2 << 1.3 << 0.6 << 1.0;
        QTest::newRow("above_the_picture") << 0.2 << -0.6 << 0.4 << -0.1 << 1.0;
        QTest::newRow("left_of_the_picture") << -0.6 << 0.2 << -0.1 << 0.6 << 1.0;
        QTest::newRow("below_the_picture") << 0.2 << 1.2 << 0.4 << 1.6 << 1.0;
        QTest::newRow("many_pictures_wide") << -9.0 << -9.0 << 9.0 << 9.0 << 1.0;
        QTest::newRow("four_pictures_wide") << -2.0 << -2.0 << 2.0 << 2.0 << 1.0;
        QTest::newRow("up_to_the_left_edge") << -0.2 << 0.2 << 0.0 << 0.6 << 1.0;
        QTest::newRow("up_to_the_upper_edge") << 0.2 << -0.4 << 0.4 << 0.0 << 1.0;
        QTest::newRow("from_the_right_edge_on") << 1.0 << 0.2 << 1.2 << 0.6 << 1.0;
        QTest::newRow("from_the_lower_edge_on") << 0.2 << 1.0 << 0.4 << 1.4 << 1.0;
        QTest::newRow("hardly_sure") << 0.2 << 0.2 << 0.4 << 0.6 << 0.4;
        QTest::newRow("sureness_is_nan") << 0.2 << 0.2 << 0.4 << 0.6 << no_number;
    }
    void what_is_no_face_is_not_followed() {
        QFETCH(double, x0);
        QFETCH(double, y0);
        QFETCH(double, x1);
        QFETCH(double, y1);
        QFETCH(double, confidence);
        AimFace face = box_of({x0, y0}, {x1, y1});
        face.confidence = confidence;
        FaceTracks tracks;
        for (int i = 0; i < 5; ++i)
            tracks.see(frame_of(0.1 * i, {face, face_at(0.7, 0.5)}));
        QCOMPARE(tracks.faces().size(), std::size_t{1});
        QVERIFY(tracks.faces()[0].box.centre().x > 0.6);
    }

    void a_face_may_reach_far_over_the_edges() {
        for (const AimFace& face : {box_of({-1.9, -1.9}, {1.9, 1.9}), box_of({-0.2, 0.2}, {0.01, 0.6}),
                                    box_of({0.99, 0.2}, {1.2, 0.6}), box_of({0.2, -0.4}, {0.4, 0.01}),
                                    box_of({0.2, 0.99}, {0.4, 1.4})}) {
            FaceTracks tracks;
            tracks.see(frame_of(0.0, {face}));
            tracks.see(frame_of(0.1, {face}));
            QCOMPARE(tracks.faces().size(), std::size_t{1});
        }
    }

    void a_face_that_flickers_stays_and_one_that_is_gone_goes() {
        FaceTracks tracks;
        double now = 0.0;
        for (int i = 0; i < 30; ++i, now += 0.1) {
            tracks.see(
                frame_of(now, i % 3 == 0 || i < 2 ? std::vector{face_at(0.3, 0.4)} : std::vector<AimFace>{}));
            if (i > 1)
                QCOMPARE(tracks.faces().size(), std::size_t{1});
        }
        const std::uint32_t id = tracks.faces()[0].id;
        const double last = tracks.faces()[0].seen_s;
        tracks.see(frame_of(last + 0.5, {}));
        QCOMPARE(tracks.faces().size(), std::size_t{1});
        QCOMPARE(tracks.faces()[0].id, id);
        tracks.see(frame_of(last + 0.51, {}));
        QVERIFY(tracks.faces().empty());
    }

    void a_face_is_sure_from_a_half_on_and_a_break_longer_than_a_second_is_one() {
        for (const double confidence : {0.49, 0.5}) {
            AimFace face = face_at(0.3, 0.4);
            face.confidence = confidence;
            FaceTracks tracks;
            tracks.see(frame_of(0.0, {face}));
            tracks.see(frame_of(0.1, {face}));
            QCOMPARE(tracks.faces().size(), confidence < 0.5 ? std::size_t{0} : std::size_t{1});
        }
        for (const double gap : {0.99, 1.0, 1.01}) {
            FaceTracks tracks;
            tracks.see(frame_of(0.0, {}));
            tracks.see(frame_of(gap, {}));
            QCOMPARE(tracks.breaks(), gap > 1.0 ? 1U : 0U);
        }
    }

    void boxes_are_smoothed_and_their_speed_is_known() {
        FaceTracks tracks;
        for (int i = 0; i < 20; ++i)
            tracks.see(frame_of(0.1 * i, {face_at(0.2 + 0.02 * i, 0.5)}));
        const TrackedFace& face = tracks.faces()[0];
        QVERIFY(std::abs(face.speed.x - 0.2) < 0.01);
        QVERIFY(std::abs(face.speed.y) < 1e-9);
        QVERIFY(face.box.centre().x < 0.2 + 0.02 * 19 && face.box.centre().x > 0.2 + 0.02 * 18);
    }

    /// A low-pass of 80 ms: a frame of 100 ms takes 71 % of the way.
    void what_changes_is_followed_by_so_much_of_the_way() {
        FaceTracks tracks;
        for (int i = 0; i < 5; ++i)
            tracks.see(frame_of(0.1 * i, {face_at(0.3, 0.4, 0.27, 0.0), face_at(0.8, 0.8, 0.1)}));
        tracks.see(frame_of(0.5, {face_at(0.34, 0.42, 0.27, 10.0), face_at(0.8, 0.8, 0.1)}));
        const double share = 1.0 - std::exp(-0.1 / 0.08);
        const TrackedFace& face = tracks.faces()[0];
        QVERIFY(length(face.box.centre() - (Vec2(0.3, 0.4) + share * Vec2(0.04, 0.02))) < 1e-9);
        QVERIFY(length(face.speed - share * share * Vec2(0.4, 0.2)) < 1e-9);
        QVERIFY(std::abs(*face.tilt_deg - share * 10.0) < 1e-6);
        QVERIFY(std::abs(face.box.height() - 0.27) < 1e-9);
        QCOMPARE(face.sightings, 6);
        QCOMPARE(face.seen_s, 0.5);
    }

    void a_face_is_smoothed_from_its_second_frame_on() {
        FaceTracks tracks;
        tracks.see(frame_of(0.0, {face_at(0.3, 0.4)}));
        tracks.see(frame_of(0.1, {face_at(0.34, 0.4)}));
        const double share = 1.0 - std::exp(-0.1 / 0.08);
        QVERIFY(std::abs(tracks.faces()[0].box.centre().x - (0.3 + share * 0.04)) < 1e-9);
        QVERIFY(std::abs(tracks.faces()[0].speed.x - share * share * 0.4) < 1e-9);
    }

    void what_is_not_told_of_a_face_stays_as_it_was() {
        FaceTracks tracks;
        AimFace face = face_at(0.3, 0.4);
        face.brightness = 0.4;
        face.name = "Anna";
        tracks.see(frame_of(0.0, {face}));
        face.brightness = no_number;
        face.name.clear();
        face.eyes_shut = true;
        tracks.see(frame_of(0.1, {face}));
        QCOMPARE(tracks.faces()[0].brightness, std::optional(0.4));
        QCOMPARE(tracks.faces()[0].name, std::string("Anna"));
        QVERIFY(tracks.faces()[0].eyes_shut);
        face.brightness = 0.6;
        face.eyes_shut = false;
        tracks.see(frame_of(0.2, {face}));
        QCOMPARE(tracks.faces()[0].brightness, std::optional(0.6));
        QVERIFY(!tracks.faces()[0].eyes_shut);
    }

    void a_tilt_is_that_of_the_eyes_whichever_comes_first_data() {
        QTest::addColumn<double>("tilt");
        for (const double tilt : {-60.0, -12.0, 0.0, 5.0, 44.0})
            QTest::addRow("%g degrees", tilt) << tilt;
    }
    void a_tilt_is_that_of_the_eyes_whichever_comes_first() {
        QFETCH(double, tilt);
        for (const bool swapped : {false, true}) {
            AimFace face = face_at(0.5, 0.5, 0.3, tilt);
            if (swapped)
                std::swap((*face.eyes)[0], (*face.eyes)[1]);
            FaceTracks tracks;
            tracks.see(frame_of(0.0, {face}));
            tracks.see(frame_of(0.1, {face}));
            QVERIFY(tracks.faces()[0].tilt_deg);
            QVERIFY(std::abs(*tracks.faces()[0].tilt_deg - tilt) < 1e-6);
        }
    }

    void eyes_that_stand_above_one_another_turn_the_way_they_are_told() {
        for (const double second : {0.4, 0.6}) {
            AimFace face = face_at(0.5, 0.5);
            face.eyes = {{Vec2(0.5, 0.5), Vec2(0.5, second)}};
            FaceTracks tracks;
            tracks.see(frame_of(0.0, {face}));
            tracks.see(frame_of(0.1, {face}));
            QVERIFY(std::abs(*tracks.faces()[0].tilt_deg - (second > 0.5 ? 90.0 : -90.0)) < 1e-9);
        }
    }

    void eyes_in_one_place_or_nowhere_say_no_tilt() {
        for (const auto& [eye, says] :
             {std::pair{Vec2(0.5, 0.5), false}, std::pair{Vec2(no_number, 0.5), false},
              std::pair{Vec2(0.5, 0.5 + 0.7e-6), false}, std::pair{Vec2(0.5, 0.5 + 1.5e-6), true}}) {
            AimFace face = face_at(0.5, 0.5);
            face.eyes = {{eye, Vec2(0.5, 0.5)}};
            FaceTracks tracks;
            tracks.see(frame_of(0.0, {face}));
            tracks.see(frame_of(0.1, {face}));
            QCOMPARE(tracks.faces().size(), std::size_t{1});
            QCOMPARE(tracks.faces()[0].tilt_deg.has_value(), says);
        }
    }

    void fifty_faces_are_fifty_and_ninety_are_the_largest() {
        for (const int count : {50, 90}) {
            std::vector<AimFace> crowd;
            for (int i = 0; i < count; ++i)
                crowd.push_back(face_at(0.05 + 0.1 * (i % 10), 0.06 + 0.1 * (i / 10), 0.05 + 0.0003 * i));
            FaceTracks tracks;
            for (int i = 0; i < 5; ++i) {
                std::reverse(crowd.begin(), crowd.end());
                tracks.see(frame_of(0.1 * i, crowd));
            }
            QCOMPARE(tracks.faces().size(), static_cast<std::size_t>(std::min(count, 64)));
            QVERIFY(tracks.faces().front().box.height() >= tracks.faces().back().box.height());
            QVERIFY(std::abs(tracks.faces().front().box.height() - (0.05 + 0.0003 * (count - 1))) < 1e-3);
        }
    }

    void a_clock_that_jumps_begins_anew_data() {
        QTest::addColumn<double>("to");
        QTest::newRow("back") << 1.0;
        QTest::newRow("far_ahead") << 1000.0;
    }
    void a_clock_that_jumps_begins_anew() {
        QFETCH(double, to);
        FaceTracks tracks;
        for (int i = 0; i < 5; ++i)
            tracks.see(frame_of(2.0 + 0.1 * i, {face_at(0.3, 0.4)}));
        QCOMPARE(tracks.breaks(), 0U);
        tracks.see(frame_of(to, {face_at(0.3, 0.4)}));
        QCOMPARE(tracks.breaks(), 1U);
        QVERIFY(tracks.faces().empty());
        tracks.see(frame_of(to + 0.1, {face_at(0.3, 0.4)}));
        QCOMPARE(tracks.faces().size(), std::size_t{1});
        QVERIFY(length(tracks.faces()[0].speed) < 1e-9);
    }

    void a_frame_without_time_or_shape_changes_nothing() {
        FaceTracks tracks;
        tracks.see(frame_of(0.0, {face_at(0.3, 0.4)}));
        tracks.see(frame_of(0.1, {face_at(0.3, 0.4)}));
        tracks.see(frame_of(no_number, {}));
        AimFrame flat = frame_of(0.9, {});
        flat.aspect = 0.0;
        tracks.see(flat);
        flat.aspect = no_number;
        tracks.see(flat);
        QCOMPARE(tracks.faces().size(), std::size_t{1});
        tracks.see(frame_of(0.1, {face_at(0.3, 0.4)})); // two frames of one time
        QCOMPARE(tracks.faces().size(), std::size_t{1});
        QVERIFY(is_finite(tracks.faces()[0].speed));
    }
};

} // namespace face_tracks_test

TP_TEST(face_tracks_test, FaceTracksTest, nothing)
#include "face_tracks_test.moc"
