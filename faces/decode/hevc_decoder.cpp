// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/hevc_decoder.hpp"

#include "faces/decode/libavcodec.hpp"
#include "faces/decode/libheif.hpp"
#include "faces/decode/planes_to_rgb.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <optional>

namespace tp {
namespace {

constexpr int hevc_priority = 200; ///< libde265's is 100
constexpr std::int64_t most_hevc_px =
    210'000'000;                        ///< a picture's, with what fills up its blocks; picture.hpp's most
constexpr std::size_t length_bytes = 4; ///< before each of the units that libheif hands over
constexpr const char* refusal = "libavcodec_refuses";

// Why aligned: cmake/Compiler.cmake, mold.
alignas(64) thread_local int without_hevc_decoder = 0;
alignas(64) thread_local std::optional<int> rgb_by_matrix;

heif_error no_heif_error() { return {heif_error_Ok, heif_suberror_Unspecified, "Success"}; }
heif_error hevc_refused() { return {heif_error_Decoder_plugin_error, heif_suberror_Unspecified, refusal}; }

/// The bytes of one picture, as they come in.
struct CodedHevc {
    AVPacket* packet = load_libavcodec()->av_packet_alloc();

    CodedHevc() = default;
    CodedHevc(const CodedHevc&) = delete;
    CodedHevc& operator=(const CodedHevc&) = delete;
    ~CodedHevc() { load_libavcodec()->av_packet_free(&packet); }
};

/// Whether `data` is units, each behind its length, and nothing else.
bool are_whole_units(const std::uint8_t* data, std::size_t size) {
    while (size > 0) {
        if (size < length_bytes)
            return false;
        const std::size_t unit = static_cast<std::size_t>(data[0]) << 24 |
                                 static_cast<std::size_t>(data[1]) << 16 |
                                 static_cast<std::size_t>(data[2]) << 8 | data[3];
        if (unit > size - length_bytes)
            return false;
        data += length_bytes + unit;
        size -= length_bytes + unit;
    }
    return true;
}

/// An HEVCDecoderConfigurationRecord (ISO/IEC 14496-15) that says how long the lengths are, and nothing else:
/// the parameter sets come with the picture.
bool says_lengths(AVCodecContext& context) {
    constexpr int record = 23, version = 0, length_size_minus_1 = 21;
    context.extradata =
        static_cast<std::uint8_t*>(load_libavcodec()->av_mallocz(record + AV_INPUT_BUFFER_PADDING_SIZE));
    if (context.extradata == nullptr)
        return false;
    context.extradata_size = record;
    context.extradata[version] = 1;
    context.extradata[length_size_minus_1] = length_bytes - 1;
    return true;
}

using Frame = std::unique_ptr<AVFrame, void (*)(AVFrame*)>;

Frame decoded_frame(const AVPacket& coded) {
    const LibAvCodec& av = *load_libavcodec();
    const AVCodec* const codec = av.avcodec_find_decoder(AV_CODEC_ID_HEVC);
    const std::unique_ptr<AVCodecContext, void (*)(AVCodecContext*)> context(
        av.avcodec_alloc_context3(codec),
        [](AVCodecContext* mine) { load_libavcodec()->avcodec_free_context(&mine); });
    Frame frame(av.av_frame_alloc(), [](AVFrame* mine) { load_libavcodec()->av_frame_free(&mine); });
    if (context == nullptr || frame == nullptr || !says_lengths(*context))
        return {nullptr, frame.get_deleter()};
    context->thread_count = 1;
    context->flags |= AV_CODEC_FLAG_UNALIGNED; // crops to the pixel
    context->err_recognition |= AV_EF_EXPLODE;
    context->max_pixels = most_hevc_px;
    const bool decoded = av.avcodec_open2(context.get(), codec, nullptr) == 0 &&
                         av.avcodec_send_packet(context.get(), &coded) == 0 &&
                         av.avcodec_send_packet(context.get(), nullptr) == 0 &&
                         av.avcodec_receive_frame(context.get(), frame.get()) == 0;
    return decoded ? std::move(frame) : Frame(nullptr, frame.get_deleter());
}

/// How a frame's values lie: one plane for each, of 8 bits or of 16 with `bits` of them used.
struct PlaneFormat {
    int planes, bits;
    int chroma_right, chroma_down; ///< chroma is halved so often
    heif_chroma chroma;
};

/// None where libheif has no such format; `planes` is 0 then.
PlaneFormat plane_format(const AVFrame& frame) {
    const AVPixFmtDescriptor* const about =
        load_libavcodec()->av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
    constexpr std::uint64_t others =
        AV_PIX_FMT_FLAG_HWACCEL | AV_PIX_FMT_FLAG_BE | AV_PIX_FMT_FLAG_PAL | AV_PIX_FMT_FLAG_BITSTREAM;
    if (about == nullptr || (about->flags & others) != 0)
        return {};
    PlaneFormat format{about->nb_components, about->comp[0].depth, 0, 0, heif_chroma_monochrome};
    if (format.planes == 3) {
        format.chroma_right = about->log2_chroma_w;
        format.chroma_down = about->log2_chroma_h;
        format.chroma = format.chroma_right == 0  ? heif_chroma_444
                        : format.chroma_down == 0 ? heif_chroma_422
                                                  : heif_chroma_420;
    }
    const bool known = (format.planes == 1 || format.planes == 3) && format.bits >= 8 && format.bits <= 16 &&
                       format.chroma_right <= 1 && format.chroma_down <= format.chroma_right;
    return known ? format : PlaneFormat{};
}

constexpr std::array<heif_channel, 3> heif_planes{heif_channel_Y, heif_channel_Cb, heif_channel_Cr};

heif_error copy_plane(const AVFrame& frame, const PlaneFormat& format, std::size_t which, heif_image& to) {
    const LibHeif& heif = *load_libheif();
    const int right = which > 0 ? format.chroma_right : 0, down = which > 0 ? format.chroma_down : 0;
    const int width = (frame.width + right) >> right, height = (frame.height + down) >> down;
    if (const heif_error error =
            heif.heif_image_add_plane(&to, heif_planes[which], width, height, format.bits);
        error.code != heif_error_Ok)
        return error;
    int step = 0;
    std::uint8_t* const out = heif.heif_image_get_plane(&to, heif_planes[which], &step);
    if (out == nullptr)
        return hevc_refused();
    const std::size_t row = static_cast<std::size_t>(width) * (format.bits > 8 ? 2 : 1);
    for (std::ptrdiff_t y = 0; y < height; ++y)
        std::memcpy(out + y * step, frame.data[which] + y * frame.linesize[which], row);
    return no_heif_error();
}

/// What the stream says of its colours; what the file's boxes say comes before it, as libheif sees to.
void tell_colours(const AVFrame& frame, heif_image& image) {
    const LibHeif& heif = *load_libheif();
    const std::unique_ptr<heif_color_profile_nclx, decltype(heif.heif_nclx_color_profile_free)> colours(
        heif.heif_nclx_color_profile_alloc(), heif.heif_nclx_color_profile_free);
    if (colours == nullptr)
        return;
    // A number that libheif does not know leaves "unspecified" there.
    heif.heif_nclx_color_profile_set_color_primaries(colours.get(),
                                                     static_cast<std::uint16_t>(frame.color_primaries));
    heif.heif_nclx_color_profile_set_transfer_characteristics(colours.get(),
                                                              static_cast<std::uint16_t>(frame.color_trc));
    heif.heif_nclx_color_profile_set_matrix_coefficients(colours.get(),
                                                         static_cast<std::uint16_t>(frame.colorspace));
    colours->full_range_flag = frame.color_range == AVCOL_RANGE_JPEG;
    heif.heif_image_set_nclx_color_profile(&image, colours.get());
}

heif_error heif_image_of(const AVFrame& frame, heif_image** out) {
    const PlaneFormat format = plane_format(frame);
    if (format.planes == 0)
        return hevc_refused();
    const LibHeif& heif = *load_libheif();
    heif_image* image = nullptr;
    if (const heif_error error = heif.heif_image_create(
            frame.width, frame.height,
            format.planes == 1 ? heif_colorspace_monochrome : heif_colorspace_YCbCr, format.chroma, &image);
        error.code != heif_error_Ok)
        return error;
    for (std::size_t plane = 0; plane < static_cast<std::size_t>(format.planes); ++plane)
        if (const heif_error error = copy_plane(frame, format, plane, *image); error.code != heif_error_Ok) {
            heif.heif_image_release(image);
            return hevc_refused(); // and not `error`, whose message may have been the image's
        }
    tell_colours(frame, *image);
    *out = image;
    return no_heif_error();
}

/// Whether a frame's values are those that `to_rgb` knows.
bool is_as_phones_write(const AVFrame& frame, const PlaneFormat& format) {
    return format.planes == 3 && format.bits == 8 && format.chroma == heif_chroma_420 &&
           frame.color_range == AVCOL_RANGE_JPEG;
}

/// None where it cannot be made.
heif_error rgb_image_of(const AVFrame& frame, const ColourShares& shares, heif_image** out) {
    const LibHeif& heif = *load_libheif();
    heif_image* image = nullptr;
    if (heif.heif_image_create(frame.width, frame.height, heif_colorspace_RGB, heif_chroma_444, &image)
            .code != heif_error_Ok)
        return hevc_refused();
    constexpr std::array<heif_channel, 3> colours{heif_channel_R, heif_channel_G, heif_channel_B};
    std::array<ReadPlane, 3> coded{};
    std::array<WrittenPlane, 3> rgb{};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        int step = 0;
        if (heif.heif_image_add_plane(image, colours[i], frame.width, frame.height, 8).code == heif_error_Ok)
            rgb[i].values = heif.heif_image_get_plane(image, colours[i], &step);
        if (rgb[i].values == nullptr) {
            heif.heif_image_release(image);
            return hevc_refused();
        }
        rgb[i].step = step;
        coded[i] = {frame.data[i], frame.linesize[i]};
    }
    to_rgb(coded, frame.width, frame.height, shares, rgb);
    *out = image;
    return no_heif_error();
}

heif_error new_hevc(void** out) {
    auto coded = std::unique_ptr<CodedHevc>(new (std::nothrow) CodedHevc);
    if (coded == nullptr || coded->packet == nullptr)
        return {heif_error_Memory_allocation_error, heif_suberror_Unspecified, "no_memory"};
    *out = coded.release();
    return no_heif_error();
}

heif_error push_hevc(void* coded, const void* data, std::size_t size) {
    AVPacket& packet = *static_cast<CodedHevc*>(coded)->packet;
    if (!are_whole_units(static_cast<const std::uint8_t*>(data), size))
        return {heif_error_Decoder_plugin_error, heif_suberror_End_of_data, "cut_short"};
    if (size == 0)
        return no_heif_error();
    const auto before = static_cast<std::size_t>(packet.size);
    if (size > static_cast<std::size_t>(std::numeric_limits<int>::max()) - before ||
        load_libavcodec()->av_grow_packet(&packet, static_cast<int>(size)) < 0)
        return hevc_refused();
    std::memcpy(packet.data + before, data, size);
    return no_heif_error();
}

heif_error decode_hevc(void* coded, heif_image** out) {
    const Frame frame = decoded_frame(*static_cast<CodedHevc*>(coded)->packet);
    if (frame == nullptr)
        return hevc_refused();
    if (rgb_by_matrix && is_as_phones_write(*frame, plane_format(*frame))) {
        const bool by_stream = *rgb_by_matrix == HevcAsRgb::as_the_stream_says;
        if (const auto shares = colour_shares(by_stream ? frame->colorspace : *rgb_by_matrix))
            return rgb_image_of(*frame, *shares, out);
    }
    return heif_image_of(*frame, out);
}

int hevc_priority_for(heif_compression_format format) {
    if (format != heif_compression_HEVC || without_hevc_decoder > 0)
        return 0;
    const LibAvCodec* const av = load_libavcodec();
    return av != nullptr && av->avcodec_find_decoder(AV_CODEC_ID_HEVC) != nullptr ? hevc_priority : 0;
}

#if defined(heif_decoder_plugin_latest_version) && heif_decoder_plugin_latest_version >= 5
constexpr int interface_version = 5;

/// What libheif calls from 1.21 on, where it takes no older interface.
void add_what_is_called_since(heif_decoder_plugin& plugin) {
    plugin.does_support_format2 = [](const heif_decoder_plugin_compressed_format_description* format) {
        return hevc_priority_for(format->format);
    };
    plugin.new_decoder2 = [](void** coded, const heif_decoder_plugin_options*) { return new_hevc(coded); };
    plugin.push_data2 = [](void* coded, const void* data, std::size_t size, std::uintptr_t) {
        return push_hevc(coded, data, size);
    };
    plugin.flush_data = [](void*) { return no_heif_error(); };
    plugin.decode_next_image2 = [](void* coded, heif_image** out, std::uintptr_t* of_pushed,
                                   const heif_security_limits*) {
        if (of_pushed != nullptr)
            *of_pushed = 0;
        return decode_hevc(coded, out);
    };
}
#else
constexpr int interface_version = 3;
void add_what_is_called_since(heif_decoder_plugin&) {}
#endif

heif_decoder_plugin described() {
    heif_decoder_plugin plugin{};
    plugin.plugin_api_version = interface_version;
    plugin.get_plugin_name = [] { return "FFmpeg's libavcodec"; };
    plugin.does_support_format = hevc_priority_for;
    plugin.new_decoder = new_hevc;
    plugin.free_decoder = [](void* coded) { delete static_cast<CodedHevc*>(coded); };
    plugin.push_data = push_hevc;
    plugin.decode_image = decode_hevc;
    plugin.set_strict_decoding = [](void*, int) {}; // it is always strict
    plugin.id_name = "touchphoto_libavcodec";
    add_what_is_called_since(plugin);
    return plugin;
}

} // namespace

