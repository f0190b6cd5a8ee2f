// SPDX-License-Identifier: Apache-2.0
#include "app/photo/towns/nearest_town.hpp"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace tp;

namespace {

std::string name_at(double latitude, double longitude) {
    const auto near = nearest_town(latitude, longitude);
    return near ? std::string(near->town->name) : std::string();
}

} // namespace

class NearestTownTest : public QObject {
    Q_OBJECT
private slots:
    void the_list_is_whole_and_sane() {
        QVERIFY(all_towns().size() > 20'000);
        for (const Town& town : all_towns()) {
            QVERIFY(std::abs(town.latitude) <= 90.0 && std::abs(town.longitude) <= 180.0);
            QVERIFY(town.thousands >= 15);
            QVERIFY(!town.name.empty());
        }
    }

    void a_place_is_called_after_its_town() {
        QCOMPARE(name_at(48.2085, 16.3721), std::string("Vienna"));
        QCOMPARE(name_at(37.5665, 126.978), std::string("Seoul"));
        QCOMPARE(name_at(-33.8568, 151.2153), std::string("Sydney"));
        QCOMPARE(name_at(40.7128, -74.006), std::string("New York City"));
    }

    void a_large_town_reaches_further_than_a_small_one() {
        constexpr Town large{0.0, 0.0, 1000, "Large", {}, {}}, small{0.0, 0.2, 15, "Small", {}, {}};
        const std::vector<Town> both{large, small};
        QCOMPARE(nearest_town(0.0, 0.12, both)->town->name, "Large"); // 13 km from it, 9 from the small one
        QCOMPARE(nearest_town(0.0, 0.19, both)->town->name, "Small");
    }

    void how_a_place_lies_to_a_town() {
        const std::vector<Town> one{{0.0, 0.0, 100, "Town", {}, {}}};
        QCOMPARE(nearest_town(0.0, 0.02, one)->where, NearTown::Where::in);
        QCOMPARE(nearest_town(0.0, 0.15, one)->where, NearTown::Where::near);
        QCOMPARE(nearest_town(0.0, 0.5, one)->where, NearTown::Where::from);
        QVERIFY(std::abs(nearest_town(0.0, 0.5, one)->distance_km - 55.6) < 0.1);
        QVERIFY(!nearest_town(0.0, 1.0, one)); // 111 km
    }

    void the_way_over_the_date_line_and_the_poles_is_short() {
        const std::vector<Town> east{{0.0, 179.95, 100, "East", {}, {}}};
        QVERIFY(nearest_town(0.0, -179.95, east));
        const std::vector<Town> north{{89.9, 0.0, 100, "North", {}, {}}};
        QVERIFY(nearest_town(89.9, 180.0, north));
        QVERIFY(std::abs(distance_km(0.0, 0.0, 0.0, 180.0) - 6371.0 * M_PI) < 1e-6);
    }

    void what_is_no_place_has_no_town() {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!nearest_town(nan, 16.0));
        QVERIFY(!nearest_town(48.0, nan));
        QVERIFY(!nearest_town(91.0, 16.0));
        QVERIFY(!nearest_town(48.0, 181.0));
        QVERIFY(!nearest_town(-48.0, -128.0)); // the middle of the Pacific
        QVERIFY(!nearest_town(48.0, 16.0, {}));
    }

    void the_early_way_out_loses_no_town() {
        std::mt19937_64 random(22);
        std::uniform_real_distribution<double> latitude(-70.0, 75.0), longitude(-180.0, 180.0);
        for (int i = 0; i < 200; ++i) {
            const double here = latitude(random), there = longitude(random);
            double nearest = std::numeric_limits<double>::infinity();
            for (const Town& town : all_towns())
                nearest = std::min(nearest, distance_km(here, there, town.latitude, town.longitude));
            QCOMPARE(nearest_town(here, there).has_value(), nearest <= 100.0);
        }
    }

    void lines_that_are_no_towns_are_left_out() {
        QVERIFY(towns_in("").empty());
        QVERIFY(towns_in("\n\t\t\t\n48.2\t16.3\t1\t\nx\t16.3\t1\tA\n48.2\t16.3\t1x\tB").empty());
        const std::vector<Town> towns = towns_in("48.2\t-16.3\t17\tA b\tÄ\n1\t2\t3\tC\t\t다");
        QCOMPARE(towns.size(), std::size_t(2));
        QCOMPARE(towns[0].longitude, -16.3);
        QCOMPARE(towns[0].german, "Ä");
        QVERIFY(towns[0].korean.empty());
        QCOMPARE(towns[1].korean, "다");
    }
};

QTEST_APPLESS_MAIN(NearestTownTest)
#include "nearest_town_test.moc"
