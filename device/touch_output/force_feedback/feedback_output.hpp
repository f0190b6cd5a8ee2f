// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/touch/touch_output.hpp"
#include "device/latest_writer.hpp"
#include "device/touch_output/force_feedback/feedback_node.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace tp {

/// Ticks on a device that plays effects. It has one effect in the device, which is changed where a tick differs from the one
/// before, and played. Both are the writer's, since a driver may take its time over a change.
///
/// Whatever plays ends by itself: each effect has a length of at most Tick::longest_s.
class FeedbackOutput final : public TouchOutput {
public:
    /// s after it was asked for, a tick tells of a place where the finger is no more, and is left out.
    static constexpr double late_after_s = 0.1;

    struct Identity {
        std::string name; ///< as a person is told
        std::string serial_number;
    };
    using Opener = std::function<Result<std::unique_ptr<FeedbackNode>>()>;
    using Clock = std::function<double()>; ///< s; any thread, allocates nothing

    FeedbackOutput(Identity identity, Opener opener, LatestWriter::Thread thread = LatestWriter::Thread::own,
                   Clock clock = steady_now);
    ~FeedbackOutput() override;
    FeedbackOutput(const FeedbackOutput&) = delete;
    FeedbackOutput& operator=(const FeedbackOutput&) = delete;

    Result<TouchCapabilities> open() override;
    bool resist(double level) noexcept override;
    /// An empty tick is nothing; what is under way goes on.
    bool tick(const Tick& tick) noexcept override;
    void halt() noexcept override;
    void stop() noexcept override;
    bool lost() const noexcept override;
    std::string complaint() const override;

    /// Sends what the mailbox holds, if anything is new in it; for simulated time.
    void deliver() noexcept;
    static double steady_now();

private:
    enum class Trouble { none, late, refused, gone };
    /// What the writer uses; it outlives the output where the writer hangs.
    struct Wire final : LatestWriter::Sink {
        bool send(std::uint64_t message) noexcept override;
        /// False where the device is gone.
        bool answered(int error) noexcept;
        void is_in(Trouble what) noexcept;

        std::unique_ptr<FeedbackNode> node;
        Clock clock;
        std::optional<FeedbackEffect> stored; ///< in the node
        std::atomic<std::uint64_t> newest{0}; ///< that was posted
        std::atomic<double> asked_at{0.0};    ///< s, when it was
        std::shared_ptr<std::atomic<Trouble>> trouble;
    };

    Identity identity_;
    Opener opener_;
    LatestWriter::Thread thread_;
    Clock clock_;
    FeedbackKind kind_ = FeedbackKind::none;
    std::shared_ptr<Wire> wire_; ///< stays until the next open, for halt() from anywhere
    std::unique_ptr<LatestWriter> writer_;
    const std::shared_ptr<std::atomic<Trouble>> trouble_ =
        std::make_shared<std::atomic<Trouble>>(Trouble::none);
    std::atomic<bool> open_{false};
};

} // namespace tp
