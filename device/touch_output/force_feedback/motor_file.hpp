// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/force_feedback/feedback_node.hpp"
#include "device/touch_output/plugged_touch_output.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace tp {

/// A simulated actuator, for a desk and for tests, that is a file: it is plugged in while the file is there and writes what it
/// does to the file's end, a line each, in whole numbers:
///
///     MICROSECONDS opened
///     MICROSECONDS tick THOUSANDTHS HERTZ MILLISECONDS    of the full amplitude; 125 (soft) … 250 (sharp)
///     MICROSECONDS off
///     MICROSECONDS closed
///
/// The time is that of std::chrono::steady_clock. A line is whole once it can be read.
class MotorFile final : public FeedbackNode {
public:
    explicit MotorFile(std::filesystem::path file);
    ~MotorFile() override;
    MotorFile(const MotorFile&) = delete;
    MotorFile& operator=(const MotorFile&) = delete;

    /// 0, or the errno of opening it; ENODEV where there is no such file. Nothing is created.
    int open();
    FeedbackKind kind() const override { return FeedbackKind::sine; }
    int upload(const FeedbackEffect& effect) noexcept override;
    int play(bool on) noexcept override;
    bool there() const noexcept override;

private:
    int line(const char* text) noexcept;

    const std::filesystem::path path_;
    std::FILE* file_ = nullptr;
    FeedbackEffect effect_;
};

/// It, while the file is there; as a registry has what is plugged in.
std::vector<PluggedTouchOutput> plugged_motor_file(const std::filesystem::path& file);

} // namespace tp
