// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/aim.hpp"
#include "frames.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace aim_test {

using namespace tp;
using namespace tp::testing;

namespace {

std::vector<TrackedFace> tracked(const std::vector<AimFace>& faces) {
    FaceTracks tracks;
    tracks.see(frame_of(0.0, faces));
    tracks.see(frame_of(0.1, faces));
    return tracks.faces();
}

constexpr double wide = 16.0 / 9.0;

} // namespace

class AimTest : public QObject {
    Q_OBJECT
private slots:
    void nobody_is_no_framing() {
        for (const Aim aim : {Aim::middle, Aim::thirds, Aim::head_and_shoulders, Aim::everybody})
            QVERIFY(!Framer(aim).frame({}, wide));
    }

    void each_aim_has_its_place() {
        const auto place = [](Aim aim, double x) {
            const auto framing = Framer(aim).frame(tracked({face_at(x, 0.5)}), wide);
            return Vec2(x, 0.5) - framing->off;
        };
        QVERIFY(length(place(Aim::middle, 0.2) - Vec2(0.5, 0.45)) < 1e-9);
        QVERIFY(length(place(Aim::head_and_shoulders, 0.2) - Vec2(0.5, 0.4)) < 1e-9);
        QVERIFY(length(place(Aim::everybody, 0.2) - Vec2(0.5, 0.45)) < 1e-9);
        QVERIFY(length(place(Aim::thirds, 0.2) - Vec2(1.0 / 3.0, 0.4)) < 1e-9);
        QVERIFY(length(place(Aim::thirds, 0.8) - Vec2(2.0 / 3.0, 0.4)) < 1e-9);
    }

    void a_group_has_more_room_than_one_face() {
        const auto room = [](Aim aim) {
            return Framer(aim).frame(tracked({face_at(0.2, 0.5)}), wide)->tolerance;
        };
        QVERIFY(length(room(Aim::middle) - Vec2(0.1, 0.12)) < 1e-9);
        QVERIFY(length(room(Aim::thirds) - Vec2(0.08, 0.12)) < 1e-9);
        QVERIFY(length(room(Aim::head_and_shoulders) - Vec2(0.1, 0.1)) < 1e-9);
        QVERIFY(length(room(Aim::everybody) - Vec2(0.15, 0.15)) < 1e-9);
    }

    void a_size_is_one_at_its_limits_and_grows_back_into_them() {
        for (const auto& [aim, smallest, largest] :
             {std::tuple{Aim::middle, 0.15, 0.5}, std::tuple{Aim::thirds, 0.15, 0.45},
              std::tuple{Aim::head_and_shoulders, 0.28, 0.5}})
            for (const double size : {smallest, largest}) {
                const auto at = Framer(aim).frame(tracked({face_at(0.5, 0.45, size)}), wide);
                QVERIFY(std::abs(at->size_off - (size == largest ? 1.0 : -1.0)) < 1e-9);
                const auto mended = Framer(aim).frame(tracked({face_at(0.5, 0.45, size * at->grow)}), wide);
                QVERIFY(std::abs(std::abs(mended->size_off) - 0.5) < 1e-9); // halfway in
            }
    }

    void a_size_is_over_the_shorter_side() {
        AimFace face;
        face.box = {{0.4, 0.4}, {0.6, 0.6}};
        const auto lying = Framer(Aim::middle).frame(tracked({face}), 2.0);
        const auto standing = Framer(Aim::middle).frame(tracked({face}), 0.5);
        QVERIFY(std::abs(lying->face - 0.2) < 1e-9);
        QVERIFY(std::abs(standing->face - 0.4) < 1e-9);
    }

