// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/flac_head.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace tp {

namespace {

enum BlockType { stream_info = 0, padding = 1, vorbis_comment = 4, forbidden = 127 };

constexpr std::string_view marker = "fLaC";
constexpr std::uint32_t stream_info_size = 34;
constexpr std::size_t most_blocks = 1000;
constexpr std::uint64_t most_head_bytes = 1 << 28;

unsigned byte_of(char c) { return static_cast<unsigned char>(c); }

/// Bytes of the ID3v2 tag that the file begins with (id3.org, "ID3v2.4.0 structure", 3.1); 0: none.
std::uint64_t id3_size(const ByteSource& file) {
    std::array<char, 10> head{};
    if (file.read(0, head) < head.size() || std::string_view(head.data(), 3) != "ID3")
        return 0;
    std::uint64_t size = 0;
    for (std::size_t i = 6; i < 10; ++i)
        size = size << 7 | (byte_of(head[i]) & 0x7Fu);
    const bool footer = (byte_of(head[5]) & 0x10u) != 0;
    return head.size() + size + (footer ? head.size() : 0);
}

bool marked(const ByteSource& file, std::uint64_t at) {
    std::array<char, marker.size()> start{};
    return file.read(at, start) == start.size() && std::string_view(start.data(), start.size()) == marker;
}

/// The number of frames in the stream information: 36 bits after 13 bytes and a half.
std::uint64_t frames_in(const ByteSource& file, std::uint64_t stream_info_body) {
    std::array<char, 5> number{};
    file.read(stream_info_body + 13, number);
    std::uint64_t frames = byte_of(number[0]) & 0x0Fu;
    for (std::size_t i = 1; i < number.size(); ++i)
        frames = frames << 8 | byte_of(number[i]);
    return frames;
}

std::string block_header(int type, std::size_t size, bool last) {
    return {static_cast<char>(type | (last ? 0x80 : 0)), static_cast<char>(size >> 16 & 0xFFu),
            static_cast<char>(size >> 8 & 0xFFu), static_cast<char>(size & 0xFFu)};
}

/// Copies the bytes from `begin` to `end`.
std::string copy(const ByteSource& file, std::uint64_t begin, std::uint64_t end, const ByteSink& to) {
    std::array<char, 1 << 16> block{};
    while (begin < end) {
        const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), end - begin));
        const std::size_t count = file.read(begin, std::span(block).first(most));
        if (count == 0)
            return "it cannot be read to its end.";
        if (std::string reason = to({block.data(), count}); !reason.empty())
            return reason;
        begin += count;
    }
    return {};
}

} // namespace

bool is_flac(const ByteSource& file) { return marked(file, id3_size(file)); }

Result<FlacHead> flac_head(const ByteSource& file) {
    const Error damaged{"its head is damaged."};
    std::uint64_t at = id3_size(file);
    if (!marked(file, at))
        return Error{"it is not a FLAC file."};
    at += marker.size();
    FlacHead head;
    const std::uint64_t end = std::min(file.size(), at + most_head_bytes);
    bool commented = false;
    for (bool last = false; !last;) {
        std::array<char, 4> header{};
        if (file.read(at, header) < header.size() || head.blocks.size() == most_blocks)
            return damaged;
        last = (byte_of(header[0]) & 0x80u) != 0;
        const FlacHead::Block block{static_cast<int>(byte_of(header[0]) & 0x7Fu), at + header.size(),
                                    byte_of(header[1]) << 16 | byte_of(header[2]) << 8 | byte_of(header[3])};
        at = block.body + block.size;
        const bool first = head.blocks.empty();
        if (at > end || block.type == forbidden || first != (block.type == stream_info) ||
            (first && block.size != stream_info_size))
            return damaged;
        if (first)
            head.frames = frames_in(file, block.body);
        if (block.type == vorbis_comment && !commented) {
            std::string content(block.size, '\0');
            content.resize(file.read(block.body, content));
            if (auto comments = vorbis_comments(content))
                head.comments = std::move(*comments);
            commented = true;
        }
        head.blocks.push_back(block);
    }
    head.sound_begin = at;
    return head;
}

std::string write_with_comments(const ByteSource& file, const FlacHead& head, const VorbisComments& comments,
                                const ByteSink& to) {
    const auto block = vorbis_comment_block(comments);
    if (!block)
        return block.error();
    std::string reason = to(marker);
    for (const FlacHead::Block& kept : head.blocks) {
        if (!reason.empty())
            return reason;
        if (kept.type == vorbis_comment || kept.type == padding)
            continue;
        reason = to(block_header(kept.type, kept.size, false));
        if (reason.empty())
            reason = copy(file, kept.body, kept.body + kept.size, to);
    }
    if (reason.empty())
        reason = to(block_header(vorbis_comment, block->size(), true) + *block);
    return reason.empty() ? copy(file, head.sound_begin, file.size(), to) : reason;
}

} // namespace tp
