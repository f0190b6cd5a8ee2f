// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/hid_pid/pid_reports.hpp"

#include <optional>

namespace tp {

/// Stamps the readings of a stick, whose reports have neither a clock nor a number: with the moment when a report
/// came.
///
/// A stick may say nothing while nothing changes (HID 1.11, 7.2.4): its silence counts as standing still, and each
/// message that it takes meanwhile stamps the same place again. A stick that has gone on reporting while nothing
/// changed for `rest_known_after` speaks at rest, and its silence is no reading. Only the servo's thread.
class ReportStamps {
public:
    static constexpr double rest_known_after = 1.0; ///< s of reports that all say the same
    static constexpr double rest_gap = 0.020;       ///< s between two of them, at most: beyond an idle rate

    /// A report that says where the grip is came at `now` s.
    void reported(const hid::Report& report, double now) noexcept;
    /// The stamp of a reading, s, where the stick took a message at `taken_at` s last; nothing where it has shown no
    /// life since the last stamp.
    std::optional<double> next(double taken_at) noexcept;

private:
    bool speaks_at_rest_ = false;
    hid::Report said_;              ///< the last report
    std::optional<double> said_at_; ///< s
    double same_since_ = 0.0;       ///< s; since then each report said the same, without a gap
    std::optional<double> last_;    ///< s, stamp
};

} // namespace tp
