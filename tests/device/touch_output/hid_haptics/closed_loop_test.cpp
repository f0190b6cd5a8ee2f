// SPDX-License-Identifier: Apache-2.0
#include "../pad_judge.hpp"
#include "haptics_bench.hpp"

#include <QTest>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

using namespace tp;
using tp::testing::HapticsBench;

class HapticsClosedLoopTest : public QObject {
    Q_OBJECT
private slots:
    void every_line_is_felt() {
        HapticsBench bench(1);
        QCOMPARE(bench.open(), std::string());
        judge_every_line(bench);
    }
    void random_troubles_never_hurt() {
        tp::testing::judge_random_troubles([](int number, std::uint32_t seed) {
            auto bench = std::make_unique<HapticsBench>(static_cast<unsigned>(number % 2), seed);
            return bench->open().empty() ? std::move(bench) : nullptr;
        });
    }
};

QTEST_APPLESS_MAIN(HapticsClosedLoopTest)
#include "closed_loop_test.moc"
