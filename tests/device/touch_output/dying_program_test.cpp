// SPDX-License-Identifier: Apache-2.0
// A program that ends in mid-tick, in whatever way: what it sent last, given to a model of the device, is over by then or ends by
// itself. Apart from other tests, because the thread sanitizer starts no threads in a child.
#include "core/servo/clock.hpp"
#include "core/touch/touch_loop.hpp"
#include "device/touch_output/force_feedback/feedback_output.hpp"
#include "device/touch_output/force_feedback/simulated_feedback.hpp"
#include "device/touch_output/hid_haptics/haptic_pad.hpp"
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"
#include "device/touch_output/steam_pad/model_steam_pad.hpp"
#include "device/touch_output/steam_pad/steam_pad.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <span>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace tp;

namespace {

/// What a program sent; it outlives the program. One that dies in the middle of a message has not sent it.
class Wire {
public:
    void send(std::span<const std::uint8_t> message) noexcept {
        std::this_thread::sleep_for(std::chrono::microseconds(200)); // as a device's answer takes
        const std::uint32_t next = sent_ + 1;
        Message& slot = messages_[next % messages_.size()];
        slot.size = std::min(message.size(), slot.bytes.size());
        std::copy_n(message.begin(), slot.size, slot.bytes.begin());
        sent_ = next;
    }
    std::uint32_t sent() const { return sent_; }
    std::vector<std::uint8_t> last() const {
        const Message& slot = messages_[sent_ % messages_.size()];
        return {slot.bytes.begin(), slot.bytes.begin() + static_cast<std::ptrdiff_t>(slot.size)};
    }

private:
    struct Message {
        std::array<std::uint8_t, 128> bytes{};
        std::size_t size = 0;
    };
    std::array<Message, 2> messages_;
    std::atomic<std::uint32_t> sent_{0};
};

class WiredMotor final : public FeedbackNode {
public:
    explicit WiredMotor(Wire& wire) : wire_(wire) {}
    FeedbackKind kind() const override { return FeedbackKind::motor; }
    int upload(const FeedbackEffect& effect) noexcept override {
        effect_ = effect;
        return 0;
    }
    int play(bool on) noexcept override {
        const FeedbackEffect told = on ? effect_ : FeedbackEffect{};
        std::array<std::uint8_t, sizeof told> bytes{};
        std::memcpy(bytes.data(), &told, sizeof told);
        wire_.send(bytes);
        return 0;
    }
    bool there() const noexcept override { return true; }

private:
    Wire& wire_;
    FeedbackEffect effect_;
};

class WiredSteam final : public SteamTransport {
public:
    explicit WiredSteam(Wire& wire) : wire_(wire) {}
    steam::Kind kind() const override { return steam::Kind::deck; }
    Got read(Input&, int) noexcept override { return Got::nothing; }
    bool send(const steam::Feature& report) noexcept override {
        wire_.send(report);
        return true;
    }

private:
    Wire& wire_;
};

class WiredHaptics final : public HapticsTransport {
public:
    explicit WiredHaptics(Wire& wire) : wire_(wire) {}
    std::vector<std::uint8_t> descriptor() override {
        return {ModelHapticPad::descriptor().begin(), ModelHapticPad::descriptor().end()};
    }
    std::vector<std::uint8_t> feature(std::uint8_t id, std::size_t) override { return model_.feature(id); }
    Got read(Input&, int) noexcept override { return Got::nothing; }
    bool send(const haptics::Output& report) noexcept override {
        wire_.send(report.all());
        return true;
    }

private:
    Wire& wire_;
    ModelHapticPad model_;
};

/// One of the real back ends, and for how long a device shakes that was told a message last; -1: for longer than a tick may.
struct BackEnd {
    const char* name;
    std::function<std::unique_ptr<TouchOutput>(Wire&)> make;
    std::function<int(const std::vector<std::uint8_t>&)> shakes_ms;
};

template <typename Step>
int counted_ms(Step shakes) {
    constexpr int longest = static_cast<int>(1000.0 * Tick::longest_s);
    int ms = 0;
    while (ms <= longest && shakes())
        ++ms;
    return ms > longest ? -1 : ms;
}

std::vector<BackEnd> back_ends() {
    return {
        {"force feedback",
         [](Wire& wire) -> std::unique_ptr<TouchOutput> {
             return std::make_unique<FeedbackOutput>(
                 FeedbackOutput::Identity{"motor", ""}, [&wire]() -> Result<std::unique_ptr<FeedbackNode>> {
                     return std::unique_ptr<FeedbackNode>(std::make_unique<WiredMotor>(wire));
                 });
         },
         [](const std::vector<std::uint8_t>& last) {
             FeedbackEffect effect;
             std::memcpy(&effect, last.data(), sizeof effect);
             ModelMotor motor(FeedbackKind::motor);
             SimulatedFeedbackNode node(motor);
             if (effect == FeedbackEffect{})
                 return 0;
             node.upload(effect);
             node.play(true);
             return counted_ms([&] {
                 motor.step();
                 return motor.shakes() > 0.0;
             });
         }},
        {"Steam pad",
         [](Wire& wire) -> std::unique_ptr<TouchOutput> {
             return std::make_unique<SteamPad>(
                 std::vector<SteamPad::Opener>{[&wire]() -> Result<std::unique_ptr<SteamTransport>> {
                     return std::unique_ptr<SteamTransport>(std::make_unique<WiredSteam>(wire));
                 }});
         },
         [](const std::vector<std::uint8_t>& last) {
             ModelSteamPad pad(steam::Kind::deck);
             pad.receive(last);
             return counted_ms([&] {
                 pad.step();
                 return pad.felt(steam::Side::left) > 0.0 || pad.felt(steam::Side::right) > 0.0;
             });
         }},
        {"HID haptics",
         [](Wire& wire) -> std::unique_ptr<TouchOutput> {
             return std::make_unique<HapticPad>(
                 [&wire]() -> Result<std::unique_ptr<HapticsTransport>> {
                     return std::unique_ptr<HapticsTransport>(std::make_unique<WiredHaptics>(wire));
                 },
                 HapticPad::Identity{});
         },
         [](const std::vector<std::uint8_t>& last) {
             ModelHapticPad pad;
             pad.receive(last);
             return counted_ms([&] {
                 pad.step();
                 return pad.felt() > 0.0;
             });
         }},
    };
}

enum class Way { terminated, aborted, exits, killed };

[[noreturn]] void end(Way way) {
    if (way == Way::exits)
        std::exit(0);
    if (way == Way::aborted)
        std::abort();
    while (true)
        raise(way == Way::killed ? SIGKILL : SIGTERM);
}

/// Ticks without a pause through the loop, and ends.
[[noreturn]] void tick_and_end(const BackEnd& back_end, Wire& wire, Way way) {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGABRT, SIG_DFL);
    auto* const clock = new SteadyClock; // exit() finds all of it alive, as a program's own exit may
    TouchOutput* const output = back_end.make(wire).release();
    const auto can = output->open();
    if (!can)
        _exit(9);
    const std::uint32_t opened = wire.sent();
    auto* const loop = new TouchLoop(*output, can.value(), *clock, {});
    loop->start();
    while (wire.sent() < opened + 5) {
        loop->feel(Tick(1.0, 0.5, Tick::longest_s));
        std::this_thread::yield();
    }
    end(way);
}

} // namespace