    void an_edge_that_cuts_is_named_by_sign_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<int>("across");
        QTest::addColumn<int>("height");
        QTest::newRow("left") << 0.02 << 0.5 << -1 << 0;
        QTest::newRow("right") << 0.98 << 0.5 << 1 << 0;
        QTest::newRow("top") << 0.5 << 0.05 << 0 << -1;
        QTest::newRow("bottom") << 0.5 << 0.95 << 0 << 1;
        QTest::newRow("none") << 0.5 << 0.5 << 0 << 0;
    }
    void an_edge_that_cuts_is_named_by_sign() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(int, across);
        QFETCH(int, height);
        const auto framing = Framer(Aim::middle).frame(tracked({face_at(x, y)}), wide);
        const auto sign = [](double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; };
        QCOMPARE(sign(framing->cut.x), across);
        QCOMPARE(sign(framing->cut.y), height);
        const double half_width = 0.5 * 0.75 * 0.27 * 9.0 / 16.0;
        QVERIFY(std::abs(std::abs(framing->cut.x) - (across != 0 ? half_width : 0.0)) < 1e-9);
        QVERIFY(std::abs(std::abs(framing->cut.y) - (height != 0 ? 0.105 : 0.0)) < 1e-9);
        QVERIFY(!framing->cut_both);
    }

    void a_face_over_both_edges_is_cut_by_both() {
        const auto framing = Framer(Aim::middle).frame(tracked({face_at(0.5, 0.5, 1.2)}), wide);
        QVERIFY(framing->cut_both);
        QVERIFY(framing->size_off > 1.0);
    }

    void two_faces_of_one_size_do_not_take_turns() {
        Framer framer(Aim::middle);
        const auto subject = [&framer](double left, double right) {
            FaceTracks tracks;
            tracks.see(frame_of(0.0, {face_at(0.3, 0.5, left), face_at(0.7, 0.5, right)}));
            tracks.see(frame_of(0.1, {face_at(0.3, 0.5, left), face_at(0.7, 0.5, right)}));
            std::vector<TrackedFace> faces = tracks.faces();
            for (TrackedFace& face : faces)
                face.id = face.box.centre().x < 0.5 ? 1 : 2;
            return framer.frame(faces, wide)->subjects.front();
        };
        QCOMPARE(subject(0.30, 0.29), 1U);
        QCOMPARE(subject(0.29, 0.30), 1U);
        QCOMPARE(subject(0.22, 0.30), 1U);
        QCOMPARE(subject(0.20, 0.30), 2U);
        QCOMPARE(subject(0.30, 0.29), 2U);
        framer = Framer(Aim::middle);
        QCOMPARE(subject(0.29, 0.30), 2U); // the first one is whoever is largest
    }

    void a_face_in_the_middle_does_not_change_its_third() {
        Framer framer(Aim::thirds);
        const auto place = [&framer](double x) {
            return framer.frame(tracked({face_at(x, 0.4)}), wide)->off.x < x - 0.5 ? 2 : 1;
        };
        QCOMPARE(place(0.49), 1);
        QCOMPARE(place(0.55), 1);
        QCOMPARE(place(0.59), 2);
        QCOMPARE(place(0.45), 2);
        QCOMPARE(place(0.41), 1);
        framer.aim_at(Aim::thirds); // chosen anew
        QCOMPARE(place(0.55), 2);
        framer = Framer(Aim::thirds);
        QCOMPARE(place(0.5), 1);
        framer = Framer(Aim::thirds);
        QCOMPARE(place(0.51), 2);
    }

    void another_subject_has_the_third_that_is_nearer_to_it() {
        Framer framer(Aim::thirds);
        std::vector<TrackedFace> faces = tracked({face_at(0.3, 0.4)});
        QVERIFY(std::abs(framer.frame(faces, wide)->off.x - (0.3 - 1.0 / 3.0)) < 1e-9);
        faces = tracked({face_at(0.55, 0.4)});
        ++faces[0].id;
        QVERIFY(std::abs(framer.frame(faces, wide)->off.x - (0.55 - 2.0 / 3.0)) < 1e-9);
    }

    void everybody_is_all_of_them() {
        const auto framing =
            Framer(Aim::everybody)
                .frame(tracked({face_at(0.2, 0.4), face_at(0.5, 0.45), face_at(0.75, 0.5)}), wide);
        QCOMPARE(framing->subjects.size(), std::size_t{3});
        QVERIFY(framing->box.min.x < 0.2 && framing->box.max.x > 0.75);
        QVERIFY(std::abs(framing->size_off) < 1.0);
        const auto crowd =
            Framer(Aim::everybody).frame(tracked({face_at(0.01, 0.4), face_at(0.99, 0.4)}), wide);
        QVERIFY(crowd->cut_both);
        QVERIFY(crowd->size_off > 1.0);
        QVERIFY(crowd->grow < 1.0);
        const auto far =
            Framer(Aim::everybody).frame(tracked({face_at(0.48, 0.4, 0.05), face_at(0.53, 0.4, 0.05)}), wide);
        QVERIFY(far->size_off < -1.0);
        QVERIFY(far->grow > 1.5);
    }

    /// Two at the ends of `width`; how far their size is off, and what would mend it.
    void a_group_is_too_large_or_too_small_by_so_much_data() {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::addColumn<double>("other");
        QTest::addColumn<double>("size_off");
        QTest::addColumn<double>("grow");
        QTest::newRow("wide") << 0.96 << 0.2 << 0.2 << 1.3 << 0.9 * 0.9 / 0.96;
        QTest::newRow("near") << 0.7 << 0.6 << 0.6 << 1.5 << 0.9 * 0.5 / 0.6;
        QTest::newRow("well") << 0.8 << 0.2 << 0.2 << 0.5 << 0.9 * 0.9 / 0.8;
        QTest::newRow("far") << 0.3 << 0.05 << 0.05 << -1.6 << 1.2 * 0.08 / 0.05;
        QTest::newRow("far and wide") << 0.5 << 0.05 << 0.05 << -1.25 << 0.9 / 0.5;
        QTest::newRow("not too far") << 0.5 << 0.1 << 0.1 << -0.8 << 1.2 * 0.08 / 0.1;
        QTest::newRow("a child before its mother") << 0.3 << 0.2 << 0.05 << -1.6 << 1.2 * 0.08 / 0.05;
    }
    void a_group_is_too_large_or_too_small_by_so_much() {
        QFETCH(double, width);
        QFETCH(double, height);
        QFETCH(double, other);
        QFETCH(double, size_off);
        QFETCH(double, grow);
        const auto half = [](double of) { return 0.5 * 0.75 * of * 9.0 / 16.0; };
        const auto framing = Framer(Aim::everybody)
                                 .frame(tracked({face_at(0.5 - 0.5 * width + half(height), 0.45, height),
                                                 face_at(0.5 + 0.5 * width - half(other), 0.45, other)}),
                                        wide);
        QVERIFY2(std::abs(framing->size_off - size_off) < 1e-9,
                 qPrintable(QString::number(framing->size_off)));
        QVERIFY2(std::abs(framing->grow - grow) < 1e-9, qPrintable(QString::number(framing->grow)));
        QVERIFY(std::abs(framing->face - height) < 1e-9);
    }

    void the_tilt_of_everybody_is_the_mean_of_those_with_eyes() {
        AimFace without = face_at(0.8, 0.4);
        without.eyes.reset();
        const auto tilt = [](const std::vector<AimFace>& faces) {
            return Framer(Aim::everybody).frame(tracked(faces), wide)->tilt_deg;
        };
        QVERIFY(std::abs(*tilt({face_at(0.2, 0.4, 0.27, 10.0), face_at(0.5, 0.4, 0.27, 20.0), without}) -
                         15.0) < 1e-6);
        QVERIFY(!tilt({without}));
    }

    void small_faces_far_apart_are_not_brought_closer() {
        const auto framing =
            Framer(Aim::everybody).frame(tracked({face_at(0.1, 0.4, 0.06), face_at(0.9, 0.4, 0.06)}), wide);
        QVERIFY(std::abs(framing->size_off) < 1.0);
    }

    void who_is_missing_is_counted_for_everybody_only() {
        for (const auto& [aim, missing] : {std::pair{Aim::everybody, 2}, std::pair{Aim::middle, 0}}) {
            Framer framer(aim);
            framer.expect(3);
            QCOMPARE(framer.frame(tracked({face_at(0.5, 0.5)}), wide)->missing, missing);
        }
        Framer framer(Aim::everybody);
        framer.expect(1);
        QCOMPARE(framer.frame(tracked({face_at(0.3, 0.5), face_at(0.7, 0.5)}), wide)->missing, 0);
    }
};

} // namespace aim_test

TP_TEST(aim_test, AimTest, nothing)
#include "aim_test.moc"
