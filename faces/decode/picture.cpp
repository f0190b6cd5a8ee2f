// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture.hpp"

#include "core/processes/foreign_decoder.hpp"
#include "core/processes/helper.hpp"
#include "faces/decode/fitted.hpp"
#include "faces/decode/foreign_picture.hpp"
#include "faces/decode/upright_picture.hpp"

#include <opencv2/imgproc.hpp>

#include <new>

namespace tp {

cv::Mat shrunk_to_fit(const cv::Mat& picture, cv::Size box) {
    return resized(picture, fitted(picture.size(), box));
}

cv::Mat not_larger_than(const cv::Mat& picture, int longest_px) {
    return shrunk_to_fit(picture, {longest_px, longest_px});
}

cv::Mat turned(const cv::Mat& picture, int degrees) {
    if (degrees != 90 && degrees != 180 && degrees != 270)
        return picture;
    cv::Mat result; // of its own: in place, the caller's picture would be turned too
    cv::rotate(picture, result,
               degrees == 90    ? cv::ROTATE_90_CLOCKWISE
               : degrees == 180 ? cv::ROTATE_180
                                : cv::ROTATE_90_COUNTERCLOCKWISE);
    return result;
}

namespace {

/// What `decode` makes of the file's bytes, in this process.
template <typename Value, typename Decode>
Result<Value> decoded_here(const std::filesystem::path& file, PictureKind kind, const Bytes& start,
                           Decode decode) {
    try {
        if (!start.empty() && kind == PictureKind::unknown)
            return decode(start);
        const Result<Bytes> bytes = read_bytes(file);
        return bytes ? decode(*bytes) : Error{bytes.error()};
    } catch (const std::bad_alloc&) {
        return no_memory();
    }
}

/// The helpers that decode such a file; null where this program decodes it. Where the system confines no process, it still decodes
/// JPEG: by a library that is small and in every browser.
HelperPool* helpers_for(PictureKind kind) {
    ForeignDecoders* const decoders = foreign_decoders();
    if (decoders == nullptr || kind == PictureKind::unknown)
        return nullptr;
    if (kind == PictureKind::jpeg)
        return decoders->jpegs.lease() ? &decoders->jpegs : nullptr;
    return kind == PictureKind::heic || kind == PictureKind::avif ? &decoders->heif : &decoders->pictures;
}

} // namespace

Result<cv::Mat> decode_picture(const Bytes& bytes, double largest_px) {
    return decoded_to_fit(bytes, no_box(), largest_px);
}

Result<cv::Mat> read_picture(const std::filesystem::path& file) {
    return read_picture_to_fit(file, no_box());
}

Result<cv::Mat> read_picture_to_fit(const std::filesystem::path& file, cv::Size box) {
    const Bytes start = first_bytes(file);
    const PictureKind kind = kind_of(start);
    if (HelperPool* const helpers = helpers_for(kind))
        return foreign_to_fit(*helpers, file, box);
    return decoded_here<cv::Mat>(file, kind, start,
                                 [&](const Bytes& bytes) { return decoded_to_fit(bytes, box); });
}

Result<ShrunkPicture> read_picture_shrunk(const std::filesystem::path& file, int longest_px) {
    const Bytes start = first_bytes(file);
    const PictureKind kind = kind_of(start);
    HelperPool* const helpers = helpers_for(kind);
    Result<ShrunkPicture> shrunk =
        helpers != nullptr ? foreign_shrunk(*helpers, file, longest_px)
                           : decoded_here<ShrunkPicture>(file, kind, start, [&](const Bytes& bytes) {
                                 return decoded_shrunk(bytes, longest_px);
                             });
    if (shrunk && !shrunk->whole)
        shrunk->whole = [file] { return read_picture(file); };
    return shrunk;
}

} // namespace tp
