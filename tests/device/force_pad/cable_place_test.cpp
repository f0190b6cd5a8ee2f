// SPDX-License-Identifier: Apache-2.0
// Where four lengths say that the knob is.
#include "device/force_pad/firmware/cables.hpp"
#include "kinematics_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <utility>

namespace cable_place_test {

using namespace tp::pad;

class CablePlaceTest : public QObject {
    Q_OBJECT
private slots:
    void four_lengths_give_the_place_from_anywhere() {
        const auto frame = frame_of<double>();
        std::mt19937 random(2);
        for (int i = 0; i < 5000; ++i) {
            const Vec<double> place = random_place(random, 149.0, 109.0);
            const Vec<double> start = random_place(random, 149.0, 109.0);
            const auto found = locate(frame, lengths_at(frame, place).mm, start);
            QVERIFY(found.converged);
            QVERIFY(apart(found.place, place) < 1e-8);
            QVERIFY(found.residual < 1e-8);
        }
    }

    /// Where the search begins on an exit, that cable has no direction, and three are enough.
    void four_lengths_give_the_place_from_an_exit() {
        const auto frame = frame_of<double>();
        for (const Vec<double> start : frame.exits) {
            const auto found = locate(frame, lengths_at(frame, {20.0, -10.0}).mm, start);
            QVERIFY(found.converged);
            QVERIFY(apart(found.place, {20.0, -10.0}) < 1e-8);
        }
    }

    void hard_places_of_the_cable_frame_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("corner of the workspace") << 100.0 << 75.0;
        QTest::newRow("on an exit") << 150.0 << 110.0;
        QTest::newRow("on the frame between two exits") << 0.0 << 110.0;
        QTest::newRow("centre, on both diagonals") << 0.0 << 0.0;
        QTest::newRow("a hair from an exit") << -149.9999 << -110.0;
        QTest::newRow("outside the frame") << 170.0 << 0.0;
        QTest::newRow("seven steps away") << 700.0 << 100.0;
    }
    void hard_places_of_the_cable_frame() {
        QFETCH(double, x);
        QFETCH(double, y);
        const auto frame = frame_of<double>();
        const auto found = locate(frame, lengths_at(frame, {x, y}).mm, {3.0, -2.0});
        QVERIFY(found.converged);
        QVERIFY(apart(found.place, {x, y}) < 1e-6);
        for (const Vec<double> wanted : {Vec<double>{0, 0}, Vec<double>{1, 0}, Vec<double>{-2, 9}}) {
            const auto tensions = distribute(frame, Vec<double>{x, y}, wanted);
            for (const double t : tensions.newtons)
                QVERIFY(t >= frame.least_tension - 1e-12 && t <= frame.greatest_tension + 1e-12);
            if (tensions.feasible)
                QVERIFY(apart(tensions.force, wanted) < 1e-9);
        }
    }

    /// A millisecond is all that it has, and a wild reading does not throw the knob out of the room.
    void a_search_takes_twelve_steps_of_a_hundred_millimetres_at_most() {
        const auto frame = frame_of<double>();
        const auto found = locate(frame, lengths_at(frame, {5000.0, 0.0}).mm, {0.0, 0.0});
        QVERIFY(!found.converged);
        QVERIFY(apart(found.place, {1200.0, 0.0}) < 1e-6);
        QVERIFY(found.residual > 3000.0);
    }

    /// What four encoders are for: one that slipped, or a cable that went slack, cannot hide.
    void a_slipped_encoder_shows_in_the_residual() {
        const auto frame = frame_of<double>();
        std::mt19937 random(3);
        double least = std::numeric_limits<double>::infinity();
        double farthest = 0.0;
        for (int i = 0; i < 4000; ++i) {
            const Vec<double> place = random_place(random, 100.0, 75.0);
            for (int cable = 0; cable < cable_count; ++cable)
                for (const double slip : {-2.0, 2.0}) {
                    Lengths lengths = lengths_at(frame, place);
                    lengths.mm[cable] += slip;
                    const auto found = locate(frame, lengths.mm, place);
                    QVERIFY(found.converged);
                    least = std::min(least, found.residual / std::abs(slip));
                    farthest = std::max(farthest, apart(found.place, place) / std::abs(slip));
                }
        }
        qInfo("a slip of 1 mm: residual at least %.3f mm, place at most %.3f mm off", least, farthest);
        QVERIFY(least > 0.2);
        // So a slip is noticed before it moves the finger by more than this:
        QVERIFY(farthest * static_cast<double>(cable_pad().greatest_residual) / least < 2.5);
    }

    void the_residual_is_the_root_of_the_mean_square() {
        const auto frame = frame_of<double>();
        for (const double off : {1.0, -0.25}) {
            Lengths lengths = lengths_at(frame, {0.0, 0.0});
            for (double& length : lengths.mm)
                length += off;
            const auto found = locate(frame, lengths.mm, Vec<double>{0.0, 0.0});
            QVERIFY(found.converged);
            QVERIFY(apart(found.place, {0.0, 0.0}) < 1e-12);
            QVERIFY(std::abs(found.residual - std::abs(off)) < 1e-12);
        }
    }

    void lengths_that_fit_no_place_end_and_say_so() {
        const auto frame = frame_of<double>();
        for (const double length : {0.0, -50.0, 1e6, std::numeric_limits<double>::quiet_NaN()}) {
            const double lengths[cable_count] = {length, length, 100.0, 100.0};
            const auto found = locate(frame, lengths, Vec<double>{0, 0});
            QVERIFY(!(found.residual < 10.0));
        }
    }

    /// Along a line the place can be told, across it hardly: such a place is not believed.
    void cables_that_lie_nearly_in_one_line_do_not_tell_the_place() {
        for (const auto& [tilt, told] : {std::pair{0.0071, true}, {0.0048, false}, {0.0, false}}) {
            const CableFrame<double> frame = nearly_in_one_line(tilt);
            const auto found = locate(frame, lengths_at(frame, {0.0, 0.0}).mm, Vec<double>{0.0, 0.0});
            QCOMPARE(found.converged, told);
            QVERIFY(apart(found.place, {0.0, 0.0}) < 1e-9);
        }
    }

    /// The microcontroller reckons in float: what that costs against double.
    void float_is_accurate_enough() {
        const auto fine = frame_of<double>();
        const auto coarse = frame_of<float>();
        std::mt19937 random(8);
        double place_um = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const Vec<double> place = random_place(random, 100.0, 75.0);
            const Lengths lengths = lengths_at(fine, place);
            float rounded[cable_count];
            std::transform(std::begin(lengths.mm), std::end(lengths.mm), rounded,
                           [](double length) { return static_cast<float>(length); });
            const auto found = locate(coarse, rounded, {0, 0});
            QVERIFY(found.converged);
            place_um = std::max(place_um, 1e3 * apart({double(found.place.x), double(found.place.y)}, place));
        }
        qInfo("float against double: %.3f um", place_um);
        QVERIFY(place_um < 0.2);
    }
};

} // namespace cable_place_test

TP_TEST(cable_place_test, CablePlaceTest, nothing)
#include "cable_place_test.moc"
