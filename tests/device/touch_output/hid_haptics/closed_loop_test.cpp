// SPDX-License-Identifier: Apache-2.0
#include "../pad_judge.hpp"
#include "haptics_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace closed_loop_test {

using namespace tp;
using tp::testing::HapticsBench;

class HapticsClosedLoopTest : public QObject {
    Q_OBJECT
private slots:
    void the_cable_gives_no_more_than_it_was_asked_for() {
        HapticsBench bench;
        QCOMPARE(bench.link.sends(), 0ul);
        for (const std::size_t bytes : {std::size_t(0), std::size_t(4), std::size_t(16)})
            QCOMPARE(bench.link.feature(2, bytes).size(), bytes);
        QCOMPARE(bench.link.feature(2, 17).size(), std::size_t(16)); // and it has no more
        bench.put_finger({0.0, 0.0});
        HapticsTransport::Input input;
        QVERIFY(bench.link.read(input, 0) == HapticsTransport::Got::nothing);
        QVERIFY(bench.link.read(input, 8) == HapticsTransport::Got::report); // a wait passes in its own time
    }
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

} // namespace closed_loop_test

TP_TEST(closed_loop_test, HapticsClosedLoopTest, nothing)
#include "closed_loop_test.moc"
