// SPDX-License-Identifier: Apache-2.0
#include "audio/video/video_file.hpp"

#include "core/libraries/package_name.hpp"

#include <cerrno>
#include <cstddef>

namespace tp {

namespace {

constexpr std::size_t most_memory = std::size_t{256}
                                    << 20; // of one allocation; a minute's index needs a megabyte
constexpr int read_block = 1 << 15;

/// Nothing that a video names is opened: not a file, not an address.
int open_nothing(AVFormatContext*, AVIOContext**, const char*, int, AVDictionary**) { return AVERROR(EPERM); }

} // namespace

std::string VideoFile::ready() {
    if (load_libav() == nullptr)
        return std::string("reading it needs the library ") + libav_name +
               " of FFmpeg (Debian: " + debian_package(libav_name) + "), which is not installed.";
    av().av_log_set_level(AV_LOG_QUIET); // it would print on stderr; what is wrong is said by who asked
    av().av_max_alloc(most_memory);
    return {};
}

VideoFile::~VideoFile() {
    av().av_frame_free(&frame_);
    av().av_packet_free(&packet_);
    av().avcodec_free_context(&decoder_);
    av().avformat_close_input(&file_);
    if (io_ != nullptr)
        av().av_freep(&io_->buffer);
    av().avio_context_free(&io_);
}

int VideoFile::take(void* self, std::uint8_t* to, int count) {
    VideoFile& file = *static_cast<VideoFile*>(self);
    const std::size_t done =
        file.bytes_->read(file.at_, {reinterpret_cast<char*>(to), static_cast<std::size_t>(count)});
    file.at_ += done;
    return done == 0 ? AVERROR_EOF : static_cast<int>(done);
}

std::int64_t VideoFile::go_to(void* self, std::int64_t offset, int whence) {
    VideoFile& file = *static_cast<VideoFile*>(self);
    const auto size = static_cast<std::int64_t>(file.bytes_->size());
    if ((whence & AVSEEK_SIZE) != 0)
        return size;
    const int from = whence & ~AVSEEK_FORCE;
    const std::int64_t base = from == SEEK_SET   ? 0
                              : from == SEEK_CUR ? static_cast<std::int64_t>(file.at_)
                                                 : size;
    std::int64_t to = 0;
    if (__builtin_add_overflow(base, offset, &to) || to < 0)
        return AVERROR(EINVAL);
    file.at_ = static_cast<std::uint64_t>(to);
    return to;
}

std::string VideoFile::find(AVMediaType kind, const char* none) {
    const std::string no_video = "it is damaged, or not a video that can be read here.";
    auto* buffer = static_cast<std::uint8_t*>(av().av_malloc(read_block));
    io_ = av().avio_alloc_context(buffer, read_block, 0, this, take, nullptr, go_to);
    file_ = av().avformat_alloc_context();
    packet_ = av().av_packet_alloc();
    frame_ = av().av_frame_alloc();
    if (buffer == nullptr || io_ == nullptr || file_ == nullptr || packet_ == nullptr || frame_ == nullptr)
        return "there is not enough memory.";
    file_->pb = io_;
    file_->flags |= AVFMT_FLAG_CUSTOM_IO;
    file_->io_open = open_nothing;
    // on a failure it has freed `file_`, and not `io_`, which is ours
    if (av().avformat_open_input(&file_, nullptr, av().av_find_input_format("mov"), nullptr) < 0)
        return no_video;
    stream_ = av().av_find_best_stream(file_, kind, -1, -1, nullptr, 0);
    if (stream_ < 0)
        return file_->nb_streams == 0 ? no_video : std::string(none);
    for (unsigned i = 0; i < file_->nb_streams; ++i)
        if (static_cast<int>(i) != stream_)
            file_->streams[i]->discard = AVDISCARD_ALL;
    return {};
}

bool VideoFile::open_decoder(std::int64_t pixels) {
    const AVCodec* const codec = av().avcodec_find_decoder(this->codec());
    decoder_ = codec == nullptr ? nullptr : av().avcodec_alloc_context3(codec);
    if (decoder_ == nullptr || av().avcodec_parameters_to_context(decoder_, stream().codecpar) < 0)
        return false;
    decoder_->thread_count = 1;
    decoder_->pkt_timebase = stream().time_base;
    if (pixels > 0)
        decoder_->max_pixels = pixels;
    return av().avcodec_open2(decoder_, codec, nullptr) >= 0;
}

bool VideoFile::next_frame() {
    while (true) {
        const int got = av().avcodec_receive_frame(decoder_, frame_);
        if (got == 0)
            return true;
        if (got == AVERROR_EOF || drained_)
            return false;
        if (av().av_read_frame(file_, packet_) < 0) {
            drained_ = true;
            av().avcodec_send_packet(decoder_, nullptr);
            continue;
        }
        if (packet_->stream_index == stream_)
            av().avcodec_send_packet(decoder_, packet_); // a damaged one is left out
        av().av_packet_unref(packet_);
    }
}

} // namespace tp
