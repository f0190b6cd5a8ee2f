// SPDX-License-Identifier: Apache-2.0
#include "device/touch_output/force_feedback/motor_file.hpp"

#include "device/open_problem.hpp"
#include "device/touch_output/force_feedback/feedback_output.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

namespace tp {

namespace {

const std::string motor_of_a_file = "simulated motor";

bool is_motor_file(const std::filesystem::path& file) noexcept {
    std::error_code unknown;
    return std::filesystem::is_regular_file(file, unknown);
}

Result<std::unique_ptr<FeedbackNode>> open_motor_file(const std::filesystem::path& file) {
    auto node = std::make_unique<MotorFile>(file);
    if (const int error = node->open(); error != 0)
        return Error{sentence(error == ENODEV ? OpenProblem::gone : open_problem_of(error), this_system(),
                              motor_of_a_file)};
    return std::unique_ptr<FeedbackNode>(std::move(node));
}

} // namespace

MotorFile::MotorFile(std::filesystem::path file) : path_(std::move(file)) {}

MotorFile::~MotorFile() {
    if (file_ == nullptr)
        return;
    line("closed");
    std::fclose(file_);
}

int MotorFile::open() {
    if (!there())
        return ENODEV;
    file_ = std::fopen(path_.string().c_str(), "a");
    return file_ == nullptr ? errno : line("opened");
}

int MotorFile::line(const char* text) noexcept {
    const bool written =
        std::fprintf(file_, "%lld %s\n", std::llround(1e6 * FeedbackOutput::steady_now()), text) > 0;
    return std::fflush(file_) == 0 && written ? 0 : EIO;
}

int MotorFile::upload(const FeedbackEffect& effect) noexcept {
    effect_ = effect;
    return there() ? 0 : ENODEV;
}

int MotorFile::play(bool on) noexcept {
    if (!there())
        return ENODEV;
    if (!on)
        return line("off");
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "tick %ld %ld %d", std::lround(effect_.strong / 65.535),
                  std::lround(1000.0 / effect_.period_ms), int{effect_.length_ms});
    return line(text.data());
}

bool MotorFile::there() const noexcept { return is_motor_file(path_); }

std::vector<PluggedTouchOutput> plugged_motor_file(const std::filesystem::path& file) {
    if (!is_motor_file(file))
        return {};
    PluggedTouchOutput output;
    output.name = "simulated:" + file.string();
    output.about = motor_of_a_file;
    output.delay = feedback_delay_s(FeedbackKind::sine);
    output.make = [file]() -> std::unique_ptr<TouchOutput> {
        return std::make_unique<FeedbackOutput>(FeedbackOutput::Identity{motor_of_a_file, {}},
                                                [file] { return open_motor_file(file); });
    };
    return {std::move(output)};
}

} // namespace tp
