// SPDX-License-Identifier: Apache-2.0
// Which face of a frame is which of the frame before.
#include "core/aiming/face_tracks.hpp"
#include "frames.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>

namespace face_matching_test {

using namespace tp;
using namespace tp::testing;

class FaceMatchingTest : public QObject {
    Q_OBJECT
private slots:
    void faces_that_swap_their_order_stay_who_they_are() {
        FaceTracks tracks;
        tracks.see(frame_of(0.0, {face_at(0.3, 0.4, 0.3), face_at(0.7, 0.4, 0.28)}));
        tracks.see(frame_of(0.1, {face_at(0.7, 0.4, 0.28), face_at(0.3, 0.4, 0.3)}));
        QCOMPARE(tracks.faces().size(), std::size_t{2});
        const std::uint32_t left = tracks.faces()[0].id;
        for (int i = 2; i < 20; ++i) {
            const AimFace one = face_at(0.3 + 0.002 * i, 0.4, 0.3);
            const AimFace other = face_at(0.7, 0.4, 0.28);
            tracks.see(frame_of(0.1 * i, i % 2 == 0 ? std::vector{one, other} : std::vector{other, one}));
            QCOMPARE(tracks.faces().size(), std::size_t{2});
            QCOMPARE(tracks.faces()[0].id, left);
            QVERIFY(tracks.faces()[0].box.centre().x < 0.5);
        }
    }

    void a_face_four_times_as_large_at_one_blow_is_another_one() {
        FaceTracks tracks;
        for (int i = 0; i < 3; ++i)
            tracks.see(frame_of(0.1 * i, {face_at(0.5, 0.5, 0.15)}));
        const auto first = tracks.faces().at(0).id;
        for (int i = 3; i < 5; ++i)
            tracks.see(frame_of(0.1 * i, {face_at(0.5, 0.5, 0.6)}));
        QVERIFY(std::ranges::any_of(tracks.faces(), [&](const TrackedFace& face) {
            return face.id != first && face.box.height() > 0.5;
        }));
    }

    void two_side_by_side_are_each_the_nearest() {
        FaceTracks tracks;
        tracks.see(frame_of(0.0, {face_at(0.40, 0.4, 0.28), face_at(0.47, 0.4, 0.27)}));
        tracks.see(frame_of(0.1, {face_at(0.40, 0.4, 0.28), face_at(0.47, 0.4, 0.27)}));
        const std::uint32_t left = tracks.faces()[0].id;
        tracks.see(frame_of(0.2, {face_at(0.43, 0.4, 0.28), face_at(0.50, 0.4, 0.27)}));
        QCOMPARE(tracks.faces().size(), std::size_t{2});
        for (const TrackedFace& face : tracks.faces())
            QCOMPARE(face.box.centre().x < 0.455, face.id == left);
    }

    void a_name_follows_a_face_that_jumps() {
        FaceTracks tracks;
        AimFace anna = face_at(0.2, 0.4);
        anna.name = "Anna";
        tracks.see(frame_of(0.0, {anna}));
        tracks.see(frame_of(0.1, {anna}));
        const std::uint32_t id = tracks.faces()[0].id;
        AimFace there = face_at(0.8, 0.4);
        there.name = "Anna";
        tracks.see(frame_of(0.2, {there}));
        QCOMPARE(tracks.faces().size(), std::size_t{1});
        QCOMPARE(tracks.faces()[0].id, id);
        tracks.see(frame_of(0.3, {face_at(0.8, 0.4)}));
        QCOMPARE(tracks.faces()[0].name, std::string("Anna"));
    }

    /// Of a track with a name the same name elsewhere is as like as a quarter of a face's size beside it.
    void a_name_that_jumps_yields_to_a_face_that_is_nearer_than_a_quarter() {
        for (const bool nearer : {false, true}) {
            FaceTracks tracks;
            AimFace anna = face_at(0.2, 0.4);
            anna.name = "Anna";
            for (int i = 0; i < 3; ++i)
                tracks.see(frame_of(0.1 * i, {anna, face_at(0.6, 0.4)}));
            const auto annas = std::ranges::find(tracks.faces(), "Anna", &TrackedFace::name);
            QVERIFY(annas != tracks.faces().end());
            const std::uint32_t id = annas->id;
            AimFace there = face_at(0.6 + (nearer ? 0.2 : 0.3) * size_of(anna.box), 0.4);
            there.name = "Anna";
            tracks.see(frame_of(0.3, {there}));
            const auto now = std::ranges::find(tracks.faces(), 0.3, &TrackedFace::seen_s);
            QVERIFY(now != tracks.faces().end());
            QCOMPARE(now->id == id, !nearer);
        }
    }

