// SPDX-License-Identifier: Apache-2.0
#include "made_photo.hpp"

#include "app/album/metadata/xmp_names.hpp"
#include "faces/exiv2/prepare_exiv2.hpp"

#include <cstdint>
#include <fstream>
#include <iterator>

namespace tp::test {

namespace {

std::string big_endian(std::uint32_t number, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i)
        text += static_cast<char>((number >> (8 * i)) & 0xFFu);
    return text;
}

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

std::string chunk(std::string_view type_and_data) {
    return big_endian(static_cast<std::uint32_t>(type_and_data.size() - 4), 4) + std::string(type_and_data) +
           big_endian(crc32(type_and_data), 4);
}

std::string segment(unsigned char marker, const std::string& data) {
    return std::string("\xFF") + static_cast<char>(marker) +
           big_endian(static_cast<std::uint32_t>(data.size() + 2), 2) + data;
}

} // namespace

std::string jpeg_bytes(int width, int height) {
    const auto number = [](int n) { return big_endian(static_cast<std::uint32_t>(n), 2); };
    std::string jpeg = "\xFF\xD8";
    jpeg += segment(0xE0, std::string("JFIF\0\1\1\0\0\1\0\1\0\0", 14));
    jpeg += segment(0xDB, std::string(1, '\0') + std::string(64, '\1'));
    jpeg +=
        segment(0xC0, std::string("\x08", 1) + number(height) + number(width) + std::string("\1\1\x11\0", 4));
    jpeg += segment(0xDA, std::string("\1\1\0\0\x3F\0", 6));
    return jpeg += std::string("\0\xFF\xD9", 3);
}

std::string png_bytes(int width, int height) {
    const auto number = [](int n) { return big_endian(static_cast<std::uint32_t>(n), 4); };
    return std::string("\x89PNG\r\n\x1A\n", 8) +
           chunk("IHDR" + number(width) + number(height) + std::string("\x08\0\0\0\0", 5)) +
           chunk(std::string("IDAT\x78\x9C\x03\0\0\0\0\1", 12)) + chunk("IEND");
}

std::string tiff_bytes(int width, int height) {
    const auto little = [](int n, int bytes) {
        const std::string big = big_endian(static_cast<std::uint32_t>(n), bytes);
        return std::string(big.rbegin(), big.rend());
    };
    const auto entry = [&](int tag, int value) {
        return little(tag, 2) + little(4, 2) + little(1, 4) + little(value, 4);
    };
    return std::string("II*\0", 4) + little(8, 4) + little(2, 2) + entry(256, width) + entry(257, height) +
           little(0, 4);
}

std::string webp_bytes() {
    return {"RIFF\x1A\0\0\0WEBPVP8L\x0D\0\0\0\x2F\0\0\0\x10\x07\x10\x11\x11\x88\x88\xFE\x07\0", 34};
}

std::string heic_bytes(int width, int height, std::string_view xmp) {
    const auto number = [](std::size_t n, int bytes) {
        return big_endian(static_cast<std::uint32_t>(n), bytes);
    };
    const auto box = [&](std::string type_and_data) {
        return number(type_and_data.size() + 4, 4).append(type_and_data);
    };
    const std::string full(4, '\0'); // version 0, no flags
    const auto entry = [&](int item, const char* type, const std::string& rest) {
        return box(std::string("infe\2\0\0\0", 8) + number(static_cast<std::size_t>(item), 2) + number(0, 2) +
                   type + rest);
    };
    const std::string before = box(std::string("ftypheic\0\0\0\0mif1heic", 20));
    const auto meta = [&](std::size_t xmp_at) {
        const std::string size =
            number(static_cast<std::size_t>(width), 4) + number(static_cast<std::size_t>(height), 4);
        const std::string extent = number(0, 2) + number(1, 2);
        return box("meta" + full + box("hdlr" + full + number(0, 4) + "pict" + std::string(13, '\0')) +
                   box("pitm" + full + number(1, 2)) +
                   box("iinf" + full + number(2, 2) + entry(1, "hvc1", std::string(1, '\0')) +
                       entry(2, "mime", std::string("\0application/rdf+xml\0", 21))) +
                   box("iprp" + box("ipco" + box("ispe" + full + size)) +
                       box("ipma" + full + number(1, 4) + number(1, 2) + std::string("\1\1", 2))) +
                   box("iloc" + full + std::string("\x44\0", 2) + number(2, 2) + number(1, 2) + extent +
                       number(xmp_at, 4) + number(0, 4) + number(2, 2) + extent + number(xmp_at, 4) +
                       number(xmp.size(), 4)));
    };
    const std::size_t xmp_at = before.size() + meta(0).size() + 8;
    return before + meta(xmp_at) + box(std::string("mdat").append(xmp));
}

void write_bytes(const std::filesystem::path& file, std::string_view bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void add_metadata(const std::filesystem::path& photo, const MadeMetadata& metadata) {
    prepare_exiv2();
    const auto image = Exiv2::ImageFactory::open(photo.string());
    image->readMetadata();
    image->setExifData(metadata.exif);
    image->setIptcData(metadata.iptc);
    if (!metadata.xmp.empty()) {
        image->setXmpPacket(metadata.xmp);
        image->writeXmpFromPacket(true);
    }
    image->writeMetadata();
}

std::string packet(std::string_view attributes, std::string_view elements) {
    std::string text = "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"" + xmp::rdf_uri +
                       "\"><rdf:Description rdf:about=\"\"";
    for (const auto& [uri, prefix] : xmp::usual_prefixes)
        if (uri != xmp::rdf_uri)
            text.append(" xmlns:").append(prefix).append("=\"").append(uri).append("\"");
    text.append(" ").append(attributes).append(">").append(elements);
    return text += "</rdf:Description></rdf:RDF></x:xmpmeta>";
}

} // namespace tp::test
