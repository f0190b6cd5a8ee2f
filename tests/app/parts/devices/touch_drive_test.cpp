// SPDX-License-Identifier: Apache-2.0
// A thumb on a small pad, whose way is enlarged to the surface: what it does is felt, that it trembles is not.
#include "app/parts/devices/touch_drive.hpp"
#include "test_program.hpp"
#include "touch_output_double.hpp"

#include <QTest>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>

namespace touch_drive_test {

using namespace tp;
using tp::testing::TouchOutputDouble;

namespace {

const Vec2 surface{200.0, 150.0};

FlatScene upright_lines(std::initializer_list<double> all) {
    FlatScene scene;
    for (const double x : all) {
        scene.names.push_back("line");
        scene.lines.push_back({{{x, -70.0}, {x, 70.0}}, false});
    }
    return scene;
}

/// How many ticks a thumb feels on a pad of 40 mm that goes this way, mm of the pad, for so long.
std::size_t ticks_of(const std::function<Vec2(double)>& thumb, double seconds,
                     FlatScene scene = upright_lines({0.0})) {
    auto made = std::make_unique<TouchOutputDouble>();
    TouchOutputDouble& output = *made;
    output.pad = [&thumb](double now) { return PadTouch{now, true, thumb(now), 0}; };
    VirtualClock clock;
    const TouchCapabilities can = output.capabilities();
    TouchDrive drive(std::move(made), can, surface, {}, &clock);
    drive.show(std::move(scene));
    drive.loop().engage();
    while (clock.now() < seconds) {
        clock.sleep_until(clock.now() + drive.loop().period());
        drive.loop().tick();
    }
    return output.tick_count;
}

} // namespace

class TouchDriveTest : public QObject {
    Q_OBJECT
private slots:
    void a_thumb_that_rests_on_a_line_and_trembles_feels_it_once_at_most() {
        for (const double hz : {8.0, 10.0, 12.0})
            for (const double width_mm : {0.1, 0.2, 0.3})
                for (const double beside_mm : {-0.1, 0.0, 0.07}) {
                    const auto thumb = [&](double now) {
                        return Vec2(beside_mm + 0.5 * width_mm * std::sin(2.0 * std::numbers::pi * hz * now),
                                    0.03 * std::sin(17.0 * now));
                    };
                    const std::size_t ticks = ticks_of(thumb, 5.0);
                    QVERIFY2(ticks <= 1,
                             qPrintable(QString("%1 at %2 Hz and %3 mm").arg(ticks).arg(hz).arg(width_mm)));
                }
    }

    void nor_between_two_lines_that_lie_close() {
        const auto thumb = [](double now) {
            return Vec2(0.15 * std::sin(2.0 * std::numbers::pi * 10.0 * now), 0.0);
        };
        QVERIFY(ticks_of(thumb, 5.0, upright_lines({-0.3, 0.3})) <= 2);
    }

    void a_trembling_thumb_that_drifts_over_a_line_feels_it_once() {
        const auto thumb = [](double now) {
            return Vec2(now - 2.0 + 0.15 * std::sin(2.0 * std::numbers::pi * 10.0 * now), 0.0);
        };
        QCOMPARE(ticks_of(thumb, 4.0), std::size_t(1));
    }

    void each_way_over_a_line_is_felt() {
        for (const double hz : {0.5, 1.0, 2.0}) { // 2 mm to either side
            const auto thumb = [hz](double now) {
                return Vec2(2.0 * std::cos(2.0 * std::numbers::pi * hz * now), 0.0);
            };
            QCOMPARE(ticks_of(thumb, 4.0), static_cast<std::size_t>(2.0 * hz * 4.0));
        }
    }
};

} // namespace touch_drive_test

TP_TEST(touch_drive_test, TouchDriveTest, nothing)
#include "touch_drive_test.moc"
