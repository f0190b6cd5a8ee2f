// SPDX-License-Identifier: Apache-2.0
#include "audio/video/video_sound.hpp"

#include "audio/recordings/sound_format.hpp"
#include "audio/video/libav.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tp {

namespace {

/// Of a VideoSound, which is not made before they are loaded.
const LibAv& av() { return *load_libav(); }

constexpr std::size_t most_memory = std::size_t{256}
                                    << 20; // of one allocation; a minute's index needs a megabyte
constexpr int read_block = 1 << 15;

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
    const bool planar = av().av_sample_fmt_is_planar(format) != 0;
    const std::uint8_t* bytes = planar ? frame.extended_data[channel] : frame.extended_data[0];
    const std::ptrdiff_t at =
        planar ? number : static_cast<std::ptrdiff_t>(number) * frame.ch_layout.nb_channels + channel;
    const auto rounded = [&](double value) {
        const double scale = std::ldexp(1.0, static_cast<int>(depth) - 1);
        const double sample = std::isfinite(value) ? std::clamp(value * scale, -scale, scale - 1.0) : 0.0;
        return static_cast<std::int32_t>(std::lrint(sample)) << (32 - static_cast<int>(depth));
    };
    switch (av().av_get_packed_sample_fmt(format)) {
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
    return av().av_get_packed_sample_fmt(static_cast<AVSampleFormat>(format)) == AV_SAMPLE_FMT_S32
               ? SampleDepth::bits_24
               : SampleDepth::bits_16;
}

} // namespace

