// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/metadata_size.hpp"

#include "app/album/metadata/xmp_packet.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace tp {

namespace {

constexpr std::uint64_t most_metadata = XmpPacket::most_bytes;
constexpr std::uint64_t most_of_other_kinds = std::uint64_t{128} << 20;
constexpr int most_chunks = 100'000;

class Reader {
public:
    Reader(std::ifstream& stream, bool little_endian) : stream_(stream), little_endian_(little_endian) {}

    bool ok() const { return stream_.good(); }
    void to(std::uint64_t place) { stream_.seekg(static_cast<std::streamoff>(place)); }
    std::uint64_t place() { return static_cast<std::uint64_t>(std::streamoff(stream_.tellg())); }

    std::uint32_t number(int bytes) {
        std::uint32_t sum = 0;
        for (int i = 0; i < bytes; ++i) {
            const auto byte = static_cast<std::uint32_t>(stream_.get()) & 0xFFu;
            sum |= byte << (8 * (little_endian_ ? i : bytes - 1 - i));
        }
        return sum;
    }
    std::string letters(std::size_t count) {
        std::string text(count, '\0');
        stream_.read(text.data(), static_cast<std::streamsize>(count));
        return text;
    }

private:
    std::ifstream& stream_;
    bool little_endian_;
};

bool oversized_png(std::ifstream& stream) {
    Reader reader(stream, false);
    reader.to(8);
    for (int i = 0; i < most_chunks; ++i) {
        const std::uint64_t size = reader.number(4);
        const std::string type = reader.letters(4);
        if (!reader.ok() || type == "IEND")
            return false;
        if (type != "IDAT" && size > most_metadata)
            return true;
        reader.to(reader.place() + size + 4);
    }
    return true;
}

bool oversized_webp(std::ifstream& stream) {
    Reader reader(stream, true);
    reader.to(12);
    for (int i = 0; i < most_chunks; ++i) {
        const std::string type = reader.letters(4);
        const std::uint64_t size = reader.number(4);
        if (!reader.ok())
            return false;
        if ((type == "XMP " || type == "EXIF" || type == "ICCP") && size > most_metadata)
            return true;
        reader.to(reader.place() + size + size % 2);
    }
    return true;
}

bool oversized_tiff(std::ifstream& stream, bool little_endian) {
    constexpr std::uint32_t xmp_tag = 700;
    Reader reader(stream, little_endian);
    reader.to(4);
    reader.to(reader.number(4));
    const std::uint32_t entries = reader.number(2);
    for (std::uint32_t i = 0; i < entries && reader.ok(); ++i) {
        const std::uint32_t tag = reader.number(2);
        reader.number(2); // its type, of one byte
        const std::uint32_t count = reader.number(4);
        reader.number(4);
        if (reader.ok() && tag == xmp_tag && count > most_metadata)
            return true;
    }
    return false;
}

} // namespace

bool has_oversized_metadata(const std::filesystem::path& photo) {
    std::ifstream stream(photo, std::ios::binary);
    std::array<char, 12> start{};
    stream.read(start.data(), start.size());
    const std::string_view head(start.data(), static_cast<std::size_t>(stream.gcount()));
    stream.clear();
    if (head.starts_with("\xFF\xD8")) // at most 64 KB each
        return false;
    if (head.starts_with("\x89PNG"))
        return oversized_png(stream);
    if (head.starts_with("RIFF") && head.substr(std::min<std::size_t>(8, head.size())) == "WEBP")
        return oversized_webp(stream);
    if (head.starts_with(std::string_view("II*\0", 4)) || head.starts_with(std::string_view("MM\0*", 4)))
        return oversized_tiff(stream, head.front() == 'I');
    std::error_code error;
    return std::filesystem::file_size(photo, error) > most_of_other_kinds && !error;
}

} // namespace tp
