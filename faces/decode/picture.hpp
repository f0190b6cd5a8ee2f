// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/decode/picture_file.hpp"

#include <opencv2/core/mat.hpp>

#include <filesystem>
#include <functional>

namespace tp {

/// The largest picture that is decoded, in pixels: 200 megapixel.
inline constexpr double largest_picture_px = 200e6;

/// Decodes a photograph (JPEG, PNG, WebP, TIFF, BMP, JPEG 2000, HEIC, AVIF) to 8-bit BGR, upright: its EXIF
/// orientation applied, or HEIC's and AVIF's own; grey widened, alpha dropped, CMYK and 16 bit converted. Of
/// a camera's raw file (DNG, CR2, CR3, NEF, ARW, ORF, RW2) the largest preview in it that can be decoded.
/// Says in one sentence what is wrong with a file that is missing, a folder, empty, not a picture, damaged,
/// cut short, or larger than `largest_picture_px` (judged from its header, before any pixel is decoded).
Result<cv::Mat> read_picture(const std::filesystem::path& file);
/// The same from a file's bytes; `largest_px` pixels at most.
Result<cv::Mat> decode_picture(const Bytes& bytes, double largest_px = largest_picture_px);

/// A photograph as large as a screen of `box` pixels can show whole, never larger than it is: the longer way
/// round is `read_picture` and shrinking. A JPEG is decoded at a half, a quarter or an eighth where that is
/// enough, and of a HEIC file its thumbnail.
Result<cv::Mat> read_picture_to_fit(const std::filesystem::path& file, cv::Size box);

/// A photograph that its decoder made smaller.
struct ShrunkPicture {
    cv::Mat pixels; ///< 8-bit BGR, upright
    cv::Size size;  ///< px, of the whole picture, upright
    int shrink = 1; ///< pixels of the whole picture for one of these, each way: place times this is the place
                    ///< in the whole
    /// All pixels, as `read_picture` gives them: read anew, or, where that takes long (HEIC, AVIF), made of
    /// those that were decoded, which take three bytes each until this is destroyed.
    std::function<Result<cv::Mat>()> whole;
};
/// `read_picture` with fewer pixels: a JPEG, HEIC or AVIF at a half, a quarter or an eighth of its size,
/// whatever leaves its longest side at least `longest_px`. Other photographs, and a JPEG whose sides would
/// not come out even after it is turned, as they are.
Result<ShrunkPicture> read_picture_shrunk(const std::filesystem::path& file, int longest_px);

/// The picture shrunk (areas averaged) until it fits into `box`; itself where it does.
cv::Mat shrunk_to_fit(const cv::Mat& picture, cv::Size box);
/// The picture shrunk (areas averaged) until no side is longer than `longest_px`; itself where none is.
cv::Mat not_larger_than(const cv::Mat& picture, int longest_px);

/// The picture turned clockwise by 90, 180 or 270 degrees (Extraction::turned_degrees); itself otherwise.
cv::Mat turned(const cv::Mat& picture, int degrees);

} // namespace tp
