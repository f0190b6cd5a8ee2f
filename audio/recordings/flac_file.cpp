// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/flac_file.hpp"

#include "audio/recordings/flac_head.hpp"
#include "audio/recordings/flac_writer.hpp"
#include "audio/recordings/sound_reader.hpp"
#include "core/files/new_file.hpp"

#include <vector>

namespace tp {

namespace {

struct Encoded {
    SoundFingerprint fingerprint;
    std::uint64_t frames = 0;
};

Result<Encoded> encode(SoundStream& sound, const std::filesystem::path& to, Incomplete incomplete) {
    auto writer = FlacWriter::over(to, sound.format(), sound.depth());
    if (!writer)
        return Error{writer.error()};
    const auto channels = static_cast<std::size_t>(sound.format().channels);
    const std::uint64_t most = longest_recording_s * static_cast<std::uint64_t>(sound.format().rate);
    Encoded encoded{SoundFingerprint(sound.depth())};
    std::vector<std::int32_t> block(sound_block);
    while (const std::size_t frames = sound.read(block)) {
        const std::span<const std::int32_t> samples(block.data(), frames * channels);
        encoded.fingerprint.add(samples);
        encoded.frames += frames;
        if (encoded.frames > most)
            return Error{"it is longer than " + std::to_string(longest_recording_s / 3600) + " hours."};
        if (std::string reason = writer->write(samples); !reason.empty())
            return Error{reason};
    }
    if (std::string reason = writer->finish(); !reason.empty())
        return Error{reason};
    if (encoded.frames == 0)
        return Error{"nothing of it can be read."};
    if (incomplete == Incomplete::refused && encoded.frames != sound.frames())
        return Error{"it cannot be read to its end."};
    return encoded;
}

std::string write_copy(const ByteSource& flac, const VorbisComments& comments, NewFile& to) {
    const auto head = flac_head(flac);
    if (!head)
        return head.error();
    VorbisComments all = comments;
    all.vendor = head->comments.vendor;
    return write_with_comments(flac, *head, all, [&](std::string_view bytes) { return to.write(bytes); });
}

} // namespace

SoundFingerprint fingerprint_of(SoundStream& sound) {
    SoundFingerprint fingerprint(sound.depth());
    std::vector<std::int32_t> block(sound_block);
    while (const std::size_t frames = sound.read(block))
        fingerprint.add({block.data(), frames * static_cast<std::size_t>(sound.format().channels)});
    return fingerprint;
}

Result<std::uint64_t> store_flac(SoundStream& sound, const VorbisComments& comments,
                                 const std::filesystem::path& place, Incomplete incomplete) {
    auto bare = NewFile::beside(place, Readers::owner_only);
    if (!bare)
        return Error{bare.error()};
    const auto encoded = encode(sound, bare->temporary(), incomplete);
    if (!encoded)
        return Error{encoded.error()};
    const auto flac = FileBytes::open(bare->temporary());
    if (!flac)
        return Error{flac.error()};
    auto whole = NewFile::beside(place, Readers::owner_only);
    if (!whole)
        return Error{whole.error()};
    if (std::string reason = write_copy(**flac, comments, *whole); !reason.empty())
        return Error{reason};
    auto written = SoundReader::open(whole->temporary());
    if (!written || written->frames() != encoded->frames || fingerprint_of(*written) != encoded->fingerprint)
        return Error{
            "what was written is not what should have been written; the disk or the memory may be faulty."};
    if (std::string reason = whole->take_place(Existing::kept); !reason.empty())
        return Error{reason};
    return encoded->frames;
}

std::string store_flac_copy(const ByteSource& flac, const VorbisComments& comments,
                            const std::filesystem::path& place) {
    auto made = NewFile::beside(place, Readers::owner_only);
    if (!made)
        return made.error();
    std::string reason = write_copy(flac, comments, *made);
    return reason.empty() ? made->take_place(Existing::kept) : reason;
}

} // namespace tp