    void an_unseen_face_is_thought_to_go_on_for_a_third_of_a_second() {
        for (const double beside : {-0.9, 0.9}) {
            FaceTracks tracks;
            int frame = 0;
            for (; frame < 12; ++frame)
                tracks.see(
                    frame_of(0.05 * frame, {face_at(0.1 + 0.02 * frame, 0.4, 0.1), face_at(0.5, 0.8, 0.3)}));
            const TrackedFace runner = tracks.faces().back();
            const double expected = runner.box.centre().x + 0.3 * runner.speed.x;
            const AimFace again = face_at(expected + beside * size_of(runner.box), 0.4, 0.1);
            tracks.see(frame_of(runner.seen_s + 0.45, {again, face_at(0.5, 0.8, 0.3)}));
            QCOMPARE(tracks.faces().size(), std::size_t{2});
            QCOMPARE(tracks.faces().back().id, runner.id);
            QCOMPARE(tracks.faces().back().seen_s, runner.seen_s + 0.45);
        }
    }

    void a_swung_face_is_less_than_twice_as_large_data() {
        QTest::addColumn<double>("height");
        QTest::addColumn<QString>("name"); // of Anna, who may not be known there
        QTest::addColumn<bool>("same");
        QTest::newRow("larger") << 0.175 << "" << true;
        QTest::newRow("much larger") << 0.185 << "" << false;
        QTest::newRow("smaller") << 0.1 / 1.75 << "" << true;
        QTest::newRow("much smaller") << 0.1 / 1.85 << "" << false;
        QTest::newRow("somebody else") << 0.1 << "Ben" << false;
    }
    void a_swung_face_is_less_than_twice_as_large() {
        QFETCH(double, height);
        QFETCH(QString, name);
        QFETCH(bool, same);
        for (const bool known : {true, false}) {
            FaceTracks tracks;
            AimFace anna = face_at(0.1, 0.4, 0.1), there = face_at(0.8, 0.4, height);
            anna.name = known ? "Anna" : "";
            there.name = name.toStdString();
            for (int i = 0; i < 3; ++i)
                tracks.see(frame_of(0.1 * i, {anna}));
            const std::uint32_t id = tracks.faces()[0].id;
            tracks.see(frame_of(0.3, {there}));
            QCOMPARE(tracks.faces()[0].id, id);
            QCOMPARE(tracks.faces()[0].seen_s > 0.25, same || (!known && !name.isEmpty()));
        }
    }

    void a_camera_that_is_swung_takes_its_only_face_along() {
        FaceTracks tracks;
        tracks.see(frame_of(0.0, {face_at(0.1, 0.4, 0.1)}));
        tracks.see(frame_of(0.1, {face_at(0.1, 0.4, 0.1)}));
        const std::uint32_t id = tracks.faces()[0].id;
        tracks.see(frame_of(0.2, {face_at(0.8, 0.4, 0.1)}));
        QCOMPARE(tracks.faces().size(), std::size_t{1});
        QCOMPARE(tracks.faces()[0].id, id);
        tracks.see(frame_of(0.3, {face_at(0.1, 0.4, 0.4)})); // another one: far too large
        tracks.see(frame_of(0.4, {face_at(0.1, 0.4, 0.4)}));
        QCOMPARE(tracks.faces().size(), std::size_t{2});
    }

    /// A face is the one before where it has moved by less than its own size, and grown by less than 1.8 times.
    void a_face_is_another_where_it_leaps_or_grows_data() {
        QTest::addColumn<double>("leap"); // its own sizes
        QTest::addColumn<double>("growth");
        QTest::addColumn<bool>("same");
        QTest::newRow("leap") << 0.95 << 1.0 << true;
        QTest::newRow("far") << 1.05 << 1.0 << false;
        QTest::newRow("growth") << 0.0 << 1.75 << true;
        QTest::newRow("large") << 0.0 << 1.85 << false;
        QTest::newRow("shrinking") << 0.0 << 1.0 / 1.75 << true;
        QTest::newRow("small") << 0.0 << 1.0 / 1.85 << false;
    }
    void a_face_is_another_where_it_leaps_or_grows() {
        QFETCH(double, leap);
        QFETCH(double, growth);
        QFETCH(bool, same);
        FaceTracks tracks;
        const AimFace beside = face_at(0.9, 0.9, 0.05);
        for (int i = 0; i < 3; ++i)
            tracks.see(frame_of(0.1 * i, {face_at(0.2, 0.4, 0.2), beside}));
        const std::uint32_t id = tracks.faces()[0].id;
        const double size = size_of(face_at(0.2, 0.4, 0.2 * std::max(1.0, growth)).box);
        tracks.see(frame_of(0.3, {face_at(0.2 + leap * size, 0.4, 0.2 * growth), beside}));
        const auto before = std::ranges::find(tracks.faces(), id, &TrackedFace::id);
        QVERIFY(before != tracks.faces().end());
        QCOMPARE(before->seen_s > 0.25, same);
    }
};

} // namespace face_matching_test

TP_TEST(face_matching_test, FaceMatchingTest, nothing)
#include "face_matching_test.moc"
