// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/write_sidecar.hpp"

#include <random>
#include <string>

namespace tp::test {

/// A text with what breaks careless writers: markup, quotation marks, line ends, emoji, right-to-left marks.
std::string random_text(std::mt19937_64& random);

/// Changes of all fields; persons contain the names of the faces, and named faces come first.
SidecarChanges random_changes(std::mt19937_64& random);

} // namespace tp::test
