// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tp {

/// What a program says when it is asked for its version, for a person who reports a fault: its line of
/// `version_line`, then the libraries that this machine has in it, whose versions need not be those it was
/// built with. Needs no display and opens nothing.
std::string program_version(const std::string& program);

} // namespace tp
