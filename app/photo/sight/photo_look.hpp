// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/seen/face_mark.hpp"

#include <filesystem>
#include <functional>
#include <stop_token>

namespace tp {

/// The version of what looks: larger whenever the same photograph may be seen differently.
inline constexpr int look_version = 2;

/// What is looked for beside what can be said.
enum class Marks { no, yes };

/// Looks at a photograph; one that cannot be read has no size. Ends early, with anything, when asked to.
using Look =
    std::function<Looked(const std::filesystem::path& photo, Marks marks, const std::stop_token& stop)>;

/// With nets of its own, which are made at the first photograph. For one thread at a time.
Look photo_look();

} // namespace tp
