// SPDX-License-Identifier: Apache-2.0
// What a servo may ask of the index: memory within bounds, questions that allocate nothing, any number of
// threads.
#include "brute_force.hpp"
#include "core/guidance/contour_index.hpp"
#include "scenes.hpp"

#include <QTest>

#include <atomic>
#include <cstdlib>
#include <new>
#include <thread>

using namespace tp;
using namespace tp::testing;

namespace {

std::atomic<long> allocations{0};

FlatScene enlarged(FlatScene scene, double scale) {
    for (Polyline& line : scene.lines)
        for (Vec2& p : line.points)
            p *= scale;
    return scene;
}

/// `count` segments as small closed curves all over ±`extent` mm.
FlatScene many_curves(int count, double extent) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> radius(0.2, 1.0);
    FlatScene scene;
    const int curves = count / 200;
    const double typical = extent / std::sqrt(double(curves));
    for (int k = 0; k < curves; ++k) {
        scene.names.push_back("curve " + std::to_string(k));
        scene.lines.push_back(ellipse(random_point(random, 0.95 * extent), typical * radius(random),
                                      typical * radius(random), 200));
    }
    return scene;
}

} // namespace

void* operator new(std::size_t size) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    if (void* memory = std::malloc(size > 0 ? size : 1))
        return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    allocations.fetch_add(1, std::memory_order_relaxed);
    return std::malloc(size > 0 ? size : 1);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

class ContourIndexLimitsTest : public QObject {
    Q_OBJECT
private slots:
    void a_million_segments_in_a_square_millimetre() {
        const FlatScene scene = many_curves(1'000'000, 0.5);
        const ContourIndex index(scene);
        QVERIFY(index.bytes() < (std::size_t(100) << 20));
        std::mt19937 random(15);
        for (const Vec2 p :
             {Vec2(0, 0), Vec2(0.3, -0.2), Vec2(4, 3), Vec2(-200, 10), random_point(random, 0.5)})
            QVERIFY(std::abs(index.nearest(p).distance - true_distance(scene, p)) < 1e-9);
    }

    void memory_is_as_promised() {
        std::mt19937 random(16);
        QVERIFY(ContourIndex(face_scene(200)).bytes() < (std::size_t(1) << 20));
        const FlatScene map = many_curves(1'000'000, 100.0);
        const long before = allocations.load();
        const ContourIndex index(map);
        QVERIFY(allocations.load() > before);
        qInfo("a million segments: %.1f MiB", double(index.bytes()) / (1 << 20));
        QVERIFY(index.bytes() < (std::size_t(100) << 20));
        QCOMPARE(index.segment_count(), std::size_t(1'000'000));
        for (int k = 0; k < 8; ++k) {
            const Vec2 p = random_point(random, 110.0);
            QVERIFY(std::abs(index.nearest(p).distance - true_distance(map, p)) < 1e-9);
        }
    }

    void a_question_allocates_nothing() {
        std::mt19937 random(17);
        for (const double scale : {1.0, 1e7}) { // the second in extended precision
            const ContourIndex index(enlarged(face_scene(), scale));
            std::vector<Vec2> points;
            for (int k = 0; k < 100'000; ++k)
                points.push_back(random_point(random, 150.0 * scale));
            double sum = 0.0;
            const long before = allocations.load();
            for (const Vec2 p : points)
                sum += index.nearest(p).distance + double(index.nearest_within(p, 8.0).contour);
            const long after = allocations.load();
            QCOMPARE(after - before, 0L);
            QVERIFY(sum > 0.0);
        }
    }

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

QTEST_APPLESS_MAIN(ContourIndexLimitsTest)
#include "contour_index_limits_test.moc"
