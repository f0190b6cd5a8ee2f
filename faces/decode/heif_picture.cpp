// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/heif_picture.hpp"

#include "faces/decode/hevc_decoder.hpp"
#include "faces/decode/libheif.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>

namespace tp {
namespace {

constexpr int most_thumbnails = 8; ///< that are looked at; phones write one

Error damaged(const std::string& format) { return {"The " + format + " file is damaged."}; }

/// What libheif's complaint means to a person.
Error sentence_of(const heif_error& error, const std::string& format) {
    if (error.subcode == heif_suberror_End_of_data)
        return Error{"The " + format + " file is cut short: a part of the picture is missing."};
    if (error.subcode == heif_suberror_Security_limit_exceeded)
        return Error{"The " + format +
                     " file says that it holds more than any photograph does; it was not read."};
    if (error.code == heif_error_Memory_allocation_error)
        return Error{"There is not enough memory for this picture."};
    if (error.code == heif_error_Unsupported_feature || error.code == heif_error_Unsupported_filetype)
        return Error{"The " + format +
                     " file holds a kind of picture that cannot be decoded here: save it as JPEG."};
    return damaged(format);
}

cv::Mat plane_of(const heif_image& image, heif_channel channel, int bits) {
    const LibHeif& heif = *load_libheif();
    int step = 0;
    const std::uint8_t* const data = heif.heif_image_get_plane_readonly(&image, channel, &step);
    const int width = heif.heif_image_get_width(&image, channel),
              height = heif.heif_image_get_height(&image, channel);
    if (data == nullptr || width <= 0 || height <= 0)
        return {};
    return cv::Mat(height, width, bits > 8 ? CV_16UC1 : CV_8UC1, const_cast<std::uint8_t*>(data),
                   static_cast<std::size_t>(step));
}

/// 8-bit, `shrink` times smaller.
cv::Mat reduced(const cv::Mat& plane, int bits, int shrink) {
    cv::Mat small = plane;
    if (shrink > 1) {
        const cv::Size size(plane.cols / shrink, plane.rows / shrink);
        cv::resize(plane(cv::Rect({0, 0}, size * shrink)), small, size, 0, 0, cv::INTER_AREA);
    }
    if (bits > 8)
        small.convertTo(small, CV_8U, 255.0 / ((1 << bits) - 1));
    return small;
}

} // namespace

std::optional<HeifPixels> HeifPixels::of(std::shared_ptr<const heif_image> image) {
    HeifPixels pixels;
    pixels.image_ = std::move(image);
    constexpr std::array<heif_channel, 3> channels{heif_channel_B, heif_channel_G, heif_channel_R};
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const int bits =
            load_libheif()->heif_image_get_bits_per_pixel_range(pixels.image_.get(), channels[i]);
        pixels.planes_[i] = plane_of(*pixels.image_, channels[i], bits);
        if (bits < 8 || bits > 16 || (i > 0 && bits != pixels.bits_) || pixels.planes_[i].empty() ||
            pixels.planes_[i].size() != pixels.size())
            return std::nullopt;
        pixels.bits_ = bits;
    }
    return pixels;
}

cv::Mat HeifPixels::bgr(int shrink) const {
    std::array<cv::Mat, 3> planes;
    std::transform(planes_.begin(), planes_.end(), planes.begin(),
                   [&](const cv::Mat& plane) { return reduced(plane, bits_, shrink); });
    cv::Mat picture;
    cv::merge(planes.data(), planes.size(), picture);
    return picture;
}

HeifPicture::HeifPicture(const char* format, std::shared_ptr<heif_context> context,
                         std::shared_ptr<const heif_image_handle> primary)
    : format_(format), context_(std::move(context)), primary_(std::move(primary)) {}

