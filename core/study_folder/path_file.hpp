// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/finger_path.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// An hour at 1 kHz, the longest trial there may be.
inline constexpr std::size_t most_path_samples = 3'600'001;
inline constexpr std::size_t most_path_bytes = std::size_t{192} << 20; ///< unpacked
inline constexpr std::size_t most_packed_path_bytes = std::size_t{64} << 20;
/// What a path is written with at least, samples a second.
inline constexpr double least_path_rate_hz = 100.0;

/// "participant-007-trial-0012.csv.gz", in the folder `paths` of the study
std::string path_file_name(int participant, int trial);

/// The finger's path as CSV: time_s, x_mm, y_mm, fx_n, fy_n, a line a sample. A tenth of a millisecond, a micrometre and a tenth
/// of a millinewton are the last digits; samples must be `is_path`.
std::string path_text(std::span<const FingerSample> path);

/// The same bytes for the same path, whenever and wherever it is written: path_text as gzip.
std::string path_bytes(std::span<const FingerSample> path);

/// Whether every number is one that can be written (none infinite or beyond 1e6), time does not go back or begin before 0, and no
/// more samples are there than may be.
bool is_path(std::span<const FingerSample> path);

/// An error is one sentence, with the number of the line where one is wrong.
Result<std::vector<FingerSample>> read_path_text(std::string_view csv);
Result<std::vector<FingerSample>> read_path_bytes(std::string_view gzip);
/// The path of one trial of a study's folder; the error has the file's name.
Result<std::vector<FingerSample>> read_path(const std::filesystem::path& file);

} // namespace tp
