// SPDX-License-Identifier: Apache-2.0
#include "app/cli/guidance_options.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/figures/report/test_scenes.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/simulated/simulated_device.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <thread>
#include <vector>

namespace tp {

namespace {

/// As many threads as the machine has cores, computing without a pause until destroyed.
class Load {
public:
    Load() {
        for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
            threads_.emplace_back([this] {
                double x = 1.0;
                while (!stop_.load(std::memory_order_relaxed))
                    x = std::sin(x) + 1.0;
                sink_.store(x);
            });
    }
    ~Load() {
        stop_ = true;
        for (std::thread& thread : threads_)
            thread.join();
    }
    Load(const Load&) = delete;
    Load& operator=(const Load&) = delete;

private:
    std::atomic<bool> stop_{false};
    std::atomic<double> sink_{0.0};
    std::vector<std::thread> threads_;
};

void print_row(const char* name, const TimingStatistics& statistics) {
    print("%-9s %10.1f %10.1f %10.1f %10.1f\n", name, 1e6 * statistics.quantile(0.5),
          1e6 * statistics.quantile(0.99), 1e6 * statistics.quantile(0.999), 1e6 * statistics.max());
}

} // namespace

int servo_verb(const QStringList& words) {
    VerbLine line(
        "servo", "Runs the servo loop on the simulated device and the reference face, and says how late its\n"
                 "ticks begin and how long they take: p50, p99, p99.9 and the largest, in microseconds.");
    line.option("seconds", "How long to measure, in seconds.", "s", "10")
        .option("rate", "Ticks per second.", "Hz", "1000");
    line.option("load", "Keeps every core busy meanwhile.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    const auto seconds = line.positive("seconds");
    const auto rate = line.positive("rate");
    if (!seconds || !rate)
        return wrong_usage("servo", seconds ? rate.error() : seconds.error());
    if (*rate < 10.0 || *rate > 20'000.0)
        return wrong_usage("servo", "--rate is from 10 to 20000 Hz.");

    SteadyClock clock;
    SimulatedDevice device(200.0, 200.0);
    const Capabilities can = *device.open();
    ServoSettings settings;
    settings.rate = *rate;
    ServoLoop loop(device, can, clock, settings);
    auto scene = make_haptic_scene(reference_face());
    loop.render(std::move(scene).value());
    loop.engage();
    {
        const std::unique_ptr<Load> load = line.has("load") ? std::make_unique<Load>() : nullptr;
        const double begun = clock.now();
        loop.start();
        LongWork::step("measuring");
        for (double t = 0.0; t < *seconds && !LongWork::stop_asked(); t = clock.now() - begun) {
            LongWork::share(t / *seconds);
            device.move_pointer({60.0 * std::cos(t), 40.0 * std::sin(1.3 * t)});
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        loop.stop();
    }
    print("%-9s %10s %10s %10s %10s\n", "us", "p50", "p99", "p99.9", "max");
    print_row("lateness", loop.lateness());
    print_row("compute", loop.compute());
    print("ticks %llu, missed periods %llu, real-time priority %s, memory %s\n",
          static_cast<unsigned long long>(loop.compute().count()),
          static_cast<unsigned long long>(loop.missed_periods()),
          loop.real_time() ? "obtained" : "not obtained", loop.memory_locked() ? "locked" : "not locked");
    if (!loop.real_time())
        say("The system gave no real-time priority; to allow it, give this user an rtprio limit of 21 or "
            "more in /etc/security/limits.d.");
    if (!loop.memory_locked())
        say("The system did not let the memory be locked; to allow it, give this user a memlock limit of "
            "a mebibyte or more in the same place.");
    return LongWork::stop_asked() ? LongWork::stop_code() : int{exit_done};
}

} // namespace tp
