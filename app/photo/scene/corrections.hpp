// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/svg/contour_sheet.hpp"
#include "faces/base/face.hpp"

#include <filesystem>
#include <string>

namespace tp {

/// Where a person's corrections to a photograph's contours lie: beside it, IMG_1.jpg.contours.svg for
/// IMG_1.jpg, in pixels of the upright picture.
std::filesystem::path correction_file(const std::filesystem::path& photo);

/// The name of the dot that stands in a sheet where a person took away the contour of that name.
std::string removed_name(const std::string& name);

/// All faces of an extraction as a sheet in its pixels; with several faces the contours are named "face 1
/// left_eye" and so on. What `corrected` reads.
ContourSheet sheet_of(const Extraction& extraction);

/// The extraction with the contours that a person mended in place of its own, and without those that a person
/// took away (`removed_name`); Face::mended names both.
///
/// The sheet's faces are matched by place, not by number, so that corrections survive when another model
/// finds the faces in another order; a face that only the sheet has is added. A sheet of the same shape but
/// another size (the photograph was scaled) is scaled. An error where its shape is another.
Result<Extraction> corrected(Extraction extraction, const ContourSheet& sheet);

/// `corrected` by the correction file beside `photo`, where there is one. One that cannot be used is said in
/// `problem`, and the extraction is left as it was found.
Extraction with_corrections(Extraction extraction, const std::filesystem::path& photo);

} // namespace tp
