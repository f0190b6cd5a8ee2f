// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/photo_content.hpp"

#include "app/album/metadata/photo_name.hpp"
#include "core/files/open_file.hpp"

#include <QCryptographicHash>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>
#include <vector>

namespace tp {

namespace {

/// Major brands of HEIC (ISO/IEC 23008-12, annex B), AVIF and CR3 ("crx" and a blank).
constexpr std::array<std::string_view, 12> picture_brands{"heic", "heix", "heim", "heis", "hevc", "hevx",
                                                          "mif1", "msf1", "miaf", "avif", "avis", "crx"};
/// How a raw file of Olympus or Panasonic begins, in the place of a TIFF's "II*" or "MM"; others begin as a
/// TIFF does.
constexpr std::array<std::string_view, 4> raw_beginnings{"IIRO", "IIRS", "MMOR",
                                                         std::string_view("IIU\0", 4)};

std::optional<PhotoContent> read_open_file(OpenFile& file, const std::stop_token& stop, int& error) {
    std::vector<char> block(1 << 16);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    bool first = true;
    while (!stop.stop_requested()) {
        const std::int64_t count = file.read(block);
        if (count < 0) {
            error = errno;
            return std::nullopt;
        }
        const auto size = static_cast<std::size_t>(count);
        if (std::exchange(first, false) && !begins_like_photo({block.data(), size}))
            return PhotoContent{};
        hash.addData({block.data(), static_cast<qsizetype>(size)});
        if (size < block.size())
            return PhotoContent{true, hash.result().toStdString()};
    }
    return std::nullopt;
}

} // namespace

bool may_be_photo(std::string_view name) {
    return name.find('.') == std::string_view::npos || has_photo_name(name);
}

bool begins_like_photo(std::string_view bytes) {
    using namespace std::string_view_literals;
    const auto at = [&](std::size_t place, std::string_view what) {
        return bytes.size() >= place + what.size() && bytes.substr(place, what.size()) == what;
    };
    return at(0, "\xFF\xD8\xFF") || at(0, "\x89PNG\r\n\x1A\n") || (at(0, "RIFF") && at(8, "WEBP")) ||
           at(0, "II*\0"sv) || at(0, "MM\0*"sv) ||
           std::any_of(raw_beginnings.begin(), raw_beginnings.end(),
                       [&](std::string_view beginning) { return at(0, beginning); }) ||
           (at(4, "ftyp") && std::any_of(picture_brands.begin(), picture_brands.end(),
                                         [&](std::string_view brand) { return at(8, brand); }));
}

std::optional<PhotoContent> read_photo_content(const std::filesystem::path& file, const std::stop_token& stop,
                                               int& error) {
    error = 0;
    OpenFile opened(file, {.looked_at = true});
    if (!opened.ok()) {
        error = errno;
        return std::nullopt;
    }
    const auto facts = opened.facts();
    if (!facts || facts->kind != FileFacts::Kind::file) // a pipe may never end
        return PhotoContent{};
    return read_open_file(opened, stop, error);
}

} // namespace tp