class DyingProgramTest : public QObject {
    Q_OBJECT
private slots:
    void nothing_goes_on_behind_a_program_data() {
        QTest::addColumn<int>("back_end");
        QTest::addColumn<int>("way");
        const std::array ways{"terminated", "aborted", "exits", "killed"};
        for (int i = 0; i < static_cast<int>(back_ends().size()); ++i)
            for (int way = 0; way < static_cast<int>(ways.size()); ++way)
                QTest::addRow("%s, %s", back_ends()[static_cast<std::size_t>(i)].name,
                              ways[static_cast<std::size_t>(way)])
                    << i << way;
    }
    void nothing_goes_on_behind_a_program() {
        QFETCH(int, back_end);
        QFETCH(int, way);
        const BackEnd tried = back_ends()[static_cast<std::size_t>(back_end)];
        void* const shared =
            mmap(nullptr, sizeof(Wire), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        QVERIFY(shared != MAP_FAILED);
        constexpr int deaths = 8;
        int still = 0;
        for (int i = 0; i < deaths; ++i) {
            auto* const wire = new (shared) Wire;
            const pid_t child = fork();
            if (child == 0)
                tick_and_end(tried, *wire, static_cast<Way>(way));
            int status = 0;
            QCOMPARE(waitpid(child, &status, 0), child);
            QVERIFY(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
            const int ms = tried.shakes_ms(wire->last());
            QVERIFY2(ms >= 0, "it shakes for longer than a tick may");
            still += ms == 0 ? 1 : 0;
        }
        if (static_cast<Way>(way) == Way::killed)
            QVERIFY(still < deaths); // it was in the middle of one
        else
            QVERIFY(still >= deaths - 1); // a very busy machine may not send it in the 50 ms that are waited
        munmap(shared, sizeof(Wire));
    }
};

QTEST_APPLESS_MAIN(DyingProgramTest)
#include "dying_program_test.moc"
