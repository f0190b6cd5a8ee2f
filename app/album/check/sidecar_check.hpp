// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/check/findings.hpp"
#include "app/album/metadata/conflicts.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// Sidecars of a photograph that another machine changed meanwhile. What merging them leaves for a person to
/// know is put behind `told`.
void check_conflict_copies(const std::filesystem::path& photo, ConflictCopies& copies, Findings& findings,
                           std::vector<std::string>& told);

/// Whether the photograph's sidecar can be read; true where there is none.
bool check_sidecar(const std::filesystem::path& photo, Findings& findings);

/// Whether others on this machine may read what is said of a photograph that they may not see.
void check_readers_of_words(const std::filesystem::path& photo, Findings& findings);

/// Whether the photograph has the bytes of which its sidecar knows the SHA-256.
void check_content(const std::filesystem::path& photo, const std::string& known_hash, Findings& findings);

} // namespace tp
