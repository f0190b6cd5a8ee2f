// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/sound_reader.hpp"

#include "core/files/file_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sndfile.h>
#include <string_view>
#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr int most_channels = 8; // as many as FLAC has
constexpr int lowest_rate = 1'000;
constexpr int highest_rate = 655'350; // FLAC's

/// How the files begin that we let libsndfile look at. It knows many more, rarer ones, whose readers nobody
/// needs here.
bool may_be_sound(const ByteSource& bytes) {
    constexpr std::array<std::string_view, 10> starts{"RIFF", "RIFX", "RF64", "riff", "FORM",
                                                      "caff", ".snd", "fLaC", "OggS", "ID3"};
    std::array<char, 4> head{};
    const std::string_view start(head.data(), bytes.read(0, head));
    const bool mpeg =
        start.size() == 4 && start[0] == '\xFF' && (static_cast<unsigned char>(start[1]) & 0xE0u) == 0xE0u;
    return mpeg ||
           std::any_of(starts.begin(), starts.end(), [&](auto known) { return start.starts_with(known); });
}

bool is_float(int subtype) { return subtype == SF_FORMAT_FLOAT || subtype == SF_FORMAT_DOUBLE; }

bool is_lossy(int subtype) {
    return subtype == SF_FORMAT_VORBIS || subtype == SF_FORMAT_OPUS || subtype == SF_FORMAT_MPEG_LAYER_I ||
           subtype == SF_FORMAT_MPEG_LAYER_II || subtype == SF_FORMAT_MPEG_LAYER_III;
}

SampleDepth depth_of(int subtype) {
    switch (subtype) {
    case SF_FORMAT_PCM_S8:
    case SF_FORMAT_PCM_U8:
        return SampleDepth::bits_8;
    case SF_FORMAT_PCM_24:
    case SF_FORMAT_PCM_32:
    case SF_FORMAT_FLOAT:
    case SF_FORMAT_DOUBLE:
    case SF_FORMAT_ALAC_20:
    case SF_FORMAT_ALAC_24:
    case SF_FORMAT_ALAC_32:
        return SampleDepth::bits_24;
    default:
        return SampleDepth::bits_16;
    }
}

} // namespace

