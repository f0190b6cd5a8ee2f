// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "faces/decode/picture_file.hpp"

#include <opencv2/core/mat.hpp>

#include <array>
#include <memory>
#include <optional>

struct heif_context;
struct heif_image;
struct heif_image_handle;

namespace tp {

/// Decoded pixels, upright: libheif crops, turns and mirrors as the file's own properties say.
class HeifPixels {
public:
    /// None where the picture has not three colours of one size and depth.
    static std::optional<HeifPixels> of(std::shared_ptr<const heif_image> image);

    /// 8-bit BGR, `shrink` times smaller each way: the means of blocks, and what is over at the right and
    /// below left out.
    cv::Mat bgr(int shrink = 1) const;
    cv::Size size() const { return planes_.front().size(); } ///< px

private:
    std::shared_ptr<const heif_image> image_;
    std::array<cv::Mat, 3> planes_; ///< blue, green, red: `image_`'s own
    int bits_ = 8;                  ///< of each value, 8 to 16
};

/// The primary picture of a HEIC or AVIF file (ISO/IEC 23008-12), by libheif, which is loaded at the first
/// such file, and hevc_decoder.hpp. Depth maps, alpha and the file's other pictures are left out. EXIF's orientation does not count
/// here: the file's own properties irot and imir say how the picture is turned, and EXIF's only repeats them
/// (23008-12, annex A).
class HeifPicture {
public:
    /// Looks through the file's boxes; no pixel is decoded. `bytes` must outlive it; `format` is the name in
    /// sentences.
    static Result<HeifPicture> open(const Bytes& bytes, const char* format);

    /// Tiles, of which phones make a picture, are decoded by so many threads; 0 at first: by none but the
    /// caller's.
    void decode_tiles_by(int threads);

    cv::Size stored_size() const; ///< px, of all that is decoded, before it is cropped and turned
    cv::Size size() const;        ///< px, upright
    /// All pixels; or those of a thumbnail that the file has, where that shows the whole and is not smaller
    /// than `least`.
    Result<HeifPixels> decode(cv::Size least) const;

private:
    HeifPicture(const char* format, std::shared_ptr<heif_context> context,
                std::shared_ptr<const heif_image_handle> primary);
    Result<std::shared_ptr<const heif_image>> decoded_image(const heif_image_handle& picture) const;
    Result<HeifPixels> pixels_of(const heif_image_handle& picture) const;
    std::shared_ptr<const heif_image_handle> thumbnail(cv::Size least) const;

    const char* format_;
    std::optional<int> matrix_; ///< HevcAsRgb's
    std::shared_ptr<heif_context> context_;
    std::shared_ptr<const heif_image_handle> primary_;
};

} // namespace tp
