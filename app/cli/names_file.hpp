// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <QString>

#include <set>
#include <string>

namespace tp {

/// What a file names, a line each; # begins a comment. `of_what` stands in the sentence where it cannot be
/// read: "The list of people cannot be read: …".
Result<std::set<std::string>> names_in(const QString& file, const std::string& of_what);

} // namespace tp
