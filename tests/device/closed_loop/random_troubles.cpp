// SPDX-License-Identifier: Apache-2.0
#include "bench_judge.hpp"
#include "closed_loop_test.hpp"
#include "fault_schedules.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace tp::testing {

namespace {
constexpr double usual_tick = 0.001; // s
}

TroubleKind late_tick(double slack) {
    return {.set = [](LoopBench&, double, bool) {}, .slack = slack, .late = true};
}

TroubleKind letting_go() {
    return {.set =
                [](LoopBench& bench, double, bool on) {
                    if (on)
                        bench.loop->disengage();
                    else
                        bench.loop->engage();
                },
            .lets_go = true};
}

TroubleKind stalled_writer(double slack) {
    return {.set = [](LoopBench& bench, double, bool on) { bench.writer_stalled = on; }, .slack = slack};
}

TroubleKind pulled_cable(double slack) {
    return {.set = [](LoopBench& bench, double, bool) { bench.unplugged() = true; }, .slack = slack};
}

/// Whatever goes wrong, and however much of it at once: no force beyond the limits, no hang, for every force that
/// goes a sentence; where a device that lets go by itself is unplugged, no force after a while; and where commands
/// still get to it in the end, none that stays when the person lets go.
QString ClosedLoopTest::schedule(std::size_t variant, int number) const {
    std::mt19937 random(static_cast<unsigned>(number) + 100000u * static_cast<unsigned>(variant));
    const int variants = static_cast<int>(device_.variants.size());
    if (device_.in_turn)
        variant = static_cast<std::size_t>(number % variants);
    const bool delayed = (device_.in_turn ? number / variants : number) % 2 != 0;
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const Handle handle{.held = number % 3 == 0 ? Held::not_at_all : device_.grip};
    const auto bench = device_.make(variant, handle, delayed ? 1u : 0u, static_cast<std::uint32_t>(random()));
    if (!bench->loop)
        return QString::fromStdString(bench->error);
    const Vec2 middle = bench->middle();
    bench->render({line_at(3.0, middle), line_at(-3.0, middle)});
    device_.start(*bench, [&] { return share(random); });

    std::vector<std::pair<Trouble, const TroubleKind*>> troubles;
    const auto add = [&](const std::vector<TroubleKind>& kinds, std::size_t kind) {
        troubles.emplace_back(any_trouble(random, static_cast<int>(kind), device_.ticks), &kinds[kind]);
    };
    for (std::size_t left = 1 + random() % 4; left > 0; --left)
        add(device_.troubles, random() % device_.troubles.size());
    if (!device_.guards.empty() && number % 4 == 0)
        add(device_.guards, number % 16 == 0 ? device_.guards.size() - 1 : 0);
    double slack = device_.slack(*bench, true);
    for (const auto& [trouble, kind] : troubles)
        slack = std::max(slack, kind->slack);

    BenchJudge judge(device_, *bench, slack);
    int unplugged_for = 0;
    const auto judge_after = [&](double dt) {
        judge.judge(dt);
        unplugged_for = bench->unplugged() ? unplugged_for + 1 : 0;
        const double watchdog = device_.watchdogs[variant];
        const char* breach = device_.breach(*bench, slack);
        if (watchdog > 0.0 && usual_tick * unplugged_for > watchdog + 0.003 && !bench->lets_go())
            breach = "unplugged, and still a force";
        if (breach != nullptr && judge.complaint.isEmpty())
            judge.complaint = QStringLiteral("%1 at %2 s").arg(QLatin1String(breach)).arg(bench->clock.now());
    };
    for (int tick = 0; tick < device_.ticks && judge.complaint.isEmpty(); ++tick) {
        double dt = usual_tick;
        for (const auto& [trouble, kind] : troubles) {
            if (kind->lets_go && (tick == trouble.from || tick == trouble.until))
                judge.wanted = tick == trouble.until;
            if (tick == trouble.from)
                kind->set(*bench, trouble.size, true);
            if (tick == trouble.until)
                kind->set(*bench, trouble.size, false);
            if (tick == trouble.from && kind->late)
                dt = 0.001 * (2.0 + std::floor(80.0 * trouble.size));
        }
        bench->tick(dt);
        judge_after(dt);
    }
    device_.heal(*bench);
    bench->writer_stalled = false;
    judge.wanted = false;
    bench->loop->disengage();
    for (int tick = 0; tick < 200 && judge.complaint.isEmpty(); ++tick) {
        bench->tick();
        judge_after(usual_tick);
    }
    if (judge.complaint.isEmpty() && !bench->unplugged() && !bench->back_end().lost() && !let_go(*bench))
        return QStringLiteral("let go, and still a force");
    return judge.complaint;
}

void ClosedLoopTest::random_troubles_never_hurt_data() {
    QTest::addColumn<std::size_t>("variant");
    for (std::size_t i = 0; i < (device_.in_turn ? 1 : device_.variants.size()); ++i)
        QTest::newRow(device_.in_turn ? "in turn" : device_.variants[i]) << i;
}

void ClosedLoopTest::random_troubles_never_hurt() {
    QFETCH(std::size_t, variant);
    const int variants = device_.in_turn ? 1 : static_cast<int>(device_.variants.size());
    const int first = first_schedule();
    for (int number = first; number < first + (schedules() + variants - 1) / variants; ++number) {
        const QString complaint = schedule(variant, number);
        QVERIFY2(complaint.isEmpty(), qPrintable(QString("schedule %1: %2").arg(number).arg(complaint)));
    }
}

} // namespace tp::testing
