// SPDX-License-Identifier: Apache-2.0
// Several threads may ask one index.
#include "core/guidance/contour_index.hpp"
#include "scenes.hpp"
#include "test_program.hpp"

#include <QTest>

#include <thread>

namespace contour_index_threads_test {

using namespace tp;
using namespace tp::testing;

class ContourIndexThreadsTest : public QObject {
    Q_OBJECT
private slots:
    void two_threads_hear_the_same() {
        const ContourIndex index(many_curves(20'000, 100.0));
        std::mt19937 random(18);
        std::vector<Vec2> points;
        for (int k = 0; k < 100'000; ++k)
            points.push_back(random_point(random, 110.0));
        std::vector<Nearest> answers[2];
        const auto ask = [&](std::vector<Nearest>& into) {
            for (const Vec2 p : points)
                into.push_back(index.nearest(p));
        };
        std::thread other([&] { ask(answers[1]); });
        ask(answers[0]);
        other.join();
        for (std::size_t k = 0; k < points.size(); ++k)
            QVERIFY(answers[0][k].distance == answers[1][k].distance &&
                    answers[0][k].point == answers[1][k].point &&
                    answers[0][k].contour == answers[1][k].contour);
    }
};

} // namespace contour_index_threads_test

TP_TEST(contour_index_threads_test, ContourIndexThreadsTest, nothing)
#include "contour_index_threads_test.moc"
