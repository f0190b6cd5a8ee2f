// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <set>
#include <string>

namespace tp {

/// The people of a list like faces/training/holdout.txt: one number a line, lines with # are comments. An
/// error where it cannot be read or names nobody: then nobody would be held out.
Result<std::set<std::string>> held_out_people(const std::filesystem::path& list);

/// "london/002_03.jpg" shows "002".
std::string person_in(const std::filesystem::path& photo);

} // namespace tp
