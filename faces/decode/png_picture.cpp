// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/png_picture.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace tp {
namespace {

constexpr std::size_t signature_size = 8, chunk_frame = 12; ///< bytes; length, type and checksum of a chunk
constexpr std::array<std::string_view, 5> needed{"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};

const Error png_cut_short{"The PNG file is cut short: a part of the picture is missing."};
const Error damaged_png{"The PNG file is damaged."};

std::uint32_t number_at(const Bytes& bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) << 24 | static_cast<std::uint32_t>(bytes[at + 1]) << 16 |
           static_cast<std::uint32_t>(bytes[at + 2]) << 8 | bytes[at + 3];
}

constexpr std::array<std::uint32_t, 256> crc_table() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
        table[i] = i;
        for (int bit = 0; bit < 8; ++bit)
            table[i] = table[i] & 1u ? (table[i] >> 1) ^ 0xEDB88320u : table[i] >> 1;
    }
    return table;
}

/// Cyclic redundancy code of the PNG specification, annex D.
std::uint32_t crc_of(const unsigned char* begin, const unsigned char* end) {
    static constexpr auto table = crc_table();
    std::uint32_t crc = 0xFFFFFFFFu;
    for (; begin != end; ++begin)
        crc = table[(crc ^ *begin) & 0xFFu] ^ (crc >> 8);
    return ~crc;
}

} // namespace

Result<PngSize> png_size(const Bytes& bytes) {
    constexpr std::size_t width_at = 16, height_at = 20, needs = 24;
    if (bytes.size() < needs)
        return png_cut_short;
    if (std::string(&bytes[12], &bytes[16]) != needed.front())
        return damaged_png;
    return PngSize{number_at(bytes, width_at), number_at(bytes, height_at)};
}

Result<Bytes> bare_png(const Bytes& bytes) {
    Bytes bare(bytes.begin(), bytes.begin() + signature_size);
    bool has_pixels = false;
    std::size_t at = signature_size;
    while (at + chunk_frame <= bytes.size()) {
        const std::size_t length = number_at(bytes, at);
        if (length > bytes.size() - at - chunk_frame)
            break;
        const unsigned char* chunk = bytes.data() + at;
        const std::string type(chunk + 4, chunk + 8);
        at += chunk_frame + length;
        if (std::find(needed.begin(), needed.end(), type) == needed.end())
            continue;
        if (crc_of(chunk + 4, chunk + 8 + length) != number_at(bytes, at - 4))
            return damaged_png;
        bare.insert(bare.end(), chunk, bytes.data() + at);
        has_pixels = has_pixels || type == "IDAT";
        if (type == "IEND")
            return has_pixels ? Result<Bytes>(std::move(bare)) : damaged_png;
    }
    return png_cut_short;
}

} // namespace tp