struct VideoSound::Impl {
    std::unique_ptr<ByteSource> bytes;
    std::uint64_t at = 0;
    AVIOContext* io = nullptr;
    AVFormatContext* file = nullptr;
    AVCodecContext* decoder = nullptr;
    AVPacket* packet = nullptr;
    AVFrame* frame = nullptr;
    int stream = -1;
    bool drained = false; ///< the decoder was told that nothing more comes
    int sample_format = -1;
    SoundFormat format;
    SampleDepth depth = SampleDepth::bits_16;
    std::vector<std::int32_t> held; ///< decoded and not yet read
    std::size_t held_from = 0;

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        av().av_frame_free(&frame);
        av().av_packet_free(&packet);
        av().avcodec_free_context(&decoder);
        av().avformat_close_input(&file);
        if (io != nullptr)
            av().av_freep(&io->buffer);
        av().avio_context_free(&io);
    }

    static int take(void* self, std::uint8_t* to, int count) {
        Impl& impl = *static_cast<Impl*>(self);
        const std::size_t done =
            impl.bytes->read(impl.at, {reinterpret_cast<char*>(to), static_cast<std::size_t>(count)});
        impl.at += done;
        return done == 0 ? AVERROR_EOF : static_cast<int>(done);
    }
    static std::int64_t go_to(void* self, std::int64_t offset, int whence) {
        Impl& impl = *static_cast<Impl*>(self);
        const auto size = static_cast<std::int64_t>(impl.bytes->size());
        if ((whence & AVSEEK_SIZE) != 0)
            return size;
        const int from = whence & ~AVSEEK_FORCE;
        const std::int64_t base = from == SEEK_SET   ? 0
                                  : from == SEEK_CUR ? static_cast<std::int64_t>(impl.at)
                                                     : size;
        std::int64_t to = 0;
        if (__builtin_add_overflow(base, offset, &to) || to < 0)
            return AVERROR(EINVAL);
        impl.at = static_cast<std::uint64_t>(to);
        return to;
    }
    /// Nothing that a video names is opened: not a file, not an address.
    static int open_nothing(AVFormatContext*, AVIOContext**, const char*, int, AVDictionary**) {
        return AVERROR(EPERM);
    }

    std::string open_file() {
        const std::string no_video = "it is damaged, or not a video that can be read here.";
        auto* buffer = static_cast<std::uint8_t*>(av().av_malloc(read_block));
        io = av().avio_alloc_context(buffer, read_block, 0, this, take, nullptr, go_to);
        file = av().avformat_alloc_context();
        packet = av().av_packet_alloc();
        frame = av().av_frame_alloc();
        if (buffer == nullptr || io == nullptr || file == nullptr || packet == nullptr || frame == nullptr)
            return "there is not enough memory.";
        file->pb = io;
        file->flags |= AVFMT_FLAG_CUSTOM_IO;
        file->io_open = open_nothing;
        // on a failure it has freed `file`, and not `io`, which is ours
        if (av().avformat_open_input(&file, nullptr, av().av_find_input_format("mov"), nullptr) < 0)
            return no_video;
        stream = av().av_find_best_stream(file, AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0);
        if (stream < 0)
            return file->nb_streams == 0 ? no_video : "it has no sound.";
        for (unsigned i = 0; i < file->nb_streams; ++i)
            if (static_cast<int>(i) != stream)
                file->streams[i]->discard = AVDISCARD_ALL;
        return {};
    }

    std::string open_decoder() {
        const AVCodecParameters& about = *file->streams[stream]->codecpar;
        const AVCodec* codec = is_a_camera_s(about.codec_id) ? av().avcodec_find_decoder(about.codec_id) : nullptr;
        if (codec == nullptr)
            return std::string("its sound is of a kind that cannot be decoded here (") +
                   av().avcodec_get_name(about.codec_id) + ").";
        decoder = av().avcodec_alloc_context3(codec);
        if (decoder == nullptr)
            return "there is not enough memory.";
        decoder->thread_count = 1;
        decoder->pkt_timebase = file->streams[stream]->time_base;
        if (av().avcodec_parameters_to_context(decoder, &about) < 0 || av().avcodec_open2(decoder, codec, nullptr) < 0)
            return "its sound cannot be decoded.";
        return {};
    }

    /// The first samples tell what a damaged head may not.
    std::string begin() {
        if (!next_frame())
            return "nothing of its sound can be decoded.";
        format = {frame->sample_rate, frame->ch_layout.nb_channels};
        sample_format = frame->format;
        depth = depth_of(frame->format);
        if (format.channels < 1 || format.channels > most_video_channels)
            return "its sound has " + std::to_string(format.channels) + " channels; at most " +
                   std::to_string(most_video_channels) + " can be read.";
        if (format.rate < lowest_video_rate || format.rate > highest_video_rate)
            return "recordings do not have its sample rate.";
        hold();
        return {};
    }

    /// The next decoded samples into `frame`; false at the end.
    bool next_frame() {
        while (true) {
            const int got = av().avcodec_receive_frame(decoder, frame);
            if (got == 0 && frame->nb_samples > 0)
                return true;
            if (got == AVERROR_EOF)
                return false;
            if (got != 0 && drained)
                return false;
            if (got == 0)
                continue;
            if (av().av_read_frame(file, packet) < 0) {
                drained = true;
                av().avcodec_send_packet(decoder, nullptr);
                continue;
            }
            if (packet->stream_index == stream)
                av().avcodec_send_packet(decoder, packet); // a damaged one is left out
            av().av_packet_unref(packet);
        }
    }

    void hold() {
        held.clear();
        held_from = 0;
        for (int i = 0; i < frame->nb_samples; ++i)
            for (int channel = 0; channel < format.channels; ++channel)
                held.push_back(sample_of(*frame, channel, i, depth));
    }

    /// Whether there is more to read; a sound that changes its format midway ends there.
    bool hold_more() {
        if (!next_frame())
            return false;
        if (frame->sample_rate != format.rate || frame->ch_layout.nb_channels != format.channels ||
            frame->format != sample_format)
            return false;
        hold();
        return true;
    }
};

VideoSound::VideoSound(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VideoSound::VideoSound(VideoSound&&) noexcept = default;
VideoSound::~VideoSound() = default;

Result<VideoSound> VideoSound::open(std::unique_ptr<ByteSource> video) {
    if (load_libav() == nullptr)
        return Error{std::string("reading it needs the library ") + libav_name +
                     " of FFmpeg (Debian: libavformat59), which is not installed."};
    av().av_log_set_level(AV_LOG_QUIET); // it would print on stderr; what is wrong is said by who asked
    av().av_max_alloc(most_memory);
    auto impl = std::make_unique<Impl>();
    impl->bytes = std::move(video);
    std::string problem = impl->open_file();
    if (problem.empty())
        problem = impl->open_decoder();
    if (problem.empty())
        problem = impl->begin();
    return problem.empty() ? Result<VideoSound>(VideoSound(std::move(impl))) : Error{problem};
}

SoundFormat VideoSound::format() const { return impl_->format; }

SampleDepth VideoSound::depth() const { return impl_->depth; }

std::uint64_t VideoSound::frames() const {
    const AVStream& stream = *impl_->file->streams[impl_->stream];
    const std::int64_t most = static_cast<std::int64_t>(longest_recording_s) * impl_->format.rate;
    if (stream.duration <= 0)
        return 0;
    const std::int64_t frames =
        av().av_rescale_q(stream.duration, stream.time_base, AVRational{1, impl_->format.rate});
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
