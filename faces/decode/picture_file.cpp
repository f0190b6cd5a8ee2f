// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture_file.hpp"

#include "core/files/file_system.hpp"
#include "core/files/open_file.hpp"
#include "faces/decode/raw_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <string_view>
#include <utility>

namespace tp {
namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{2} << 30;

Error cannot_be_read() { return {"The file cannot be read."}; }

struct OpenedPicture {
    OpenFile file;
    std::uintmax_t size = 0; ///< bytes
};

/// A photograph may be a link, wherever it lies: it is only looked at.
Result<OpenedPicture> opened_picture(const std::filesystem::path& file) {
    OpenFile opened(file, {.looked_at = true});
    const int error = opened.ok() ? 0 : errno;
    const auto facts = opened.ok() ? opened.facts() : facts_of_photo(file);
    if (!facts)
        return error == ENOENT || error == ENOTDIR ? Error{"There is no such file."} : cannot_be_read();
    if (facts->kind == FileFacts::Kind::folder)
        return Error{"This is a folder, not a picture."};
    if (!opened.ok() || facts->kind != FileFacts::Kind::file)
        return cannot_be_read();
    if (facts->bytes == 0)
        return Error{"The file is empty."};
    if (facts->bytes > most_bytes)
        return Error{"The file is too large to be a photograph: more than 2 gigabytes."};
    return OpenedPicture{std::move(opened), facts->bytes};
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
    const auto opened = opened_picture(file);
    if (!opened)
        return {};
    Bytes bytes(64);
    bytes.resize(opened->file.read_at(0, {reinterpret_cast<char*>(bytes.data()), bytes.size()}));
    return bytes;
}

Result<PictureFile> open_picture_file(const std::filesystem::path& file) {
    auto opened = opened_picture(file);
    if (!opened)
        return Error{opened.error()};
    Descriptor descriptor = opened->file.handed_over();
    if (!descriptor.ok())
        return cannot_be_read();
    return PictureFile{std::move(descriptor), opened->size};
}

Result<Bytes> read_bytes(const std::filesystem::path& file) {
    const auto opened = opened_picture(file);
    if (!opened)
        return Error{opened.error()};
    Bytes bytes(static_cast<std::size_t>(opened->size));
    if (opened->file.read_at(0, {reinterpret_cast<char*>(bytes.data()), bytes.size()}) != bytes.size())
        return cannot_be_read();
    return bytes;
}

} // namespace tp
