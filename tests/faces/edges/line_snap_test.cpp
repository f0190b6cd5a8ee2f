// SPDX-License-Identifier: Apache-2.0
#include "faces/edges/line_snap.hpp"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace tp;

namespace {

constexpr double step = 0.25;
constexpr std::size_t offsets = 41;

/// Evidence −weight·(d − centre)² at each point.
Evidence parabolas(const std::vector<double>& centres, double weight) {
    Evidence evidence{centres.size(), offsets, step, {}};
    for (double centre : centres)
        for (std::size_t k = 0; k < offsets; ++k)
            evidence.values.push_back(-weight * std::pow(evidence.offset(k) - centre, 2));
    return evidence;
}

double energy(const Evidence& evidence, const std::vector<std::size_t>& path, double stray, double bend) {
    double sum = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double d = evidence.offset(path[i]);
        sum += stray * d * d - evidence.at(i, path[i]);
        if (i > 0)
            sum += bend * std::pow(d - evidence.offset(path[i - 1]), 2);
    }
    return sum;
}

} // namespace

class LineSnapTest : public QObject {
    Q_OBJECT

private slots:
    void without_evidence_the_line_stays() {
        const auto d = snapped({20, offsets, step, std::vector<double>(20 * offsets, 3.0)}, 0.1, 1.0);
        QCOMPARE(d.size(), std::size_t{20});
        for (double v : d)
            QCOMPARE(v, 0.0);
        QCOMPARE(clarity({20, offsets, step, std::vector<double>(20 * offsets, 3.0)}, d), 0.0);
    }
    void clear_evidence_is_found_between_the_offsets() {
        const std::vector<double> centres(12, 1.37);
        for (double v : snapped(parabolas(centres, 50.0), 1e-6, 1.0))
            QVERIFY(std::abs(v - 1.37) < 1e-5);
    }
    /// For parabolas the best line solves a linear system: the gradient of the energy is zero there.
    void the_gradient_of_the_energy_is_zero() {
        std::mt19937 random(4);
        std::normal_distribution<double> anywhere(0.0, 1.0);
        for (int round = 0; round < 50; ++round) {
            std::vector<double> centres(15);
            for (double& c : centres)
                c = anywhere(random);
            const double weight = 2.0, stray = 0.3, bend = 1.5;
            const auto d = snapped(parabolas(centres, weight), stray, bend);
            for (std::size_t i = 0; i < d.size(); ++i) {
                double gradient = 2.0 * weight * (d[i] - centres[i]) + 2.0 * stray * d[i];
                if (i > 0)
                    gradient += 2.0 * bend * (d[i] - d[i - 1]);
                if (i + 1 < d.size())
                    gradient += 2.0 * bend * (d[i] - d[i + 1]);
                QVERIFY2(std::abs(gradient) < 1e-6, qPrintable(QString::number(gradient)));
            }
        }
    }
    /// No path through the listed offsets is better than the found line, also where evidence has many peaks.
    void nothing_listed_is_better() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> any(-3.0, 0.0);
        for (int round = 0; round < 100; ++round) {
            Evidence evidence{4, 5, 1.0, {}};
            for (int i = 0; i < 20; ++i)
                evidence.values.push_back(any(random));
            const double stray = 0.1, bend = 0.5;
            double best = std::numeric_limits<double>::infinity();
            std::vector<std::size_t> winner;
            for (std::size_t code = 0; code < 625; ++code) {
                const std::vector<std::size_t> path{code % 5, code / 5 % 5, code / 25 % 5, code / 125};
                if (const double e = energy(evidence, path, stray, bend); e < best) {
                    best = e;
                    winner = path;
                }
            }
            const auto d = snapped(evidence, stray, bend);
            for (std::size_t i = 0; i < 4; ++i) // the continuous line stays beside the best listed one
                QVERIFY(std::abs(d[i] - evidence.offset(winner[i])) <= 1.0 + 1e-9);
        }
    }
    void one_point_of_nonsense_does_not_pull_the_line() {
        std::vector<double> centres(15, 0.5);
        centres[7] = -4.0;
        const auto d = snapped(parabolas(centres, 0.1), 1e-3, 20.0);
        QVERIFY(std::abs(d[7] - d[6]) < 0.1);
    }
    void values_that_are_not_finite_say_nothing() {
        Evidence evidence = parabolas(std::vector<double>(9, 1.0), 5.0);
        evidence.values[4 * offsets + 3] = std::numeric_limits<double>::quiet_NaN();
        evidence.values[5 * offsets + 3] = std::numeric_limits<double>::infinity();
        const auto d = snapped(evidence, 1e-6, 1.0);
        for (double v : d)
            QVERIFY(std::abs(v - 1.0) < 1e-3);
        QVERIFY(std::isfinite(clarity(evidence, d)));
    }
    void evidence_beyond_the_offsets_moves_no_further_than_the_last() {
        for (double v : snapped(parabolas(std::vector<double>(5, 90.0), 5.0), 0.0, 1.0))
            QCOMPARE(v, 5.0);
    }
    void nothing_is_safe() {
        QVERIFY(snapped({}, 1.0, 1.0).empty());
        QCOMPARE(snapped({1, 0, 1.0, {}}, 1.0, 1.0), std::vector<double>{0.0});
        QVERIFY(snapped({0, 5, 1.0, {}}, 1.0, 1.0).empty());
        const auto alone = snapped(parabolas({1.0}, 50.0), 1e-6, 1.0);
        QCOMPARE(alone.size(), std::size_t{1});
        QVERIFY(std::abs(alone[0] - 1.0) < 1e-5);
        QCOMPARE(clarity({}, {}), 0.0);
    }
    /// By how much likelier the line is there than anywhere, as a logarithm, in the mean over its points.
    void clarity_is_how_much_likelier_the_line_is_there() {
        const Evidence evidence{2, 5, 0.5, {0.0, 1.0, 4.0, 2.0, 0.0, 3.0, 3.0, 3.0, 3.0, 5.0}};
        const double first = -std::log((2.0 * std::exp(-4.0) + std::exp(-3.0) + 1.0 + std::exp(-2.0)) / 5.0);
        const double at_last = -std::log((4.0 * std::exp(-2.0) + 1.0) / 5.0);
        QVERIFY(std::abs(clarity(evidence, {0.0, 1.0}) - 0.5 * (first + at_last)) < 1e-12);
        QVERIFY(std::abs(clarity(evidence, {0.2, 9.0}) - 0.5 * (first + at_last)) <
                1e-12); // the nearest offset
        const double at_first = -std::log((4.0 + std::exp(2.0)) / 5.0);
        QVERIFY(std::abs(clarity(evidence, {0.0, -9.0}) - 0.5 * (first + at_first)) < 1e-12);
    }
    void clearer_evidence_has_more_clarity() {
        const std::vector<double> centres(9, 1.0);
        double last = 0.0;
        for (double weight : {0.1, 1.0, 10.0}) {
            const Evidence evidence = parabolas(centres, weight);
            const double now = clarity(evidence, snapped(evidence, 1e-3, 1.0));
            QVERIFY(now > last);
            last = now;
        }
    }
};

QTEST_GUILESS_MAIN(LineSnapTest)
#include "line_snap_test.moc"
