// SPDX-License-Identifier: Apache-2.0
#include "calibration_check.hpp"
#include "corpus.hpp"
#include "device/calibration_file.hpp"
#include "places.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace tp;

namespace {

Calibration turned(double degrees, double stretch = 1.0) {
    const double angle = degrees / 57.29577951308232;
    const double c = stretch * std::cos(angle);
    const double s = stretch * std::sin(angle);
    return {{glm::dmat2(c, s, -s, c), {100.25, -80.125}}, 0.4, 60};
}

} // namespace

class CalibrationFileTest : public QObject {
    Q_OBJECT
private slots:
    void each_device_keeps_its_own() {
        const QTemporaryDir folder;
        const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "new" / "calibrations.txt";
        QVERIFY(!kept_calibration(file, "TPC-0001").has_value());
        QCOMPARE(keep_calibration(file, "TPC-0001", turned(10.0)), std::string());
        QCOMPARE(keep_calibration(file, "pad:/dev/hidraw3 with words", turned(20.0)), std::string());
        QCOMPARE(keep_calibration(file, "TPC-0001", turned(30.0)), std::string()); // calibrated anew
        const auto kept = kept_calibration(file, "TPC-0001");
        QVERIFY(kept.has_value());
        QVERIFY(kept->device_to_surface.linear == turned(30.0).device_to_surface.linear);
        QVERIFY(kept->device_to_surface.offset == turned(30.0).device_to_surface.offset);
        QCOMPARE(kept->residual_mm, 0.4);
        QCOMPARE(kept->used, std::size_t(60));
        QVERIFY(kept_calibration(file, "pad:/dev/hidraw3 with words").has_value());
        QVERIFY(!kept_calibration(file, "another").has_value());
    }

    void what_cannot_be_kept_is_told_and_harms_nothing() {
        const QTemporaryDir folder;
        const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "calibrations.txt";
        QCOMPARE(keep_calibration(file, "A", turned(10.0)), std::string());
        for (const std::string key : {"", " leading", "two\nlines", "bell\a"})
            QVERIFY(keep_calibration(file, key, turned(20.0)).ends_with('.'));
        QVERIFY(!keep_calibration(file / "below a file", "A", turned(20.0)).empty());
        QVERIFY(kept_calibration(file, "A")->device_to_surface.linear == turned(10.0).device_to_surface.linear);
    }

    void only_a_device_on_a_screen_is_plausible() {
        for (double degrees = 0.0; degrees < 360.0; degrees += 30.0) {
            QVERIFY(is_plausible(turned(degrees).device_to_surface));
            QVERIFY(is_plausible(turned(degrees, 1.99).device_to_surface));
            QVERIFY(is_plausible(turned(degrees, 0.51).device_to_surface));
            QVERIFY(!is_plausible(turned(degrees, 2.01).device_to_surface));
            QVERIFY(!is_plausible(turned(degrees, 0.49).device_to_surface));
        }
        QVERIFY(is_plausible({glm::dmat2(1, 0, 0, -1), {0, 0}})); // mirrored
        QVERIFY(!is_plausible({glm::dmat2(1, 0, 1, 0), {0, 0}})); // flat
        QVERIFY(!is_plausible({glm::dmat2(1, 0, 0, 1), {1e9, 0}}));
        constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!is_plausible({glm::dmat2(not_a_number, 0, 0, 1), {0, 0}}));
        QVERIFY(!is_plausible({glm::dmat2(1, 0, 0, 1), {0, not_a_number}}));
    }

    void the_corpus_and_its_broken_copies_hold_what_the_fuzzer_asks() {
        const auto seeds = tp::test::corpus(tp::test::in_source("tests/device/calibration/corpus"));
        QVERIFY(seeds.size() >= 3);
        std::mt19937 random(7);
        for (const auto& [name, bytes] : seeds) {
            QCOMPARE(test::complaint_about_calibrations(bytes), std::string());
            QCOMPARE(calibrations_in(bytes).size(), std::size_t(name == "two" ? 2 : 0));
            for (int i = 0; i < 500; ++i) {
                std::string broken = bytes;
                for (unsigned k = 0; k < 1 + random() % 3; ++k)
                    broken[26 + random() % (broken.size() - 26)] = static_cast<char>(random() % 256);
                QCOMPARE(test::complaint_about_calibrations(broken), std::string());
            }
        }
    }
};

QTEST_GUILESS_MAIN(CalibrationFileTest)
#include "calibration_file_test.moc"
