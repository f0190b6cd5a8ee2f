// SPDX-License-Identifier: Apache-2.0
// What a servo may ask of the index: memory within bounds, questions that allocate nothing.
#include "brute_force.hpp"
#include "core/guidance/contour_index.hpp"
#include "scenes.hpp"

#include <QTest>

#include <atomic>
#include <cstdlib>
#include <new>

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
        // A face has its cells; what is too wide for cells has none.
        QVERIFY(ContourIndex(face_scene(200)).bytes() >
                ContourIndex(enlarged(face_scene(200), 1e7)).bytes() + 4096 * sizeof(std::uint32_t));
        const FlatScene map = many_curves(1'000'000, 100.0);
        const long before = allocations.load();
        const ContourIndex index(map);
        QVERIFY(allocations.load() > before);
        qInfo("a million segments: %.1f MiB", double(index.bytes()) / (1 << 20));
        QVERIFY(index.bytes() < (std::size_t(100) << 20));
        QVERIFY(index.bytes() > std::size_t(1'000'000) * (sizeof(IndexedSegment) + 2 * sizeof(int)));
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
};

QTEST_APPLESS_MAIN(ContourIndexLimitsTest)
#include "contour_index_limits_test.moc"
