// SPDX-License-Identifier: Apache-2.0
#include "core/friction/orientation.hpp"
#include "test_program.hpp"

#include <QTest>

#include <array>
#include <cstdint>
#include <limits>
#include <random>

namespace orientation_test {

using namespace tp;

namespace {

__extension__ using Wide = __int128;

/// The same in whole numbers.
int true_orientation(std::array<std::int64_t, 6> c) {
    const Wide value = Wide(c[2] - c[0]) * (c[5] - c[1]) - Wide(c[3] - c[1]) * (c[4] - c[0]);
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

} // namespace

class OrientationTest : public QObject {
    Q_OBJECT
private slots:
    void left_is_positive() {
        QCOMPARE(orientation({0, 0}, {1, 0}, {0, 1}), 1);
        QCOMPARE(orientation({0, 0}, {1, 0}, {0, -1}), -1);
        QCOMPARE(orientation({0, 0}, {1, 0}, {7, 0}), 0);
    }

    /// Numbers of 60 bits are no doubles' products; places nearly on the line have nearly all digits in common.
    void equals_whole_numbers_however_close() {
        std::mt19937_64 random(1);
        int zero = 0, close = 0;
        for (int round = 0; round < 300'000; ++round) {
            const std::int64_t size = std::int64_t(1) << (4 + round % 49);
            std::uniform_int_distribution<std::int64_t> place(-size, size);
            std::array<std::int64_t, 6> c{};
            for (std::int64_t& value : c)
                value = place(random);
            if (round % 2 == 0) { // p = a + k·(b − a), or next to it
                const std::int64_t k = std::int64_t(round % 7) - 3;
                c = {c[0] / 4, c[1] / 4, c[0] / 4 + c[2] / 8, c[1] / 4 + c[3] / 8, 0, 0};
                c[4] = c[0] + k * (c[2] - c[0]) + std::int64_t(random() % 3) - 1;
                c[5] = c[1] + k * (c[3] - c[1]) + std::int64_t(random() % 3) - 1;
                ++close;
            }
            const int right = true_orientation(c);
            zero += right == 0 ? 1 : 0;
            const double unit = round % 3 == 0 ? 1.0 : round % 3 == 1 ? 0x1p-40 : 0x1p-300;
            const auto at = [&](int i) {
                return unit * Vec2(double(c[std::size_t(2 * i)]), double(c[std::size_t(2 * i + 1)]));
            };
            QCOMPARE(orientation(at(0), at(1), at(2)), right);
            QCOMPARE(orientation(at(1), at(0), at(2)), -right);
            QCOMPARE(orientation(at(1), at(2), at(0)), right);
        }
        QVERIFY(close == 150'000 && zero > 10'000);
    }

    /// Lines that come from far and pass the origin nearly: what lies between a place near it and their ends is no double.
    void equals_whole_numbers_where_differences_are_rounded() {
        std::mt19937_64 random(2);
        std::uniform_int_distribution<std::int64_t> direction(-(1 << 26), 1 << 26), times(1 << 6, 1 << 7),
            place(-3, 3);
        int rounded = 0;
        for (int round = 0; round < 100'000; ++round) {
            const std::int64_t x = direction(random), y = direction(random);
            const std::int64_t far = times(random) << 26, farther = -times(random) << 25;
            std::array<std::int64_t, 6> c{x * far,     y * far,       x * farther,
                                          y * farther, place(random), place(random)};
            if (round % 2 == 0) { // and one on the line or beside it
                c[4] += 5 * x;
                c[5] += 5 * y;
            }
            const auto at = [&](int i) {
                return Vec2(double(c[std::size_t(2 * i)]), double(c[std::size_t(2 * i + 1)]));
            };
            const int right = true_orientation(c);
            rounded += std::int64_t(at(0).x - at(2).x) != c[0] - c[4] ? 1 : 0;
            QCOMPARE(orientation(at(0), at(1), at(2)), right);
            QCOMPARE(orientation(at(1), at(0), at(2)), -right);
            QCOMPARE(orientation(at(2), at(0), at(1)), right);
        }
        QVERIFY(rounded > 50'000);
    }

    /// Three corners as they come, nearly in a line: each order of them rounds otherwise.
    void equals_itself_from_whichever_corner() {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> at(-1.0, 1.0);
        for (int round = 0; round < 200'000; ++round) {
            const double ax = at(random), ay = at(random), bx = at(random), by = at(random);
            const Vec2 a(ax, ay), b(bx, by), p = a + 3.0 * at(random) * (b - a);
            const int side = orientation(a, b, p);
            QVERIFY(side == orientation(b, p, a) && side == orientation(p, a, b));
            QVERIFY(side == -orientation(b, a, p) && side == -orientation(p, b, a));
        }
    }

    /// Kettner, Mehlhorn, Pion, Schirra, Yap, "Classroom examples of robustness problems" (2008): double alone takes many of
    /// these places for the wrong side.
    void one_ulp_beside_a_diagonal() {
        const double ulp = std::numeric_limits<double>::epsilon() / 2.0;
        for (int i = 0; i < 256; ++i)
            for (int j = 0; j < 256; ++j) {
                const Vec2 p(0.5 + i * ulp, 0.5 + j * ulp);
                QCOMPARE(orientation({12, 12}, {24, 24}, p), i == j ? 0 : j > i ? 1 : -1);
            }
    }

    void what_is_not_finite_or_huge_is_answered() {
        const double values[] = {0.0,    1e-320,       1e308,
                                 -1e308, std::nan(""), std::numeric_limits<double>::infinity()};
        for (const double x : values)
            for (const double y : values)
                for (const double z : values) {
                    const int side = orientation({x, y}, {z, x}, {y, z});
                    QVERIFY(side >= -1 && side <= 1);
                }
    }
};

} // namespace orientation_test

TP_TEST(orientation_test, OrientationTest, nothing)
#include "orientation_test.moc"
