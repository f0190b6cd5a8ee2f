// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace tp {

/// What can go wrong on the way between a computer and a device. Shares are 0 … 1 of all reports from the device.
struct CableTroubles {
    double drop = 0.0;
    double garble = 0.0; ///< some bytes are others
    double cut = 0.0;    ///< a shorter report
    bool mute = false;   ///< nothing comes from the device
    bool deaf = false;   ///< nothing reaches the device, and nobody is told
    bool unplugged = false;
};

/// Reports under way between a computer and a model of a device, in simulated time.
class ReportCable {
public:
    using Report = std::vector<std::uint8_t>;

    /// `delay_ms` is how many milliseconds a report takes each way.
    ReportCable(unsigned delay_ms, std::uint32_t seed) : delay_ms_(delay_ms), random_(seed) {}

    unsigned delay_ms() const { return delay_ms_; }
    bool happens(double share);
    /// A millisecond.
    void pass() { ++now_; }

    void to_device(Report report) { to_device_.push_back({now_ + 1 + delay_ms_, std::move(report)}); }
    /// The next report that has come to the device.
    std::optional<Report> at_device() { return arrived(to_device_); }
    bool all_at_device() const { return to_device_.empty(); }

    /// Lost and spoilt as the troubles say.
    void to_computer(Report report, const CableTroubles& troubles);
    /// Reads the next report that comes to the computer, as a transport does; `advance` passes a millisecond of a wait.
    template <typename Got, typename Input, typename Advance>
    Got read(Input& report, int wait_ms, const CableTroubles& troubles, Advance advance) {
        for (;; --wait_ms) {
            if (troubles.unplugged)
                return Got::lost;
            if (const std::optional<Report> bytes = arrived(to_computer_)) {
                fill(report, *bytes);
                return Got::report;
            }
            if (wait_ms <= 0)
                return Got::nothing;
            advance();
        }
    }
    /// As much of the bytes as the report holds.
    template <typename Input>
    static void fill(Input& report, const Report& bytes) {
        report.size = std::min(bytes.size(), report.bytes.size());
        std::copy_n(bytes.begin(), report.size, report.bytes.begin());
    }

private:
    struct UnderWay {
        std::uint64_t due = 0; ///< ms
        Report bytes;
    };
    std::optional<Report> arrived(std::deque<UnderWay>& reports) const;

    unsigned delay_ms_;
    std::mt19937 random_;
    std::uint64_t now_ = 0; ///< ms
    std::deque<UnderWay> to_device_;
    std::deque<UnderWay> to_computer_;
};

} // namespace tp
