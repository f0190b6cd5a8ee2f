// SPDX-License-Identifier: Apache-2.0
#include "audio/video/video_film.hpp"

#include "audio/video/video_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace tp {

namespace {

constexpr double without_clock_s = 1.0 / 25.0; ///< between two pictures that have no time
constexpr std::uint8_t no_colour = 128;

bool is_a_film_s(AVCodecID codec) {
    constexpr std::array<AVCodecID, 4> known{AV_CODEC_ID_H264, AV_CODEC_ID_HEVC, AV_CODEC_ID_MPEG4,
                                             AV_CODEC_ID_MJPEG};
    return std::find(known.begin(), known.end(), codec) != known.end();
}

/// How the values of a frame lie; null where it is another way than one plane for each.
const AVPixFmtDescriptor* form_of(const AVFrame& frame) {
    const AVPixFmtDescriptor* const about =
        VideoFile::av().av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
    constexpr std::uint64_t others = AV_PIX_FMT_FLAG_HWACCEL | AV_PIX_FMT_FLAG_BE | AV_PIX_FMT_FLAG_PAL |
                                     AV_PIX_FMT_FLAG_BITSTREAM | AV_PIX_FMT_FLAG_RGB;
    if (about == nullptr || (about->flags & others) != 0 || about->comp[0].depth < 8 ||
        about->comp[0].depth > 16 || about->log2_chroma_w > 1 || about->log2_chroma_h > 1)
        return nullptr;
    const bool planes = about->nb_components >= 3 && (about->flags & AV_PIX_FMT_FLAG_PLANAR) != 0 &&
                        about->comp[1].plane == 1 && about->comp[2].plane == 2;
    return planes || about->nb_components == 1 ? about : nullptr;
}

bool is_full_range(const AVFrame& frame) {
    return frame.color_range == AVCOL_RANGE_JPEG || frame.format == AV_PIX_FMT_YUVJ420P ||
           frame.format == AV_PIX_FMT_YUVJ422P || frame.format == AV_PIX_FMT_YUVJ444P;
}

/// One plane as 8 bit, `width` by `height` of it: every `right`th value of every `down`th row.
struct PlaneWay {
    std::size_t plane;
    int width, height;
    int right, down;
    int span; ///< of television's range
};

void put_plane(const AVFrame& frame, int depth, const PlaneWay& way, std::vector<std::uint8_t>& to) {
    const bool stretched = is_full_range(frame);
    const auto put = [&](int value) {
        to.push_back(static_cast<std::uint8_t>(stretched ? 16 + (value * way.span + 127) / 255 : value));
    };
    for (int y = 0; y < way.height; ++y) {
        const std::uint8_t* const row =
            frame.data[way.plane] + static_cast<std::ptrdiff_t>(y) * way.down * frame.linesize[way.plane];
        if (depth == 8)
            for (int x = 0; x < way.width; ++x)
                put(row[x * way.right]);
        else
            for (int x = 0; x < way.width; ++x)
                put(reinterpret_cast<const std::uint16_t*>(row)[x * way.right] >> (depth - 8) & 0xFF);
    }
}

/// Empty where it has no such picture.
std::vector<std::uint8_t> planes_of(const AVFrame& frame, int width, int height) {
    const AVPixFmtDescriptor* const form = form_of(frame);
    std::vector<std::uint8_t> planes;
    if (form == nullptr || frame.data[0] == nullptr)
        return planes;
    planes.reserve(film_bytes(width, height));
    put_plane(frame, form->comp[0].depth, {0, width, height, 1, 1, 219}, planes);
    for (std::size_t colour = 1; colour <= 2 && form->nb_components > 1; ++colour)
        put_plane(frame, form->comp[0].depth,
                  {colour, width / 2, height / 2, 2 >> form->log2_chroma_w, 2 >> form->log2_chroma_h, 224},
                  planes);
    planes.resize(film_bytes(width, height), no_colour);
    return planes;
}

/// Nine numbers that say how the stream's pictures are turned. Null where it does not say.
const std::uint8_t* display_matrix(const AVStream& stream) {
    constexpr std::size_t whole = 9 * sizeof(std::int32_t);
#if LIBAVFORMAT_VERSION_MAJOR >= 61
    const AVCodecParameters& said = *stream.codecpar;
    const AVPacketSideData* const matrix = VideoFile::av().av_packet_side_data_get(
        said.coded_side_data, said.nb_coded_side_data, AV_PKT_DATA_DISPLAYMATRIX);
    return matrix != nullptr && matrix->size >= whole ? matrix->data : nullptr;
#else
    std::size_t size = 0;
    const std::uint8_t* const matrix =
        VideoFile::av().av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, &size);
    return size >= whole ? matrix : nullptr;
#endif
}