const heif_decoder_plugin& hevc_decoder() {
    static const heif_decoder_plugin plugin = described();
    return plugin;
}

HevcAsRgb::HevcAsRgb(std::optional<int> matrix) { rgb_by_matrix = matrix; }
HevcAsRgb::~HevcAsRgb() { rgb_by_matrix = std::nullopt; }

std::optional<int> HevcAsRgb::matrix_of(std::string_view bytes) {
    constexpr std::string_view box = "colrnclx"; // ISO/IEC 14496-12, 12.1.5
    constexpr std::size_t matrix = 4, range = 6, said_bytes = 7;
    std::string_view said;
    for (std::size_t at = bytes.find(box); at != bytes.npos; at = bytes.find(box, at + 1)) {
        const std::string_view here = bytes.substr(at + box.size(), said_bytes);
        if (here.size() < said_bytes || (!said.empty() && here != said))
            return std::nullopt;
        said = here;
    }
    if (said.empty())
        return as_the_stream_says;
    const auto byte = [said](std::size_t at) { return static_cast<unsigned char>(said[at]); };
    return byte(range) >= 0x80 ? std::optional<int>(byte(matrix) << 8 | byte(matrix + 1)) : std::nullopt;
}

bool is_hevc_refused(const char* message) {
    return message != nullptr && std::strstr(message, refusal) != nullptr;
}

WithoutHevcDecoder::WithoutHevcDecoder() { ++without_hevc_decoder; }
WithoutHevcDecoder::~WithoutHevcDecoder() { --without_hevc_decoder; }

} // namespace tp
