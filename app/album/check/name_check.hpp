// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/check/findings.hpp"

#include <set>
#include <string>

namespace tp {

/// Looks at how somebody says people's names, and in what language they are read. `known_people` are those
/// that a photograph speaks of; none: that is not known, as some sidecar cannot be read.
void check_names(const std::set<std::string>* known_people, Findings& findings);

} // namespace tp
