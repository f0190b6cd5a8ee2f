// SPDX-License-Identifier: Apache-2.0
#include "../pad_judge.hpp"
#include "steam_bench.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstdint>
#include <memory>
#include <utility>

namespace closed_loop_test {

using namespace tp;
using tp::testing::SteamBench;

class SteamClosedLoopTest : public QObject {
    Q_OBJECT
private slots:
    void every_line_is_felt() {
        for (const steam::Kind kind : {steam::Kind::deck, steam::Kind::controller, steam::Kind::receiver}) {
            SteamBench bench(kind, 1);
            judge_every_line(bench);
        }
    }
    void random_troubles_never_hurt() {
        tp::testing::judge_random_troubles([](int number, std::uint32_t seed) {
            auto bench = std::make_unique<SteamBench>(static_cast<steam::Kind>(number % 3),
                                                      static_cast<unsigned>(number % 2), seed);
            return bench->error.empty() ? std::move(bench) : nullptr;
        });
    }
};

} // namespace closed_loop_test

TP_TEST(closed_loop_test, SteamClosedLoopTest, nothing)
#include "closed_loop_test.moc"
