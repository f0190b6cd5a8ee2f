// SPDX-License-Identifier: Apache-2.0
#include "core/servo/servo_loop.hpp"
#include "core/study/exploring_finger.hpp"
#include "device/simulated/simulated_device.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

namespace exploring_finger_test {

using namespace tp;
using namespace tp::testing;

namespace {

/// Explores the scene in simulated time and returns the finger's way, a point every 10 ms.
std::vector<Vec2> explore(const FlatScene& flat, double longest, bool* whole = nullptr) {
    Scene scene{200.0, 200.0, {}};
    for (std::size_t i = 0; i < flat.lines.size(); ++i)
        scene.contours.push_back(contour_through(flat.names[i], flat.lines[i].points, flat.lines[i].closed));
    VirtualClock clock;
    SimulatedDevice device(200.0, 200.0);
    const Capabilities can = *device.open();
    ServoLoop loop(device, can, clock, ServoSettings{});
    ExploringFinger hand(scene.surface());
    device.place_finger(hand.start());
    auto made = make_haptic_scene(scene);
    loop.render(std::move(made).value());
    loop.engage();
    std::vector<Vec2> way;
    for (int i = 0; clock.now() < longest && !hand.finished(); ++i) {
        clock.sleep_until(clock.now() + 0.001);
        loop.tick();
        const ServoSnapshot view = loop.snapshot();
        device.move_pointer(hand.step(view.finger(), view.force(), 0.001));
        if (i % 10 == 0)
            way.push_back(view.finger());
    }
    if (whole)
        *whole = hand.finished();
    return way;
}

/// Share of the line that the way passed within `reach` mm.
double covered(const Polyline& line, const std::vector<Vec2>& way, double reach) {
    const Polyline probes = resampled(line, 200);
    int seen = 0;
    for (const Vec2 p : probes.points)
        for (const Vec2 q : way)
            if (length(p - q) < reach) {
                ++seen;
                break;
            }
    return seen / 200.0;
}

} // namespace

class ExploringFingerTest : public QObject {
    Q_OBJECT
private slots:
    void follows_a_circle_round() {
        FlatScene scene;
        scene.names = {"circle"};
        scene.lines = {ellipse({10, -10}, 40, 40, 200)};
        bool whole = false;
        const std::vector<Vec2> way = explore(scene, 300.0, &whole);
        QVERIFY(whole);
        const double share = covered(scene.lines[0], way, 2.0);
        qInfo("%.0f %% of the circle was passed within 2 mm", 100.0 * share);
        QVERIFY(share > 0.9);
    }

    void finds_every_feature_of_a_face() {
        const FlatScene face = face_scene();
        const std::vector<Vec2> way = explore(face, 600.0);
        for (std::size_t i = 0; i < face.lines.size(); ++i) {
            const double share = covered(face.lines[i], way, 3.0);
            qInfo("%s: %.0f %% passed within 3 mm", face.names[i].c_str(), 100.0 * share);
            QVERIFY(share > 0.6);
        }
    }

    void searches_an_empty_surface_and_comes_to_an_end() {
        FlatScene scene;
        scene.names = {"far away"};
        scene.lines = {{{{500, 500}, {510, 500}}, false}};
        bool whole = false;
        const std::vector<Vec2> way = explore(scene, 300.0, &whole);
        QVERIFY(whole);
        const Rect box = bounds_of(way);
        QVERIFY(box.width() > 185.0 && box.height() > 175.0);
    }
};

} // namespace exploring_finger_test

TP_TEST(exploring_finger_test, ExploringFingerTest, nothing)
#include "exploring_finger_test.moc"
