// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/recording.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace tp {

/// "2026-05-01T101500-memo" from when it was recorded and its kind; "undated-memo" where the label has no
/// date and time.
std::string recording_stem(const RecordingLabel& label);

/// Calls `write` with `folder`/`stem``end`, or with "-2", "-3", … after the stem where the name is taken,
/// until it returns empty (done); then that name is the result. `reason_of(EEXIST)` from it says that
/// somebody else has taken the name meanwhile, and the next is tried; anything else that it says is the
/// error. A stem that is too long for a file's name is cut.
Result<std::filesystem::path>
under_free_name(const std::filesystem::path& folder, std::string_view stem, std::string_view end,
                const std::function<std::string(const std::filesystem::path&)>& write);

/// The name with the number `number` ≥ 1 of that row.
std::filesystem::path numbered_name(const std::filesystem::path& folder, std::string_view stem,
                                    std::string_view end, int number);

/// Whether anything has that name, also a link that leads nowhere.
bool is_taken(const std::filesystem::path& name);

} // namespace tp
