// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "core/base/result.hpp"

#include <filesystem>

namespace tp {

/// A recording as a photograph's list has it: what its own comments say, how long it is, and by how much its
/// playback is evened out, measured on its sound. An error is a sentence.
Result<Tag> recording_facts(const std::filesystem::path& recording);

} // namespace tp
