// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/extract/face_extractor.hpp"

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

namespace tp {

/// Takes the result of photograph `index`; false ends the batch. Must not throw.
using TakeExtraction = std::function<bool(std::size_t index, const Extraction& found)>;

/// Extracts `photos` on one thread for each of the `extractors` (at least one) and hands the results to
/// `take` on the calling thread, in the order of the photographs whatever the number of threads. Results that
/// wait for a slower predecessor are held back, a few for each thread.
///
/// Once `stop` is true no further photograph is begun; those begun are finished and handed over. Returns how
/// many were handed over; an error where the system gives no thread.
Result<std::size_t> extract_batch(std::vector<FaceExtractor> extractors,
                                  const std::vector<std::filesystem::path>& photos,
                                  const TakeExtraction& take, const std::atomic<bool>& stop);

} // namespace tp
