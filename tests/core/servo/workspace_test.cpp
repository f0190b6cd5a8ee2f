// SPDX-License-Identifier: Apache-2.0
#include "core/servo/safety_chain.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

namespace workspace_test {

using namespace tp;

namespace {

bool believed(const std::vector<Vec2>& workspace, Vec2 position) {
    Capabilities can;
    can.workspace = workspace;
    can.max_force = 1.0;
    SafetyLimits limits;
    limits.workspace_margin = 0.0;
    SafetyChain chain(limits, can, 0.001);
    SafetyInput input;
    input.fresh = true;
    input.position = position;
    chain.engage(0.0);
    chain.pass(input);
    return chain.fault() == Fault::none;
}

} // namespace

class WorkspaceTest : public QObject {
    Q_OBJECT
private slots:
    /// Wherever the device's frame has its origin, and whichever way the corners go round.
    void a_place_is_inside_where_it_is_on_the_inner_side_of_every_edge() {
        std::mt19937 random(51);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        int inside = 0, outside = 0;
        for (int round = 0; round < 60; ++round) {
            const int corners = 3 + round % 9;
            const Vec2 middle(200.0 * unit(random), 200.0 * unit(random));
            const double turn = std::numbers::pi * unit(random);
            const double way = round % 2 == 0 ? 1.0 : -1.0;
            std::vector<Vec2> polygon;
            for (int i = 0; i < corners; ++i) {
                const double angle = turn + way * 2.0 * std::numbers::pi * i / corners;
                polygon.push_back(middle + 80.0 * Vec2(std::cos(angle), std::sin(angle)));
            }
            for (int k = 0; k < 40; ++k) {
                const Vec2 place = middle + 100.0 * Vec2(unit(random), unit(random));
                double nearest = 1e9; // to the endless line of an edge, positive on the inner side
                for (std::size_t i = 0; i < polygon.size(); ++i) {
                    const Vec2 a = polygon[i];
                    const Vec2 b = polygon[(i + 1) % polygon.size()];
                    nearest = std::min(nearest, way * cross(b - a, place - a) / length(b - a));
                }
                if (std::abs(nearest) < 1e-6)
                    continue;
                (nearest > 0.0 ? inside : outside) += 1;
                QCOMPARE(believed(polygon, place), nearest > 0.0);
            }
        }
        QVERIFY(inside > 500 && outside > 500);
    }
};

} // namespace workspace_test

TP_TEST(workspace_test, WorkspaceTest, nothing)
#include "workspace_test.moc"
