// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/wav_layout.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace tp {

namespace {

static_assert(std::endian::native == std::endian::little, "WAV samples are copied as they lie in memory");

constexpr std::uint32_t unknown_size = 0xFFFFFFFF;
constexpr int most_chunks = 1000; ///< before the samples; a file of empty chunks is not followed for ever
constexpr std::size_t most_format_bytes = 40;
constexpr std::uint64_t sample_bytes = sizeof(std::int16_t);

/// A number of `Number`'s size, least byte first.
template <typename Number>
Number number_at(const char* bytes) {
    Number value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

void add_number(std::string& to, std::uint32_t value) {
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

struct Chunk {
    std::string name;
    std::uint64_t body = 0; ///< where its content begins
    std::uint32_t size = 0; ///< as it claims

    std::uint64_t end() const { return body + size; }
};

enum class Found { chunk, end_of_file, something_else };

Found chunk_at(const ByteSource& file, std::uint64_t at, Chunk& chunk) {
    std::array<char, 8> head{};
    const std::size_t count = file.read(at, head);
    const auto named = [](char c) { return c >= 0x20 && c < 0x7F; };
    if (!std::all_of(head.begin(), head.begin() + std::min<std::size_t>(count, 4), named))
        return Found::something_else;
    if (count < head.size())
        return Found::end_of_file;
    chunk = {std::string(head.data(), 4), at + head.size(), number_at<std::uint32_t>(head.data() + 4)};
    return Found::chunk;
}

/// The chunk after `before`, which is padded to an even size, unless its writer forgot.
Found chunk_after(const ByteSource& file, const Chunk& before, Chunk& chunk) {
    const std::uint64_t odd = before.size & 1u;
    Found found = chunk_at(file, before.end() + odd, chunk);
    if (found == Found::something_else && odd == 1)
        found = chunk_at(file, before.end(), chunk);
    return found;
}

/// Whether whole chunks, and nothing else, lie between `chunk` and the end of the file.
bool only_chunks_after(const ByteSource& file, Chunk chunk) {
    for (int i = 0; i < most_chunks; ++i) {
        const std::uint64_t end = chunk.end();
        if (end == file.size() || end + (chunk.size & 1u) == file.size())
            return true;
        if (end > file.size() || chunk_after(file, chunk, chunk) != Found::chunk)
            return false;
    }
    return false;
}

/// The format in a chunk `fmt `; an error where it is not one that a recording has.
Result<SoundFormat> format_in(std::string_view fmt) {
    constexpr std::uint16_t pcm = 1;
    constexpr std::uint16_t extensible = 0xFFFE; // what it is stands in the first bytes of a GUID
    const auto word = [&](std::size_t at) { return number_at<std::uint16_t>(fmt.data() + at); };
    const std::uint16_t tag = word(0) == extensible && fmt.size() >= 26 ? word(24) : word(0);
    const std::uint16_t channels = word(2);
    const auto rate = number_at<std::uint32_t>(fmt.data() + 4);
    if (tag != pcm || word(14) != 16)
        return Error{"its samples are not of 16 bit."};
    if (channels < 1 || channels > 2)
        return Error{"it is neither mono nor stereo."};
    if (rate < 8'000 || rate > 192'000)
        return Error{"recordings do not have its sample rate."};
    return SoundFormat{static_cast<int>(rate), channels};
}

/// Reads the chunks before the samples one by one.
class Header {
public:
    explicit Header(const ByteSource& file) : file_(file) {}

    Result<WavLayout> layout() {
        std::array<char, 12> riff{};
        const std::string_view start(riff.data(), file_.read(0, riff));
        const bool large = start.starts_with("RF64");
        if (!large && start.substr(0, 4) != std::string_view("RIFF").substr(0, start.size()))
            return Error{"it does not begin like a WAV file."};
        if (start.size() < riff.size())
            return layout_;
        if (start.substr(8) != "WAVE")
            return Error{"it does not begin like a WAV file."};
        Chunk chunk{{}, riff.size(), 0};
        for (int i = 0; i < most_chunks; ++i) {
            switch (chunk_after(file_, chunk, chunk)) {
            case Found::something_else:
                return Error{"its header is damaged."};
            case Found::end_of_file:
                return layout_;
            case Found::chunk:
                break;
            }
            if (chunk.name == "data")
                return with_samples(chunk, large);
            if (chunk.end() > file_.size()) {
                if (chunk.name == "fmt " && chunk.size <= most_format_bytes)
                    return layout_; // it ends within its header
                return Error{"its header is damaged."};
            }
            if (std::string reason = take(chunk); !reason.empty())
                return Error{reason};
        }
        return Error{"it has no samples."};
    }

private:
    std::string content(const Chunk& chunk, std::size_t most) const {
        std::string bytes(std::min<std::size_t>(chunk.size, most), '\0');
        bytes.resize(file_.read(chunk.body, bytes));
        return bytes;
    }

    std::string take(const Chunk& chunk) {
        if (chunk.name == "fmt ") {
            const std::string fmt = content(chunk, most_format_bytes);
            if (fmt.size() < 16)
                return "its header is damaged.";
            const auto format = format_in(fmt);
            if (!format)
                return format.error();
            layout_.format = *format;
            has_format_ = true;
        } else if (chunk.name == wav_notes_chunk && chunk.size <= most_wav_notes) {
            layout_.notes = content(chunk, most_wav_notes);
        } else if (chunk.name == "ds64" && chunk.size >= 16) {
            large_size_ = number_at<std::uint64_t>(content(chunk, 16).data() + 8);
        }
        return {};
    }

    Result<WavLayout> with_samples(const Chunk& data, bool large) {
        if (!has_format_)
            return Error{"its header is damaged."};
        const std::uint64_t there = file_.size() - data.body;
        std::uint64_t bytes = there;
        if (large && large_size_ > 0 && large_size_ < there)
            bytes = large_size_;
        else if (!large && data.size > 0 && data.size != unknown_size && data.size < there &&
                 only_chunks_after(file_, data))
            bytes = data.size;
        layout_.data_begin = data.body;
        layout_.frames = bytes / (sample_bytes * static_cast<std::uint64_t>(layout_.format.channels));
        return layout_;
    }

    const ByteSource& file_;
    WavLayout layout_;
    bool has_format_ = false;
    std::uint64_t large_size_ = 0; ///< of the samples, in RF64 (EBU Tech 3306)
};

} // namespace

Result<WavLayout> wav_layout(const ByteSource& file) { return Header(file).layout(); }

std::string open_ended_wav_header(const SoundFormat& format, std::string_view notes) {
    const auto channels = static_cast<std::uint32_t>(format.channels);
    const auto rate = static_cast<std::uint32_t>(format.rate);
    const std::uint32_t frame_bytes = channels * sample_bytes;
    std::string header = "RIFF";
    add_number(header, unknown_size);
    header += "WAVEfmt ";
    add_number(header, 16);
    add_number(header, 1u | channels << 16); // PCM
    add_number(header, rate);
    add_number(header, rate * frame_bytes);
    add_number(header, frame_bytes | 16u << 16);
    if (!notes.empty()) {
        header += wav_notes_chunk;
        add_number(header, static_cast<std::uint32_t>(notes.size()));
        header += notes;
        header.append(notes.size() & 1u, '\0');
    }
    header += "data";
    add_number(header, unknown_size);
    return header;
}

std::size_t read_frames(const ByteSource& file, const WavLayout& layout, std::uint64_t first,
                        std::span<std::int16_t> to) {
    if (first >= layout.frames)
        return 0;
    const auto channels = static_cast<std::size_t>(layout.format.channels);
    const std::uint64_t frames = std::min<std::uint64_t>(to.size() / channels, layout.frames - first);
    const std::size_t frame_bytes = sample_bytes * channels;
    const std::span<char> bytes(reinterpret_cast<char*>(to.data()),
                                static_cast<std::size_t>(frames) * frame_bytes);
    return file.read(layout.data_begin + first * frame_bytes, bytes) / frame_bytes;
}

} // namespace tp
