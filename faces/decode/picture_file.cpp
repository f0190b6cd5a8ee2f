// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture_file.hpp"

#include "core/files/open_file.hpp"
#include "faces/decode/raw_file.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace tp {
namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{2} << 30;

Error cannot_be_read() { return {"The file cannot be read."}; }

/// Of a file that may be read as a picture, in bytes.
Result<std::uintmax_t> size_to_read(const std::filesystem::path& file) {
    std::error_code failure;
    const std::filesystem::file_status status = std::filesystem::status(file, failure);
    if (status.type() == std::filesystem::file_type::not_found)
        return Error{"There is no such file."};
    if (std::filesystem::is_directory(status))
        return Error{"This is a folder, not a picture."};
    if (failure || !std::filesystem::is_regular_file(status))
        return cannot_be_read();
    const std::uintmax_t size = std::filesystem::file_size(file, failure);
    if (failure)
        return cannot_be_read();
    if (size == 0)
        return Error{"The file is empty."};
    if (size > most_bytes)
        return Error{"The file is too large to be a photograph: more than 2 gigabytes."};
    return size;
}

} // namespace

PictureKind kind_of(const Bytes& bytes) {
    const auto has = [&](std::size_t at, std::string_view text) {
        return bytes.size() >= at + text.size() &&
               std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                          [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; });
    };
    using namespace std::string_view_literals;
    if (has(0, "\xFF\xD8\xFF"sv))
        return PictureKind::jpeg;
    if (has(0, "\x89PNG\r\n\x1A\n"sv))
        return PictureKind::png;
    if (has(0, "RIFF"sv) && has(8, "WEBP"sv))
        return PictureKind::webp;
    if (is_raw(bytes))
        return PictureKind::raw;
    if (has(0, "II*\0"sv) || has(0, "MM\0*"sv))
        return PictureKind::tiff;
    if (has(0, "BM"sv) && has(6, "\0\0\0\0"sv))
        return PictureKind::bmp;
    if (has(4, "jP  \r\n\x87\n"sv))
        return PictureKind::jpeg2000;
    if (has(4, "ftyp"sv)) {
        for (std::string_view brand : {"avif"sv, "avis"sv})
            if (has(8, brand))
                return PictureKind::avif;
        // ISO/IEC 23008-12, annex B, and MIAF (23000-22): what a file of these brands holds may be AV1 all
        // the same.
        for (std::string_view brand :
             {"heic"sv, "heix"sv, "heim"sv, "heis"sv, "hevc"sv, "hevx"sv, "mif1"sv, "msf1"sv, "miaf"sv})
            if (has(8, brand))
                return PictureKind::heic;
    }
    return PictureKind::unknown;
}

Bytes first_bytes(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(file, failure)) // a pipe would not answer
        return {};
    Bytes bytes(64);
    std::ifstream stream(file, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

Result<PictureFile> open_picture_file(const std::filesystem::path& file) {
    const Result<std::uintmax_t> size = size_to_read(file);
    if (!size)
        return Error{size.error()};
    Descriptor descriptor = OpenFile(file, {}).handed_over();
    if (!descriptor.ok())
        return cannot_be_read();
    return PictureFile{std::move(descriptor), *size};
}

Result<Bytes> read_bytes(const std::filesystem::path& file) {
    const Result<std::uintmax_t> size = size_to_read(file);
    if (!size)
        return Error{size.error()};
    Bytes bytes(static_cast<std::size_t>(*size));
    std::ifstream stream(file, std::ios::binary);
    if (!stream || !stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(*size)))
        return cannot_be_read();
    return bytes;
}

} // namespace tp
