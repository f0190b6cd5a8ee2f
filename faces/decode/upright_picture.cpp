// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/upright_picture.hpp"

#include "faces/decode/fitted.hpp"
#include "faces/decode/heif_picture.hpp"
#include "faces/decode/jpeg_picture.hpp"
#include "faces/decode/other_formats.hpp"
#include "faces/decode/picture_metadata.hpp"
#include "faces/decode/png_picture.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/decode/raw_file.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

namespace tp {
namespace {

const char* name_of(PictureKind kind) {
    switch (kind) {
    case PictureKind::jpeg:
        return "JPEG";
    case PictureKind::png:
        return "PNG";
    case PictureKind::webp:
        return "WebP";
    case PictureKind::tiff:
        return "TIFF";
    case PictureKind::bmp:
        return "BMP";
    case PictureKind::jpeg2000:
        return "JPEG 2000";
    case PictureKind::heic:
        return "HEIC";
    case PictureKind::avif:
        return "AVIF";
    case PictureKind::raw:
    case PictureKind::unknown:
        break;
    }
    return "picture";
}

Error damaged(PictureKind kind) { return {std::string("The ") + name_of(kind) + " file is damaged."}; }

/// Empty where the size is fine.
std::string objection_to_size(long long width, long long height, PictureKind kind, double largest_px) {
    if (width <= 0 || height <= 0)
        return damaged(kind).sentence;
    const double pixels = static_cast<double>(width) * static_cast<double>(height);
    if (pixels <= largest_px)
        return {};
    return "The picture is too large: " + std::to_string(width) + " × " + std::to_string(height) +
           " pixels, where at most " + std::to_string(std::lround(largest_px / 1e6)) +
           " million can be read.";
}

bool is_webp_cut_short(const Bytes& bytes) {
    const std::size_t stated = bytes[4] | static_cast<std::size_t>(bytes[5]) << 8 |
                               static_cast<std::size_t>(bytes[6]) << 16 |
                               static_cast<std::size_t>(bytes[7]) << 24;
    return stated + 8 > bytes.size();
}

Result<cv::Mat> decode_by_opencv(const Bytes& bytes, PictureKind kind) {
    Result<cv::Mat> picture = decode_other_format(bytes);
    return picture.ok() && picture->empty() ? damaged(kind) : picture;
}

constexpr int most_threads = 4; ///< that decode the tiles of one picture

bool is_heif(PictureKind kind) { return kind == PictureKind::heic || kind == PictureKind::avif; }

/// One that has been found to be of a size that can be read.
Result<HeifPicture> open_heif(const Bytes& bytes, PictureKind kind, double largest_px) {
    Result<HeifPicture> picture = HeifPicture::open(bytes, name_of(kind));
    if (!picture)
        return picture;
    const cv::Size stored = picture->stored_size();
    if (auto objection = objection_to_size(stored.width, stored.height, kind, largest_px); !objection.empty())
        return Error{objection};
    return picture;
}

/// Upright, as small as it fits into `box`. By several threads, for a person may wait for it; a batch has its
/// own threads (shrunk_heif).
Result<cv::Mat> decode_heif(const Bytes& bytes, PictureKind kind, double largest_px, cv::Size box) {
    Result<HeifPicture> picture = open_heif(bytes, kind, largest_px);
    if (!picture)
        return Error{picture.error()};
    picture->decode_tiles_by(most_threads);
    const cv::Size small = fitted(picture->size(), box);
    const Result<HeifPixels> pixels = picture->decode(small);
    return pixels ? Result<cv::Mat>(resized(pixels->bgr(shrink_to_fill(pixels->size(), small)), small))
                  : Error{pixels.error()};
}

/// One that can be read.
Result<cv::Size> size_of_png(const Bytes& bytes, double largest_px) {
    const Result<PngSize> size = png_size(bytes);
    if (!size)
        return Error{size.error()};
    if (auto objection = objection_to_size(size->width, size->height, PictureKind::png, largest_px);
        !objection.empty())
        return Error{objection};
    return cv::Size(static_cast<int>(size->width), static_cast<int>(size->height));
}

/// As it is stored, `shrink` times smaller.
Result<cv::Mat> shrunk_while_decoded(const Bytes& png, cv::Size whole, int shrink) {
    const Result<Bytes> bare = bare_png(png);
    return bare ? decode_png(*bare, whole, shrink) : Error{bare.error()};
}

/// As it is stored; a JPEG, PNG or HEIC, which takes less so, already as small as it fits into `box`.
Result<cv::Mat> decode(const Bytes& bytes, PictureKind kind, const PictureMetadata& metadata,
                       double largest_px, cv::Size box) {
    if (kind == PictureKind::jpeg) {
        const JpegHeader header = jpeg_header(bytes);
        if (header.width == 0 && header.height == 0)
            return Error{"The JPEG file is cut short: a part of the picture is missing."};
        if (auto objection = objection_to_size(header.width, header.height, kind, largest_px);
            !objection.empty())
            return Error{objection};
        const cv::Size whole(header.width, header.height);
        const Result<cv::Mat> picture = decode_jpeg(bytes, header, shrink_to_fill(whole, box));
        return picture ? Result<cv::Mat>(resized(*picture, fitted(whole, box))) : picture;
    }
    if (is_heif(kind))
        return decode_heif(bytes, kind, largest_px, box);
    if (kind == PictureKind::png) {
        const Result<cv::Size> whole = size_of_png(bytes, largest_px);
        if (!whole)
            return Error{whole.error()};
        const Result<cv::Mat> picture = shrunk_while_decoded(bytes, *whole, shrink_to_fill(*whole, box));
        return picture ? Result<cv::Mat>(resized(*picture, fitted(*whole, box))) : picture;
    }
    if (kind == PictureKind::webp && is_webp_cut_short(bytes))
        return Error{"The WebP file is cut short: a part of the picture is missing."};
    if (auto objection = objection_to_size(metadata.width, metadata.height, kind, largest_px);
        !objection.empty())
        return Error{objection};
    return decode_by_opencv(bytes, kind);
}

/// Undoes an EXIF orientation (EXIF 2.32, tag 0x0112): which edges of the stored picture are top and left.
cv::Mat upright(const cv::Mat& stored, int orientation) {
    cv::Mat turned = stored;
    if (orientation >= 5)
        cv::transpose(stored, turned);
    constexpr int both = -1, across = 1, down = 0;
    switch (orientation) {
    case 2:
    case 6:
        cv::flip(turned, turned, across);
        break;
    case 3:
    case 7:
        cv::flip(turned, turned, both);
        break;
    case 4:
    case 8:
        cv::flip(turned, turned, down);
        break;
    default:
        break;
    }
    return turned;
}

/// A file's bytes, and how they are to be read.
struct StoredPicture {
    const Bytes& bytes;
    PictureKind kind;
    PictureMetadata metadata;
    int orientation; ///< EXIF's, still to be undone
};

/// How the bytes of one picture are to be read; `turned_by` where they do not say themselves how they are
/// turned.
StoredPicture stored_picture(const Bytes& bytes, PictureKind kind, int turned_by = 1) {
    if (is_heif(kind)) // whose boxes say both, and libheif turns it by itself
        return {bytes, kind, {}, 1};
    const PictureMetadata metadata = metadata_of(bytes);
    // OpenCV turns a TIFF by itself.
    return {bytes, kind, metadata, kind == PictureKind::tiff ? 1 : metadata.orientation.value_or(turned_by)};
}

/// What `look` makes of the largest picture in a raw file of which it can make anything.
template <typename Value, typename Look>
Result<Value> looked_at_raw(const Bytes& raw, Look look) {
    Result<Value> result = Error{"The raw file holds no preview that can be read: save the picture as JPEG."};
    look_at_previews(raw, [&](const RawPreview& preview) {
        const PictureKind kind = kind_of(preview.bytes);
        if (kind != PictureKind::raw && kind != PictureKind::unknown)
            if (Result<Value> seen = look(stored_picture(preview.bytes, kind, preview.orientation)))
                result = std::move(seen);
        return result.ok();
    });
    return result;
}

/// What `look` makes of the bytes; anything thrown becomes a sentence.
template <typename Value, typename Look>
Result<Value> looked_at(const Bytes& bytes, Look look) {
    try {
        quiet_opencv();
        const PictureKind kind = kind_of(bytes);
        if (kind == PictureKind::unknown)
            return Error{"The file is not a picture of a kind that can be read."};
        return kind == PictureKind::raw ? looked_at_raw<Value>(bytes, look)
                                        : look(stored_picture(bytes, kind));
    } catch (const std::bad_alloc&) {
        return no_memory();
    } catch (const std::exception&) {
        return Error{"The picture cannot be decoded."};
    }
}

cv::Size across(cv::Size size, int orientation) {
    return orientation >= 5 ? cv::Size(size.height, size.width) : size;
}

/// Upright, and as small as it fits into `box`.
auto to_fit(cv::Size box, double largest_px) {
    return [box, largest_px](const StoredPicture& stored) {
        const cv::Size stored_box = across(box, stored.orientation);
        const Result<cv::Mat> picture =
            decode(stored.bytes, stored.kind, stored.metadata, largest_px, stored_box);
        return picture ? Result<cv::Mat>(upright(shrunk_to_fit(*picture, stored_box), stored.orientation))
                       : picture;
    };
}

/// The most by which a picture may be shrunk so that its longest side keeps `longest_px`. Where it is turned
/// afterwards, a part of a pixel that is left out at an edge would be missing at the wrong end.
int even_shrink(cv::Size size, int longest_px, bool turned_afterwards) {
    for (const int shrink : {8, 4, 2})
        if (std::max(size.width, size.height) / shrink >= longest_px &&
            (!turned_afterwards || (size.width % shrink == 0 && size.height % shrink == 0)))
            return shrink;
    return 1;
}

Result<ShrunkPicture> not_shrunk(const StoredPicture& stored) {
    Result<cv::Mat> whole = to_fit(no_box(), largest_picture_px)(stored);
    return whole ? Result<ShrunkPicture>(ShrunkPicture{*whole, whole->size(), 1, {}}) : Error{whole.error()};
}

Result<ShrunkPicture> shrunk_jpeg(const StoredPicture& stored, int longest_px) {
    const JpegHeader header = jpeg_header(stored.bytes);
    const cv::Size whole(header.width, header.height);
    const int shrink = even_shrink(whole, longest_px, stored.orientation != 1);
    if (shrink == 1)
        return not_shrunk(stored);
    if (auto objection = objection_to_size(header.width, header.height, stored.kind, largest_picture_px);
        !objection.empty())
        return Error{objection};
    const Result<cv::Mat> pixels = decode_jpeg(stored.bytes, header, shrink);
    if (!pixels)
        return Error{pixels.error()};
    return ShrunkPicture{upright(*pixels, stored.orientation), across(whole, stored.orientation), shrink, {}};
}

Result<cv::Mat> all_of(const HeifPixels& pixels) {
    try {
        return pixels.bgr();
    } catch (const std::exception&) {
        return no_memory();
    }
}

/// All pixels are decoded, and kept as they were decoded; what is spared is what comes after that.
Result<ShrunkPicture> shrunk_heif(const StoredPicture& stored, int longest_px) {
    const Result<HeifPicture> picture = open_heif(stored.bytes, stored.kind, largest_picture_px);
    if (!picture)
        return Error{picture.error()};
    const Result<HeifPixels> pixels = picture->decode(picture->size());
    if (!pixels)
        return Error{pixels.error()};
    const int shrink = even_shrink(pixels->size(), longest_px, false);
    if (shrink == 1)
        return ShrunkPicture{pixels->bgr(), pixels->size(), 1, {}};
    return ShrunkPicture{pixels->bgr(shrink), pixels->size(), shrink,
                         [all = *pixels] { return all_of(all); }};
}

Result<ShrunkPicture> shrunk_png(const StoredPicture& stored, int longest_px) {
    const Result<cv::Size> whole = size_of_png(stored.bytes, largest_picture_px);
    if (!whole)
        return Error{whole.error()};
    const int shrink = even_shrink(*whole, longest_px, stored.orientation != 1);
    const Result<cv::Mat> pixels = shrunk_while_decoded(stored.bytes, *whole, shrink);
    if (!pixels)
        return Error{pixels.error()};
    return ShrunkPicture{
        upright(*pixels, stored.orientation), across(*whole, stored.orientation), shrink, {}};
}

Result<ShrunkPicture> shrunk_upright(const StoredPicture& stored, int longest_px) {
    if (is_heif(stored.kind))
        return shrunk_heif(stored, longest_px);
    if (stored.kind == PictureKind::png)
        return shrunk_png(stored, longest_px);
    return stored.kind == PictureKind::jpeg ? shrunk_jpeg(stored, longest_px) : not_shrunk(stored);
}

} // namespace

Error no_memory() { return {"There is not enough memory for this picture."}; }

Result<cv::Mat> decoded_to_fit(const Bytes& bytes, cv::Size box, double largest_px) {
    return looked_at<cv::Mat>(bytes, to_fit(box, largest_px));
}

Result<ShrunkPicture> decoded_shrunk(const Bytes& bytes, int longest_px) {
    return looked_at<ShrunkPicture>(
        bytes, [longest_px](const StoredPicture& stored) { return shrunk_upright(stored, longest_px); });
}

} // namespace tp
