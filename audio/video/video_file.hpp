// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"
#include "audio/video/libav.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace tp {

/// An MP4, QuickTime or 3GP file, and one thing in it that is decoded: its sound or its pictures. What reaches FFmpeg is narrow:
/// one demuxer, a list of codecs, and bytes through our own reader. Nothing that a file names is opened.
class VideoFile {
public:
    /// Whether FFmpeg's libraries are there; the end of a sentence that says why not, or empty. Before any other call.
    static std::string ready();

    explicit VideoFile(std::unique_ptr<ByteSource> bytes) : bytes_(std::move(bytes)) {}
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;
    ~VideoFile();

    /// What `ready` loaded.
    static const LibAv& av() { return *load_libav(); }

    /// Opens the file and looks for its best stream of this kind. Empty, or the end of a sentence; `none` where it has none.
    std::string find(AVMediaType kind, const char* none);
    AVCodecID codec() const { return stream().codecpar->codec_id; }
    /// Opens the decoder of that stream. `pixels` is the most that a picture may have, 0 for sound. False where it cannot be.
    bool open_decoder(std::int64_t pixels);
    /// The next decoded frame into `frame`; false at the end. What is damaged within is left out.
    bool next_frame();

    const AVFrame& frame() const { return *frame_; }
    const AVStream& stream() const { return *file_->streams[stream_]; }

private:
    static int take(void* self, std::uint8_t* to, int count);
    static std::int64_t go_to(void* self, std::int64_t offset, int whence);

    std::unique_ptr<ByteSource> bytes_;
    std::uint64_t at_ = 0;
    AVIOContext* io_ = nullptr;
    AVFormatContext* file_ = nullptr;
    AVCodecContext* decoder_ = nullptr;
    AVPacket* packet_ = nullptr;
    AVFrame* frame_ = nullptr;
    int stream_ = -1;
    bool drained_ = false; ///< the decoder was told that nothing more comes
};

} // namespace tp
