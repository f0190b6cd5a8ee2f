// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace tp {

/// Whether a photograph carries more metadata than any program writes: a reader of metadata would fill the
/// memory with it. Looks at sizes only. Of kinds of file whose order it does not know it refuses large ones.
bool has_oversized_metadata(const std::filesystem::path& photo);

} // namespace tp
