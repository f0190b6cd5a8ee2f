// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <functional>
#include <vector>

namespace tp {

/// Of `names_of(1)`, `names_of(2)` …, each one or more names that belong together, the first of those of which none is
/// taken; its first name. An error, the end of a sentence, where the disk does not tell whether one is: a fault is no free
/// name.
Result<std::filesystem::path>
free_name(const std::function<std::vector<std::filesystem::path>(int number)>& names_of);

} // namespace tp
