// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/flatten.hpp"
#include "faces/extract/batch.hpp"
#include "places.hpp"

#include <QTest>

using namespace tp;

namespace {

const std::filesystem::path samples = tp::test::in_source("resources/samples");
const std::vector<std::filesystem::path> photos{
    samples / "anna_smiling.jpg", "missing.jpg", samples / "ben_and_clara.jpg", samples,
    samples / "anna_sad.jpg",     "missing.jpg", samples / "anna_smiling.jpg"};

std::vector<FaceExtractor> extractors(std::size_t count) {
    std::vector<FaceExtractor> made;
    while (made.size() < count)
        made.push_back(FaceExtractor::create().value());
    return made;
}

/// All points of a face's contours, one after the other.
std::vector<double> places(const Face& face) {
    std::vector<double> numbers;
    for (const Contour& contour : face.contours)
        for (const Vec2 p : flatten(contour, {0.02, 2.0}).points)
            numbers.insert(numbers.end(), {p.x, p.y});
    return numbers;
}

struct Taken {
    std::size_t index;
    Extraction found;
};

} // namespace

class BatchTest : public QObject {
    Q_OBJECT

private slots:
    void any_number_of_threads_gives_the_same_in_the_same_order() {
        std::vector<std::vector<Taken>> runs;
        for (const std::size_t threads : {std::size_t(1), std::size_t(3), std::size_t(9)}) {
            std::vector<Taken> taken;
            const std::atomic<bool> stop{false};
            const auto count = extract_batch(
                extractors(threads), photos,
                [&](std::size_t index, const Extraction& found) {
                    taken.push_back({index, found});
                    return true;
                },
                stop);
            QCOMPARE(*count, photos.size());
            QCOMPARE(taken.size(), photos.size());
            runs.push_back(std::move(taken));
        }
        for (const std::vector<Taken>& run : runs)
            for (std::size_t i = 0; i < photos.size(); ++i) {
                QCOMPARE(run[i].index, i);
                const Extraction &ours = run[i].found, &first = runs[0][i].found;
                QCOMPARE(ours.problem, first.problem);
                QCOMPARE(ours.faces.size(), first.faces.size());
                for (std::size_t f = 0; f < ours.faces.size(); ++f)
                    QCOMPARE(places(ours.faces[f]), places(first.faces[f]));
            }
        QCOMPARE(runs[0][2].found.faces.size(), std::size_t(2));
        QVERIFY(!runs[0][1].found.problem.empty());
    }

    void stops_when_told_and_hands_over_what_was_begun() {
        std::atomic<bool> stop{false};
        std::size_t next = 0;
        const auto count = extract_batch(
            extractors(2), photos,
            [&](std::size_t index, const Extraction&) {
                stop = true;
                return index == next++;
            },
            stop);
        QVERIFY(*count >= 1);
        QCOMPARE(*count, next);
        QCOMPARE(*extract_batch(
                     extractors(2), photos, [](std::size_t, const Extraction&) { return true; }, stop),
                 std::size_t(0));
    }

    void ends_when_a_result_is_refused() {
        const std::atomic<bool> stop{false};
        std::size_t asked = 0;
        const auto count = extract_batch(
            extractors(3), photos, [&](std::size_t, const Extraction&) { return ++asked < 2; }, stop);
        QCOMPARE(asked, std::size_t(2));
        QCOMPARE(*count, std::size_t(2));
    }

    void no_photographs_are_no_work() {
        const std::atomic<bool> stop{false};
        QCOMPARE(*extract_batch(
                     extractors(1), {}, [](std::size_t, const Extraction&) { return true; }, stop),
                 std::size_t(0));
    }
};

QTEST_GUILESS_MAIN(BatchTest)
#include "batch_test.moc"
