// SPDX-License-Identifier: Apache-2.0
#include "audio/video/video_sound.hpp"

#include "audio/recordings/sound_format.hpp"
#include "audio/video/video_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tp {

namespace {

/// What cameras and telephones write beside their pictures. FFmpeg knows hundreds more, whose readers nobody
/// needs here.
bool is_a_camera_s(AVCodecID codec) {
    constexpr std::array<AVCodecID, 16> known{
        AV_CODEC_ID_AAC,       AV_CODEC_ID_ALAC,      AV_CODEC_ID_MP3,       AV_CODEC_ID_OPUS,
        AV_CODEC_ID_AC3,       AV_CODEC_ID_EAC3,      AV_CODEC_ID_AMR_NB,    AV_CODEC_ID_AMR_WB,
        AV_CODEC_ID_PCM_S16LE, AV_CODEC_ID_PCM_S16BE, AV_CODEC_ID_PCM_S24LE, AV_CODEC_ID_PCM_S24BE,
        AV_CODEC_ID_PCM_U8,    AV_CODEC_ID_PCM_ALAW,  AV_CODEC_ID_PCM_MULAW, AV_CODEC_ID_ADPCM_IMA_QT};
    return std::find(known.begin(), known.end(), codec) != known.end();
}

/// A sample in full scale ±2³¹, of which `depth` says how many bits are kept.
std::int32_t sample_of(const AVFrame& frame, int channel, int number, SampleDepth depth) {
    const auto format = static_cast<AVSampleFormat>(frame.format);
    const bool planar = VideoFile::av().av_sample_fmt_is_planar(format) != 0;
    const std::uint8_t* bytes = planar ? frame.extended_data[channel] : frame.extended_data[0];
    const std::ptrdiff_t at =
        planar ? number : static_cast<std::ptrdiff_t>(number) * frame.ch_layout.nb_channels + channel;
    const auto rounded = [&](double value) {
        const double scale = std::ldexp(1.0, static_cast<int>(depth) - 1);
        const double sample = std::isfinite(value) ? std::clamp(value * scale, -scale, scale - 1.0) : 0.0;
        return static_cast<std::int32_t>(std::lrint(sample)) << (32 - static_cast<int>(depth));
    };
    switch (VideoFile::av().av_get_packed_sample_fmt(format)) {
    case AV_SAMPLE_FMT_U8:
        return (static_cast<std::int32_t>(bytes[at]) - 128) << 24;
    case AV_SAMPLE_FMT_S16:
        return static_cast<std::int32_t>(reinterpret_cast<const std::int16_t*>(bytes)[at]) << 16;
    case AV_SAMPLE_FMT_S32:
        return reinterpret_cast<const std::int32_t*>(bytes)[at] & ~0xFF;
    case AV_SAMPLE_FMT_FLT:
        return rounded(static_cast<double>(reinterpret_cast<const float*>(bytes)[at]));
    case AV_SAMPLE_FMT_DBL:
        return rounded(reinterpret_cast<const double*>(bytes)[at]);
    default:
        return 0;
    }
}

SampleDepth depth_of(int format) {
    return VideoFile::av().av_get_packed_sample_fmt(static_cast<AVSampleFormat>(format)) == AV_SAMPLE_FMT_S32
               ? SampleDepth::bits_24
               : SampleDepth::bits_16;
}

} // namespace

struct VideoSound::Impl {
    explicit Impl(std::unique_ptr<ByteSource> bytes) : file(std::move(bytes)) {}

    VideoFile file;
    int sample_format = -1;
    SoundFormat format;
    SampleDepth depth = SampleDepth::bits_16;
    std::vector<std::int32_t> held; ///< decoded and not yet read
    std::size_t held_from = 0;

    std::string open() {
        if (std::string problem = file.find(AVMEDIA_TYPE_AUDIO, "it has no sound."); !problem.empty())
            return problem;
        if (!is_a_camera_s(file.codec()) || VideoFile::av().avcodec_find_decoder(file.codec()) == nullptr)
            return std::string("its sound is of a kind that cannot be decoded here (") +
                   VideoFile::av().avcodec_get_name(file.codec()) + ").";
        return file.open_decoder(0) ? begin() : "its sound cannot be decoded.";
    }

    /// The first samples tell what a damaged head may not.
    std::string begin() {
        if (!next_frame())
            return "nothing of its sound can be decoded.";
        format = {file.frame().sample_rate, file.frame().ch_layout.nb_channels};
        sample_format = file.frame().format;
        depth = depth_of(file.frame().format);
        if (format.channels < 1 || format.channels > most_video_channels)
            return "its sound has " + std::to_string(format.channels) + " channels; at most " +
                   std::to_string(most_video_channels) + " can be read.";
        if (format.rate < lowest_video_rate || format.rate > highest_video_rate)
            return "recordings do not have its sample rate.";
        hold();
        return {};
    }

    /// The next frame with samples; false at the end.
    bool next_frame() {
        while (file.next_frame())
            if (file.frame().nb_samples > 0)
                return true;
        return false;
    }

    void hold() {
        held.clear();
        held_from = 0;
        for (int i = 0; i < file.frame().nb_samples; ++i)
            for (int channel = 0; channel < format.channels; ++channel)
                held.push_back(sample_of(file.frame(), channel, i, depth));
    }

    /// Whether there is more to read; a sound that changes its format midway ends there.
    bool hold_more() {
        if (!next_frame())
            return false;
        if (file.frame().sample_rate != format.rate ||
            file.frame().ch_layout.nb_channels != format.channels || file.frame().format != sample_format)
            return false;
        hold();
        return true;
    }
};

VideoSound::VideoSound(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VideoSound::VideoSound(VideoSound&&) noexcept = default;
VideoSound::~VideoSound() = default;

Result<VideoSound> VideoSound::open(std::unique_ptr<ByteSource> video) {
    if (std::string missing = VideoFile::ready(); !missing.empty())
        return Error{missing};
    auto impl = std::make_unique<Impl>(std::move(video));
    const std::string problem = impl->open();
    return problem.empty() ? Result<VideoSound>(VideoSound(std::move(impl))) : Error{problem};
}

SoundFormat VideoSound::format() const { return impl_->format; }

SampleDepth VideoSound::depth() const { return impl_->depth; }

std::uint64_t VideoSound::frames() const {
    const AVStream& stream = impl_->file.stream();
    const std::int64_t most = static_cast<std::int64_t>(longest_recording_s) * impl_->format.rate;
    if (stream.duration <= 0)
        return 0;
    const std::int64_t frames =
        VideoFile::av().av_rescale_q(stream.duration, stream.time_base, AVRational{1, impl_->format.rate});
    return static_cast<std::uint64_t>(std::clamp<std::int64_t>(frames, 0, most + 1));
}

std::size_t VideoSound::read(std::span<std::int32_t> to) {
    const auto channels = static_cast<std::size_t>(impl_->format.channels);
    const std::size_t wanted = to.size() / channels * channels;
    std::size_t done = 0;
    while (done < wanted) {
        if (impl_->held_from == impl_->held.size() && !impl_->hold_more())
            break;
        const std::size_t some = std::min(wanted - done, impl_->held.size() - impl_->held_from);
        std::copy_n(impl_->held.begin() + static_cast<std::ptrdiff_t>(impl_->held_from), some,
                    to.begin() + static_cast<std::ptrdiff_t>(done));
        impl_->held_from += some;
        done += some;
    }
    return done / channels;
}

} // namespace tp
