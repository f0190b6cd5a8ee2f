// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_setup.hpp"
#include "app/pages/lab/tick_tap.hpp"
#include "core/base/result.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

namespace tp {

/// A recording as the page plays it again.
struct LabReplay {
    std::vector<TickSample> ticks;
    double rate = 1000.0;        ///< Hz
    std::size_t delay_ticks = 0; ///< of the device
    std::size_t bytes_left = 0;  ///< at the end of the file, which are no whole tick
    std::optional<LabSetup> setup; ///< from the file beside the recording
    /// N by which the forces of a loop with that setup, fed the same readings, differed most from the recorded ones.
    double greatest_difference = 0.0;
};

/// Where a recording's setup lies: NAME.json beside NAME.touch.
std::filesystem::path setup_file(const std::filesystem::path& recording);

/// Reads a recording (device/recording/FORMAT.md) and, where its setup lies beside it, computes it again in simulated
/// time. An error is a whole sentence.
Result<LabReplay> read_replay(const std::filesystem::path& recording, const std::stop_token& stop = {});

} // namespace tp
