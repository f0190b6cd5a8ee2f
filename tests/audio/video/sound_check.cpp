// SPDX-License-Identifier: Apache-2.0
#include "sound_check.hpp"

#include "audio/recordings/sound_reader.hpp"
#include "audio/video/video_film.hpp"
#include "audio/video/video_sound.hpp"

#include <array>
#include <memory>
#include <utility>

namespace tp::test {

namespace {

constexpr std::size_t most_samples = 1 << 20; ///< that are read of one

std::string complaint_about_stream(SoundStream& sound) {
    const SoundFormat format = sound.format();
    if (format.channels < 1 || format.channels > 8 || format.rate < 1)
        return "a format that no recording has";
    std::array<std::int32_t, 4096> block{};
    const std::size_t fit = block.size() / static_cast<std::size_t>(format.channels);
    for (std::size_t samples = 0; samples < most_samples;) {
        const std::size_t count =
            sound.read(std::span(block).first(fit * static_cast<std::size_t>(format.channels)));
        if (count > fit * static_cast<std::size_t>(format.channels))
            return "more samples than were asked for";
        if (count == 0)
            break;
        samples += count;
    }
    return {};
}

constexpr int most_pictures = 16; ///< that are looked at of one

std::string complaint_about_stream(FilmStream& film) {
    for (int i = 0; i < most_pictures; ++i) {
        const auto picture = film.next(0.0);
        if (!picture)
            break;
        if (picture->width < 2 || picture->height < 2 ||
            picture->planes.size() != film_bytes(picture->width, picture->height))
            return "a picture of another size than it says";
    }
    return {};
}

template <typename Sound>
std::string complaint_about(Result<Sound> sound) {
    if (!sound)
        return sound.error().size() > 10 && sound.error().ends_with('.') ? "" : "refused without words";
    return complaint_about_stream(*sound);
}

} // namespace

std::string complaint_about_sound(std::string_view bytes) {
    std::string complaint = complaint_about(SoundReader::open(std::make_unique<MemoryBytes>(bytes)));
    if (complaint.empty())
        complaint = complaint_about(VideoSound::open(std::make_unique<MemoryBytes>(bytes)));
    if (complaint.empty())
        complaint = complaint_about(VideoFilm::open(std::make_unique<MemoryBytes>(bytes)));
    return complaint;
}

} // namespace tp::test