Result<HeifPicture> HeifPicture::open(const Bytes& bytes, const char* format) {
    const LibHeif* const heif = load_libheif();
    if (heif == nullptr)
        return Error{"Pictures in the formats HEIC and AVIF need the library libheif (Debian: libheif1), "
                     "which is not installed: install it or save the picture as JPEG."};
    std::shared_ptr<heif_context> context(heif->heif_context_alloc(), heif->heif_context_free);
    if (context == nullptr)
        return Error{"There is not enough memory for this picture."};
    if (const heif_error error = heif->heif_context_read_from_memory_without_copy(context.get(), bytes.data(),
                                                                                  bytes.size(), nullptr);
        error.code != heif_error_Ok)
        return sentence_of(error, format);
    heif_image_handle* primary = nullptr;
    if (const heif_error error = heif->heif_context_get_primary_image_handle(context.get(), &primary);
        error.code != heif_error_Ok)
        return sentence_of(error, format);
    HeifPicture picture(format, std::move(context), {primary, heif->heif_image_handle_release});
    picture.matrix_ = HevcAsRgb::matrix_of({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    // The canvas of tiles and of overlays is as large as their own data say, whatever size the picture is
    // said to have.
    const cv::Size stored = picture.stored_size();
    heif->heif_context_set_max_decoding_threads(picture.context_.get(), 0);
    heif->heif_context_set_maximum_image_size_limit(picture.context_.get(),
                                                    std::max(stored.width, stored.height) + 1);
    return picture;
}

void HeifPicture::decode_tiles_by(int threads) {
    load_libheif()->heif_context_set_max_decoding_threads(context_.get(), threads);
}

cv::Size HeifPicture::stored_size() const {
    const LibHeif& heif = *load_libheif();
    return {heif.heif_image_handle_get_ispe_width(primary_.get()),
            heif.heif_image_handle_get_ispe_height(primary_.get())};
}

cv::Size HeifPicture::size() const {
    const LibHeif& heif = *load_libheif();
    return {heif.heif_image_handle_get_width(primary_.get()),
            heif.heif_image_handle_get_height(primary_.get())};
}

std::shared_ptr<const heif_image_handle> HeifPicture::thumbnail(cv::Size least) const {
    const LibHeif& heif = *load_libheif();
    std::array<heif_item_id, most_thumbnails> ids{};
    const int count = std::min(most_thumbnails, heif.heif_image_handle_get_list_of_thumbnail_IDs(
                                                    primary_.get(), ids.data(), most_thumbnails));
    const cv::Size whole = size();
    for (int i = 0; i < count; ++i) {
        heif_image_handle* found = nullptr;
        if (heif.heif_image_handle_get_thumbnail(primary_.get(), ids[static_cast<std::size_t>(i)], &found)
                .code != heif_error_Ok)
            continue;
        std::shared_ptr<const heif_image_handle> small(found, heif.heif_image_handle_release);
        const cv::Size size(heif.heif_image_handle_get_width(found),
                            heif.heif_image_handle_get_height(found));
        const bool fills =
            size.width >= least.width && size.height >= least.height && size.area() < whole.area();
        // Sides are rounded to whole pixels, by some to even ones: as far as that, the shape is the picture's
        // own.
        const long long skew = static_cast<long long>(size.width) * whole.height -
                               static_cast<long long>(size.height) * whole.width;
        if (fills && std::llabs(skew) <= 2LL * std::max(whole.width, whole.height))
            return small;
    }
    return nullptr;
}

Result<std::shared_ptr<const heif_image>> HeifPicture::decoded_image(const heif_image_handle& picture) const {
    const LibHeif& heif = *load_libheif();
    const std::unique_ptr<heif_decoding_options, decltype(heif.heif_decoding_options_free)> options(
        heif.heif_decoding_options_alloc(), heif.heif_decoding_options_free);
    // dav1d, which libheif would take, is twice as fast, but writes to the terminal about a damaged file.
    options->decoder_id = "aom";
    heif_image* decoded = nullptr;
    const HevcAsRgb as_rgb(matrix_);
    // In planes, as libheif 1.15 decodes all pictures: what it converts them to costs another 50 ms at 12
    // megapixel.
    const auto decode = [&] {
        return heif.heif_decode_image(&picture, &decoded, heif_colorspace_RGB, heif_chroma_444, options.get());
    };
    heif_error error = decode();
    if (error.code == heif_error_Plugin_loading_error) { // newer versions take no other where it is not there
        options->decoder_id = nullptr;
        error = decode();
    }
    // Ours is refused too by a libheif that takes a later interface than it was built for.
    if (is_hevc_refused(error.message) || error.code == heif_error_Plugin_loading_error) {
        heif.heif_context_set_max_decoding_threads(context_.get(), 0); // so that this thread does all of it
        const WithoutHevcDecoder without;
        error = decode();
    }
    if (error.code != heif_error_Ok)
        return sentence_of(error, format_);
    return std::shared_ptr<const heif_image>(decoded, heif.heif_image_release);
}

Result<HeifPixels> HeifPicture::pixels_of(const heif_image_handle& picture) const {
    const Result<std::shared_ptr<const heif_image>> decoded = decoded_image(picture);
    if (!decoded)
        return Error{decoded.error()};
    const auto pixels = HeifPixels::of(*decoded);
    // Some encoders fill up to whole blocks and say so only here.
    const double most = (stored_size().width + 64.0) * (stored_size().height + 64.0);
    if (!pixels || static_cast<double>(pixels->size().width) * pixels->size().height > most)
        return damaged(format_);
    return *pixels;
}

Result<HeifPixels> HeifPicture::decode(cv::Size least) const {
    if (const auto small = thumbnail(least))
        if (Result<HeifPixels> pixels = pixels_of(*small))
            return pixels;
    return pixels_of(*primary_);
}

} // namespace tp
