// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/calibration.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace tp {

/// Where devices lie on the screen: device frame → screen frame (mm from the screen's top left corner, x right, y up),
/// each under its device's serial number, or its name where it has none.
using Calibrations = std::map<std::string, Calibration>;

/// Whether a map is one of a device that lies on a screen: it stretches by no more than 2, and by no less than 1/2, in
/// any direction. What a stiffness becomes by it stays within a factor of 4 (Affine::pull_back_force).
bool is_plausible(const Affine& device_to_screen);

/// As lines of "xx yx xy yy x y residual_mm used key", after one that says what this is; a key with a control character
/// is left out.
std::string text_of(const Calibrations& calibrations);
/// What of the text makes sense, each line by itself; a plausible map with a residual of at most `most_residual_mm`.
Calibrations calibrations_in(std::string_view text);

/// The one of that device in a file; none where there is no file.
std::optional<Calibration> kept_calibration(const std::filesystem::path& file, const std::string& key);
/// Adds it to the file, or puts it in the place of an older one; the sentence that says why not, else empty.
std::string keep_calibration(const std::filesystem::path& file, const std::string& key, const Calibration& calibration);

} // namespace tp
