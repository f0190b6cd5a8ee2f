// SPDX-License-Identifier: Apache-2.0
// A process that dies in the middle of a touch leaves no force behind.
#include "core/servo/exit_guard.hpp"
#include "core/servo/servo_loop.hpp"
#include "device_double.hpp"

#include <QTest>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace tp;
using tp::testing::DeviceDouble;

namespace {

/// What a dying process leaves behind.
struct Traces {
    std::atomic<double> force{0.0}; ///< N, written last
    std::atomic<int> halts{0};
};

class TracedDevice final : public ForceDevice {
public:
    explicit TracedDevice(Traces& traces) : traces_(traces) {}
    Result<Capabilities> open() override { return DeviceDouble::capabilities(); }
    std::optional<DeviceState> read(double now) noexcept override {
        return DeviceState{now, Vec2(10.0, 2.0), 0};
    }
    bool write(const SafeForce& force) noexcept override {
        traces_.force.store(length(force.newtons()));
        return true;
    }
    void halt() noexcept override { traces_.halts.fetch_add(1); }
    void stop() noexcept override {}

private:
    Traces& traces_;
};

/// As a program finds itself: without the handlers of the test library, which would write a stack trace.
void begin_plainly() {
    const rlimit no_core_file{0, 0};
    setrlimit(RLIMIT_CORE, &no_core_file);
    for (const int number :
         {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGXCPU})
        std::signal(number, SIG_DFL);
}

/// Lets a child feel 0.4 N, then end as `death` says; returns how waitpid saw it end.
int end_in_mid_touch(
    Traces& traces, const std::function<void()>& death, const std::function<void()>& at_first = [] {}) {
    const pid_t child = fork();
    if (child == 0) {
        begin_plainly();
        at_first();
        TracedDevice device(traces);
        VirtualClock clock;
        ServoLoop loop(device, DeviceDouble::capabilities(), clock, ServoSettings{});
        auto made = make_haptic_scene({200.0, 150.0, {contour_through("line", {{-80, 0}, {80, 0}}, false)}});
        loop.render(std::move(made).value());
        loop.engage();
        for (int i = 0; i < 1000; ++i) {
            clock.sleep_until(clock.now() + 0.001);
            loop.tick();
        }
        death();
        for (int i = 0; i < 5; ++i) { // it lived on
            clock.sleep_until(clock.now() + 0.001);
            loop.tick();
        }
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

} // namespace

class ExitGuardTest : public QObject {
    Q_OBJECT
    Traces* traces_ = nullptr;

private slots:
    void init() {
        void* shared =
            mmap(nullptr, sizeof(Traces), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        QVERIFY(shared != MAP_FAILED);
        traces_ = new (shared) Traces;
    }
    void cleanup() { munmap(traces_, sizeof(Traces)); }

    void every_deadly_signal_halts_the_device_first_data() {
        QTest::addColumn<int>("number");
        for (const auto& [name, number] : {std::pair{"SIGINT", SIGINT},
                                           {"SIGTERM", SIGTERM},
                                           {"SIGHUP", SIGHUP},
                                           {"SIGQUIT", SIGQUIT},
                                           {"SIGABRT", SIGABRT},
                                           {"SIGSEGV", SIGSEGV},
                                           {"SIGBUS", SIGBUS},
                                           {"SIGFPE", SIGFPE},
                                           {"SIGILL", SIGILL},
                                           {"SIGXCPU", SIGXCPU}})
            QTest::newRow(name) << number;
    }
    void every_deadly_signal_halts_the_device_first() {
        QFETCH(int, number);
        const int status = end_in_mid_touch(*traces_, [&] { raise(number); });
        QVERIFY(traces_->force.load() > 0.3);
        QCOMPARE(traces_->halts.load(), 1);
        QVERIFY(WIFSIGNALED(status)); // it still ends as it would have
        QCOMPARE(WTERMSIG(status), number);
    }

    void an_uncaught_exception_halts_the_device() {
        end_in_mid_touch(*traces_,
                         [] { std::thread([] { throw std::runtime_error("nobody catches it"); }).join(); });
        QVERIFY(traces_->force.load() > 0.3);
        QCOMPARE(traces_->halts.load(), 1);
    }

    void exit_halts_the_device() {
        const int status = end_in_mid_touch(*traces_, [] { std::exit(3); });
        QVERIFY(traces_->halts.load() >= 1);
        QCOMPARE(WEXITSTATUS(status), 3);
    }

    void a_quick_exit_halts_the_device() {
        const int status = end_in_mid_touch(*traces_, [] { std::quick_exit(3); });
        QVERIFY(traces_->halts.load() >= 1);
        QCOMPARE(WEXITSTATUS(status), 3);
    }

    void an_ignored_signal_stays_ignored() {
        const int status = end_in_mid_touch(
            *traces_, [] { raise(SIGHUP); }, [] { std::signal(SIGHUP, SIG_IGN); });
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 0);
        QCOMPARE(traces_->halts.load(), 0);
    }

    /// The servo's thread goes on while the signal takes its way: a force written then would outlive the
    /// process.
    void nothing_is_written_after_the_halt() {
        const int status = end_in_mid_touch(
            *traces_,
            [this] {
                raise(SIGTERM);
                traces_->force.store(0.0);
            },
            [] { std::signal(SIGTERM, [](int) {}); });
        QVERIFY(WIFEXITED(status));
        QCOMPARE(traces_->halts.load(), 1);
        QCOMPARE(traces_->force.load(), 0.0);
    }

    void a_device_that_was_let_go_is_left_alone() {
        const int status = end_in_mid_touch(*traces_, [this] {
            Traces other;
            TracedDevice device(other);
            { const ExitGuard guard(device); }
            traces_->halts.store(0);
            raise(SIGTERM);
        });
        QVERIFY(WIFSIGNALED(status));
        QCOMPARE(traces_->halts.load(), 1); // the touched one's
    }

    void room_for_sixteen() {
        Traces traces;
        TracedDevice device(traces);
        std::vector<std::unique_ptr<ExitGuard>> guards;
        for (int i = 0; i < 16; ++i)
            guards.push_back(std::make_unique<ExitGuard>(device));
        QVERIFY(guards.back()->guarding());
        QVERIFY(!ExitGuard(device).guarding());
        guards.clear();
        QVERIFY(ExitGuard(device).guarding());
    }
};

QTEST_APPLESS_MAIN(ExitGuardTest)
#include "exit_guard_test.moc"
