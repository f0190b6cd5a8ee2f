// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/byte_source.hpp"
#include "audio/recordings/sound_stream.hpp"
#include "core/base/result.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace tp {

inline constexpr int most_video_channels = 8;      ///< as many as FLAC has
inline constexpr int lowest_video_rate = 1'000;     ///< Hz
inline constexpr int highest_video_rate = 655'350; ///< Hz; FLAC's

/// The sound of a video: MP4, QuickTime or 3GP, as cameras and telephones write them. Pictures are not
/// decoded.
class VideoSound : public SoundStream {
public:
    /// An error is the end of a sentence, such as "it has no sound.". Refused are sounds of which no
    /// recording is (as `SoundReader` does), and those whose decoder is not one that cameras' sound needs.
    static Result<VideoSound> open(std::unique_ptr<ByteSource> video);
    VideoSound(VideoSound&&) noexcept;
    VideoSound& operator=(VideoSound&&) = delete;
    ~VideoSound() override;

    SoundFormat format() const override;
    /// 24 bit where the samples have more than 16, else 16: most are compressed with loss.
    SampleDepth depth() const override;
    /// As the video says, which may differ by what a codec fills up with.
    std::uint64_t frames() const override;
    /// Ends where a damaged one cannot be decoded any more; what is damaged within is left out.
    std::size_t read(std::span<std::int32_t> to) override;

private:
    struct Impl;
    explicit VideoSound(std::unique_ptr<Impl> impl);

    std::unique_ptr<Impl> impl_;
};

} // namespace tp
