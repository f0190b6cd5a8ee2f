// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>

namespace tp {

/// Stores the frames from `begin` up to, but without, `end` of a recording as a new FLAC beside it, under its
/// name with a number: sample by sample the same, with its notes and the chapters that fall into it. The
/// recording itself stays as it is. Where the new one is; an error is the end of a sentence, and then there
/// is none.
Result<std::filesystem::path> trim_recording(const std::filesystem::path& recording, std::uint64_t begin,
                                             std::uint64_t end);

} // namespace tp
