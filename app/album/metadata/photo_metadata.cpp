// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/photo_metadata.hpp"

#include "app/album/metadata/heif_boxes.hpp"
#include "app/album/metadata/metadata_size.hpp"
#include "app/album/metadata/time_text.hpp"
#include "app/album/metadata/xmp_record.hpp"
#include "audio/recordings/byte_source.hpp"
#include "core/base/utf8.hpp"
#include "core/files/file_system.hpp"
#include "core/files/file_words.hpp"
#include "core/files/foreign_folder.hpp"
#include "core/files/open_file.hpp"
#include "faces/exiv2/stated_metadata.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <string>
#include <unordered_set>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// A text of EXIF or IPTC: UTF-8, or else Latin-1, which is what older programs wrote.
std::string utf8_from(std::string text) {
    text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
    if (is_utf8(text))
        return text;
    std::string result;
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (code < 0x80) {
            result += letter;
        } else {
            result += static_cast<char>(0xC0 | (code >> 6));
            result += static_cast<char>(0x80 | (code & 0x3F));
        }
    }
    return result;
}

std::optional<Place> exif_place(const StatedMetadata& stated, std::vector<std::string>& problems) {
    if (!stated.latitude || !stated.longitude)
        return std::nullopt;
    const Place place{*stated.latitude, *stated.longitude};
    if (place.latitude == 0.0 &&
        place.longitude == 0.0) // what cameras write that have not found where they are
        return std::nullopt;
    if (std::abs(place.latitude) <= 90.0 && std::abs(place.longitude) <= 180.0)
        return place;
    problems.push_back("The position is not a place on Earth and is left out.");
    return std::nullopt;
}

RecordParts parts_from_exif(const StatedMetadata& stated) {
    RecordParts parts;
    parts.taken = exif_time(utf8_from(stated.taken), utf8_from(stated.taken_offset));
    parts.place = exif_place(stated, parts.problems);
    return parts;
}

RecordParts parts_from_iptc(const StatedMetadata& stated) {
    RecordParts parts;
    parts.taken = iptc_time(utf8_from(stated.date), utf8_from(stated.time));
    if (std::string caption = utf8_from(stated.caption); !caption.empty())
        parts.description = LanguageTexts{{"x-default", std::move(caption)}};
    std::vector<std::string> keywords;
    std::unordered_set<std::string> known;
    for (const std::string& text : stated.keywords)
        if (std::string keyword = utf8_from(text); !keyword.empty() && known.insert(keyword).second)
            keywords.push_back(std::move(keyword));
    if (!keywords.empty())
        parts.keywords = std::move(keywords);
    std::string place;
    for (const std::string& text : stated.places)
        if (const std::string name = utf8_from(text); !name.empty())
            place += (place.empty() ? "" : ", ") + name;
    if (!place.empty())
        parts.place_name = std::move(place);
    return parts;
}

/// How a HEIC or AVIF file says that it is turned; none for other files.
std::optional<int> own_orientation(const OpenFile& photo) {
    const auto bytes = FileBytes::of(photo);
    return bytes ? heif_orientation(**bytes) : std::nullopt;
}

/// What is wrong with a packet of XMP; empty where it is read.
std::string read_packet(const std::string& bytes, PhotoMetadata& metadata) {
    auto packet = XmpPacket::from(bytes);
    if (!packet)
        return packet.error();
    complete(metadata.parts, parts_from_xmp(*packet, metadata.shape));
    metadata.xmp = std::move(*packet);
    return {};
}

/// `turned`: how the file itself says that it is turned, whatever EXIF says.
PhotoMetadata metadata_from(const StatedMetadata& stated, std::optional<int> turned) {
    PhotoMetadata metadata;
    metadata.shape.width = stated.width;
    metadata.shape.height = stated.height;
    metadata.shape.orientation = turned ? *turned : stated.orientation.value_or(metadata.shape.orientation);
    std::vector<std::string> problems;
    if (stated.is_damaged)
        problems.emplace_back("The photograph's own metadata is damaged; what could be read of it is used.");
    if (stated.exif_is_damaged)
        problems.emplace_back("The photograph's EXIF is damaged.");
    complete(metadata.parts, parts_from_exif(stated));
    if (stated.xmp_is_damaged)
        problems.emplace_back("The photograph's XMP is damaged.");
    if (!stated.xmp.empty())
        if (const std::string problem = read_packet(stated.xmp, metadata); !problem.empty())
            problems.push_back("The photograph's XMP cannot be read: " + problem);
    if (stated.iptc_is_damaged)
        problems.emplace_back("The photograph's IPTC is damaged.");
    complete(metadata.parts, parts_from_iptc(stated));
    metadata.parts.problems.insert(metadata.parts.problems.begin(), problems.begin(), problems.end());
    return metadata;
}

} // namespace

Result<PhotoMetadata> photo_metadata(const fs::path& photo) {
    OpenFile opened(photo, {.looked_at = true});
    const int error = opened.ok() ? 0 : errno;
    if (error == ELOOP)
        if (const auto link = link_on_the_way(photo.parent_path()))
            return Error{left_alone(*link)};
    const auto facts = opened.ok() ? opened.facts() : facts_of_photo(photo);
    if (!facts)
        return Error{is_disks_fault(errno)
                         ? "The photograph " + quoted(photo) + " cannot be read: " + reason_of(errno)
                         : "There is no photograph " + quoted(photo) + "."};
    if (facts->kind != FileFacts::Kind::file)
        return Error{quoted(photo) + " is not a file."};
    if (!opened.ok() && is_disks_fault(error))
        return Error{"The photograph " + quoted(photo) + " cannot be read: " + reason_of(error)};
    if (!opened.ok())
        return Error{"You are not allowed to read the photograph " + quoted(photo) + "."};
    // The very file that is open, whatever has its name by now.
    const fs::path same = opened.name_of_opened();
    PhotoMetadata metadata;
    if (has_oversized_metadata(same.empty() ? fs::absolute(photo) : same)) {
        metadata.parts.problems.push_back("The photograph " + quoted(photo) +
                                          " holds more metadata than any program writes; it was not read.");
        return metadata;
    }
    const std::optional<int> turned = own_orientation(opened);
    if (const auto stated = stated_metadata(std::move(opened)))
        return metadata_from(*stated, turned);
    metadata.parts.problems.push_back("The metadata of the photograph " + quoted(photo) + " cannot be read.");
    return metadata;
}

} // namespace tp
