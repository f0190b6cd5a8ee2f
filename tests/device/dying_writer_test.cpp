// SPDX-License-Identifier: Apache-2.0
// A process that is told to end while its writer is in the middle of a force leaves no force behind. Apart
// from the writer's other tests, because the thread sanitizer starts no threads in a child.
#include "core/servo/exit_guard.hpp"
#include "core/servo/force_device.hpp"
#include "device/latest_writer.hpp"

#include <QObject>
#include <QTest>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <memory>
#include <optional>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using tp::LatestWriter;

namespace {

/// What arrived last on the way that a process wrote to, which it outlives.
class SlowWire final : public LatestWriter::Sink {
public:
    explicit SlowWire(std::atomic<std::uint64_t>& arrived) : arrived_(arrived) {}
    bool send(std::uint64_t message) noexcept override {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        arrived_.store(message);
        return true;
    }

private:
    std::atomic<std::uint64_t>& arrived_;
};

/// A device behind a writer, of which only the halt matters.
class Halted final : public tp::ForceDevice {
public:
    explicit Halted(LatestWriter& writer) : writer_(writer) {}
    tp::Result<tp::Capabilities> open() override { return tp::Capabilities{}; }
    std::optional<tp::DeviceState> read(double) noexcept override { return std::nullopt; }
    bool write(const tp::SafeForce&) noexcept override { return true; }
    void halt() noexcept override { writer_.halt(); }
    void stop() noexcept override {}

private:
    LatestWriter& writer_;
};

/// Posts forces all the time until it is told to end.
[[noreturn]] void die_in_mid_touch(std::atomic<std::uint64_t>& arrived) {
    std::signal(SIGTERM, SIG_DFL);
    LatestWriter writer(std::make_shared<SlowWire>(arrived), 0, LatestWriter::Thread::own);
    Halted device(writer);
    const tp::ExitGuard guard(device);
    const std::jthread servo([&] {
        while (true) {
            writer.post(7);
            std::this_thread::yield();
        }
    });
    while (arrived.load() == 0)
        std::this_thread::yield();
    while (true)
        raise(SIGTERM);
}

} // namespace

class DyingWriterTest : public QObject {
    Q_OBJECT

private slots:
    /// The servo posts forces and the writer sends them until the very end.
    void no_force_arrives_last_from_a_process_that_dies() {
        void* const shared = mmap(nullptr, sizeof(std::atomic<std::uint64_t>), PROT_READ | PROT_WRITE,
                                  MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        QVERIFY(shared != MAP_FAILED);
        auto* const arrived = new (shared) std::atomic<std::uint64_t>;
        for (int i = 0; i < 50; ++i) {
            arrived->store(0);
            const pid_t child = fork();
            if (child == 0)
                die_in_mid_touch(*arrived);
            int status = 0;
            QCOMPARE(waitpid(child, &status, 0), child);
            QVERIFY(WIFSIGNALED(status));
            QCOMPARE(WTERMSIG(status), SIGTERM);
            QCOMPARE(arrived->load(), std::uint64_t{0});
        }
        munmap(shared, sizeof(std::atomic<std::uint64_t>));
    }
};

QTEST_APPLESS_MAIN(DyingWriterTest)
#include "dying_writer_test.moc"