struct SoundReader::Impl {
    std::unique_ptr<ByteSource> bytes;
    std::uint64_t at = 0;
    SF_INFO info{};
    SNDFILE* file = nullptr;
    std::vector<float> block;

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        if (file != nullptr)
            sf_close(file);
    }

    int subtype() const { return info.format & SF_FORMAT_SUBMASK; }

    static Impl& self(void* user) { return *static_cast<Impl*>(user); }
    static sf_count_t size(void* user) { return static_cast<sf_count_t>(self(user).bytes->size()); }
    static sf_count_t go_to(sf_count_t offset, int whence, void* user) {
        Impl& impl = self(user);
        const auto base = whence == SEEK_SET   ? sf_count_t{0}
                          : whence == SEEK_CUR ? static_cast<sf_count_t>(impl.at)
                                               : size(user);
        sf_count_t to = 0;
        if (__builtin_add_overflow(base, offset, &to) || to < 0)
            return -1;
        impl.at = static_cast<std::uint64_t>(to);
        return to;
    }
    static sf_count_t take(void* to, sf_count_t count, void* user) {
        Impl& impl = self(user);
        if (count <= 0)
            return 0;
        const std::size_t done =
            impl.bytes->read(impl.at, {static_cast<char*>(to), static_cast<std::size_t>(count)});
        impl.at += done;
        return static_cast<sf_count_t>(done);
    }
    bool open() {
        SF_VIRTUAL_IO io{size, go_to, take, refuse, where};
        at = 0;
        info = {};
        file = sf_open_virtual(&io, SFM_READ, &info, this);
        return file != nullptr;
    }
    /// For a file that does not say how long it is: reads it once, up to a frame more than `most`.
    bool count_frames(sf_count_t most) {
        std::vector<std::int32_t> samples(static_cast<std::size_t>(info.channels) * 4'096);
        sf_count_t total = 0;
        while (total <= most) {
            const sf_count_t more = sf_readf_int(file, samples.data(), 4'096);
            if (more <= 0)
                break;
            total += more;
        }
        sf_close(std::exchange(file, nullptr));
        const bool again = open();
        info.frames = total;
        return again;
    }

    static sf_count_t refuse(const void*, sf_count_t, void*) { return 0; }
    static sf_count_t where(void* user) { return static_cast<sf_count_t>(self(user).at); }
};

SoundReader::SoundReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SoundReader::SoundReader(SoundReader&&) noexcept = default;
SoundReader::~SoundReader() = default;

Result<SoundReader> SoundReader::open(const std::filesystem::path& file) {
    auto bytes = FileBytes::open(file);
    if (!bytes)
        return Error{bytes.error()};
    return open(std::move(*bytes));
}

Result<SoundReader> SoundReader::open(std::unique_ptr<ByteSource> bytes) {
    if (bytes->size() == 0)
        return Error{"it is empty."};
    const bool may_be = may_be_sound(*bytes);
    auto impl = std::make_unique<Impl>();
    impl->bytes = std::move(bytes);
    const bool opened = may_be && impl->open();
    if (impl->bytes->fault() != 0)
        return Error{reason_of(impl->bytes->fault())};
    if (!may_be)
        return Error{"it is not a sound file that can be read here."};
    if (!opened)
        return Error{"it is damaged, or not a sound file that can be read here."};
    const SF_INFO& info = impl->info;
    if (info.channels < 1 || info.channels > most_channels)
        return Error{"it has " + std::to_string(info.channels) + " channels; at most " +
                     std::to_string(most_channels) + " can be read."};
    if (info.samplerate < lowest_rate || info.samplerate > highest_rate)
        return Error{"recordings do not have its sample rate."};
    const auto most = static_cast<sf_count_t>(longest_recording_s) * info.samplerate;
    if (info.frames == SF_COUNT_MAX && !impl->count_frames(most)) // a FLAC that was written into a pipe
        return Error{impl->bytes->fault() != 0 ? reason_of(impl->bytes->fault()) : "it is damaged."};
    if (info.frames <= 0)
        return Error{"it holds no sound."};
    if (info.frames > most)
        return Error{"it is longer than " + std::to_string(longest_recording_s / 3600) +
                     " hours, or claims to be."};
    return SoundReader(std::move(impl));
}

SoundFormat SoundReader::format() const { return {impl_->info.samplerate, impl_->info.channels}; }

SampleDepth SoundReader::depth() const { return depth_of(impl_->subtype()); }

std::size_t SoundReader::read(std::span<std::int32_t> to) {
    const auto channels = static_cast<std::size_t>(impl_->info.channels);
    const std::size_t frames = to.size() / channels;
    if (!is_float(impl_->subtype()) && !is_lossy(impl_->subtype()))
        return static_cast<std::size_t>(
            std::max<sf_count_t>(0, sf_readf_int(impl_->file, to.data(), static_cast<sf_count_t>(frames))));
    impl_->block.resize(frames * channels);
    const auto done = static_cast<std::size_t>(std::max<sf_count_t>(
        0, sf_readf_float(impl_->file, impl_->block.data(), static_cast<sf_count_t>(frames))));
    const int bits = static_cast<int>(depth());
    const float scale = std::ldexp(1.0F, bits - 1);
    for (std::size_t i = 0; i < done * channels; ++i) {
        const float sample = std::isfinite(impl_->block[i]) ? impl_->block[i] : 0.0F;
        to[i] = static_cast<std::int32_t>(std::lrint(std::clamp(sample * scale, -scale, scale - 1.0F)))
                << (32 - bits);
    }
    return done;
}

std::uint64_t SoundReader::frames() const { return static_cast<std::uint64_t>(impl_->info.frames); }

bool SoundReader::exact_length() const { return (impl_->info.format & SF_FORMAT_TYPEMASK) != SF_FORMAT_MPEG; }

bool SoundReader::seek(std::uint64_t frame) {
    return frame <= frames() &&
           sf_seek(impl_->file, static_cast<sf_count_t>(frame), SEEK_SET) == static_cast<sf_count_t>(frame);
}

bool SoundReader::failed() const { return fault() != 0 || sf_error(impl_->file) != SF_ERR_NO_ERROR; }

int SoundReader::fault() const { return impl_->bytes->fault(); }

std::string SoundReader::artist() const {
    const char* const text = sf_get_string(impl_->file, SF_STR_ARTIST);
    return text == nullptr ? "" : text;
}

std::string SoundReader::date() const {
    const char* const text = sf_get_string(impl_->file, SF_STR_DATE);
    return text == nullptr ? "" : text;
}

} // namespace tp