int turn_of(const AVStream& stream) {
    const std::uint8_t* const matrix = display_matrix(stream);
    if (matrix == nullptr)
        return 0;
    const double anticlockwise =
        VideoFile::av().av_display_rotation_get(reinterpret_cast<const std::int32_t*>(matrix));
    if (!std::isfinite(anticlockwise))
        return 0;
    const auto quarters = static_cast<int>(std::lround(-anticlockwise / 90.0));
    return (quarters % 4 + 4) % 4 * 90;
}

} // namespace

struct VideoFilm::Impl {
    explicit Impl(std::unique_ptr<ByteSource> bytes) : file(std::move(bytes)) {}

    VideoFile file;
    double last_s = -without_clock_s;
    std::optional<FilmPicture> first; ///< decoded and not yet asked for

    std::string open() {
        if (std::string problem = file.find(AVMEDIA_TYPE_VIDEO, "it has no pictures."); !problem.empty())
            return problem;
        if (!is_a_film_s(file.codec()) || VideoFile::av().avcodec_find_decoder(file.codec()) == nullptr)
            return std::string("its pictures are of a kind that cannot be decoded here (") +
                   VideoFile::av().avcodec_get_name(file.codec()) + ").";
        if (!file.open_decoder(most_film_px))
            return "its pictures cannot be decoded.";
        first = decoded(0.0);
        return first ? std::string() : "nothing of its pictures can be decoded.";
    }

    double time_of_frame() {
        const std::int64_t stamp = file.frame().best_effort_timestamp;
        const AVRational base = file.stream().time_base;
        const double time_s = stamp == AV_NOPTS_VALUE || base.den <= 0
                                  ? last_s + without_clock_s
                                  : static_cast<double>(stamp) * base.num / base.den;
        return last_s = std::max(time_s, last_s);
    }

    std::optional<FilmPicture> decoded(double from_s) {
        while (file.next_frame()) {
            FilmPicture picture;
            picture.time_s = time_of_frame();
            picture.width = file.frame().width / 2 * 2;
            picture.height = file.frame().height / 2 * 2;
            if (picture.time_s < from_s || picture.width <= 0 || picture.height <= 0 ||
                std::max(picture.width, picture.height) > longest_film_side)
                continue;
            picture.turn_deg = turn_of(file.stream());
            picture.planes = planes_of(file.frame(), picture.width, picture.height);
            if (!picture.planes.empty())
                return picture;
        }
        return std::nullopt;
    }
};

VideoFilm::VideoFilm(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VideoFilm::VideoFilm(VideoFilm&&) noexcept = default;
VideoFilm::~VideoFilm() = default;

Result<VideoFilm> VideoFilm::open(std::unique_ptr<ByteSource> video) {
    if (std::string missing = VideoFile::ready(); !missing.empty())
        return Error{missing};
    auto impl = std::make_unique<Impl>(std::move(video));
    const std::string problem = impl->open();
    return problem.empty() ? Result<VideoFilm>(VideoFilm(std::move(impl))) : Error{problem};
}

std::optional<FilmPicture> VideoFilm::next(double from_s) {
    if (auto first = std::exchange(impl_->first, {}); first && first->time_s >= from_s)
        return first;
    return impl_->decoded(from_s);
}

} // namespace tp
