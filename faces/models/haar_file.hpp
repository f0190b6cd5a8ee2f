// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/objdetect.hpp>

#include <filesystem>
#include <optional>

namespace tp {

/// The cascade of Haar features (Viola, Jones 2001) in an XML file of OpenCV 2.4.3 or later. Nothing where
/// the file is none, or where it points beyond its window, its trees or its features: OpenCV believes most of
/// what it says. Throws what OpenCV and the file system throw.
std::optional<cv::CascadeClassifier> haar_cascade(const std::filesystem::path& file);

} // namespace tp
