// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <vector>

namespace tp {

/// How loud a recording is from its beginning to its end, for a drawing of it.
struct SoundPeaks {
    std::vector<float> peaks; ///< largest sample of each of equally long parts, 0 … 1 of full scale
    double duration_s = 0.0;  ///< of the sound that could be read
};

/// Reads the whole file, which may take seconds: not for a page's thread. `count` > 0 parts, fewer for a sound that has
/// fewer samples. An error is the end of a sentence; stopped, it is empty.
Result<SoundPeaks> sound_peaks(const std::filesystem::path& file, std::size_t count, const std::stop_token& stop = {});

} // namespace tp
