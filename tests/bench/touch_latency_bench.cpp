// SPDX-License-Identifier: Apache-2.0
// How long it takes from a finger's place to the motor's command: a finger that wanders over a map of many lines at 1 kHz,
// through friction, its events, ticks, the output by force feedback and its writer's thread, to a simulated motor. The loop and
// the writer have to be woken: on a busy computer that is what is measured.
// touch_latency_bench [SECONDS] [MS] [LOAD]: so long a run, a driver that takes so many ms over a change of its effect, and so
// many threads beside it that compute without a pause.
#include "app/figures/bench/bench_scene.hpp"
#include "core/guidance/exact_law.hpp"
#include "core/servo/real_time.hpp"
#include "core/touch/tick_law.hpp"
#include "device/touch_output/force_feedback/feedback_output.hpp"
#include "device/touch_output/force_feedback/simulated_feedback.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

using namespace tp;

namespace {

using Steady = std::chrono::steady_clock;

double now() { return std::chrono::duration<double>(Steady::now().time_since_epoch()).count(); }

/// Seconds from the places that were told to the beginnings of the motor. The writer's thread puts them in.
struct Stamps {
    std::atomic<double> place_at{0.0};
    std::vector<double> delays;
};

/// A simulated motor that stamps each beginning, behind a driver that takes its time.
class StampedNode final : public FeedbackNode {
public:
    StampedNode(Stamps& stamps, double change_ms) : stamps_(stamps), change_ms_(change_ms) {}
    FeedbackKind kind() const override { return node_.kind(); }
    int upload(const FeedbackEffect& effect) noexcept override {
        std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(change_ms_));
        return node_.upload(effect);
    }
    int play(bool on) noexcept override {
        const int error = node_.play(on);
        if (on && stamps_.delays.size() < stamps_.delays.capacity())
            stamps_.delays.push_back(now() - stamps_.place_at.load());
        return error;
    }
    bool there() const noexcept override { return node_.there(); }

private:
    Stamps& stamps_;
    double change_ms_;
    ModelMotor motor_{FeedbackKind::sine};
    SimulatedFeedbackNode node_{motor_};
};

/// ms below which `share` of them lie.
double quantile_ms(std::vector<double> seconds, double share) {
    if (seconds.empty())
        return 0.0;
    const auto at =
        seconds.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(seconds.size() - 1));
    std::nth_element(seconds.begin(), at, seconds.end());
    return 1e3 * *at;
}

void print(const char* what, const std::vector<double>& seconds) {
    std::printf("%-34s %8zu  p50 %.4f ms  p99 %.4f ms  max %.4f ms\n", what, seconds.size(),
                quantile_ms(seconds, 0.5), quantile_ms(seconds, 0.99), quantile_ms(seconds, 1.0));
}

/// Threads that compute until it ends.
class Load {
public:
    explicit Load(int threads) {
        for (int i = 0; i < threads; ++i)
            threads_.emplace_back([](const std::stop_token& stop) {
                for (volatile unsigned work = 0; !stop.stop_requested();)
                    work = work + 1;
            });
    }

private:
    std::vector<std::jthread> threads_;
};

} // namespace

int main(int count, char** words) {
    const double seconds = count > 1 ? std::atof(words[1]) : 20.0;
    const double change_ms = count > 2 ? std::atof(words[2]) : 0.0;
    const FlatScene map = bench_scene(20'000).flat;
    const std::vector<Vec2> path = hand_path(static_cast<std::size_t>(1000.0 * seconds));
    const ExactLaw exact(map, {});
    const FrictionLaw law(map, {});
    FrictionFinger finger(law);

    const Load load(count > 3 ? std::atoi(words[3]) : 0);
    Stamps stamps;
    stamps.delays.reserve(path.size());
    FeedbackOutput output({"motor", ""}, [&]() -> Result<std::unique_ptr<FeedbackNode>> {
        return std::unique_ptr<FeedbackNode>(std::make_unique<StampedNode>(stamps, change_ms));
    });
    if (!output.open().ok())
        return 1;
    std::vector<double> caller;
    std::vector<double> late;
    caller.reserve(path.size());
    late.reserve(path.size());
    std::size_t told = 0;
    const bool real_time = prefer_real_time(19); // as the touch loop
    auto due = Steady::now();
    for (const Vec2 place : path) {
        due += std::chrono::milliseconds(1);
        std::this_thread::sleep_until(due);
        late.push_back(std::chrono::duration<double>(Steady::now() - due).count());
        const double begun = now();
        const Tick tick = tick_of(finger.step(place, {80.0, 0.0}, exact.at(place)), {});
        if (!tick.empty()) {
            stamps.place_at.store(begun);
            output.tick(tick);
            ++told;
        }
        caller.push_back(now() - begun);
    }
    output.stop();
    std::printf("%zu ticks told, real-time priority %s\n", told, real_time ? "given" : "not given");
    print("how late the loop's periods began", late);
    print("place to the end of the loop's work", caller);
    print("place to the motor's command", stamps.delays);
    return 0;
}
