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
#include "faces/exiv2/exif_orientation.hpp"
#include "faces/exiv2/prepare_exiv2.hpp"

#include <exiv2/exiv2.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
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

std::string exif_text(const Exiv2::ExifData& exif, const char* key) {
    const auto found = exif.findKey(Exiv2::ExifKey(key));
    return found == exif.end() || found->count() == 0 ? std::string{} : utf8_from(found->toString());
}

/// Degrees, minutes and seconds as three fractions; none where one is missing or makes no sense.
std::optional<double> exif_degrees(const Exiv2::ExifData& exif, const char* key) {
    const auto found = exif.findKey(Exiv2::ExifKey(key));
    if (found == exif.end() || found->count() < 1)
        return std::nullopt;
    double sum = 0.0;
    double unit = 1.0;
    for (long i = 0; i < std::min(3L, static_cast<long>(found->count())); ++i, unit /= 60.0) {
        const Exiv2::Rational part = found->toRational(i);
        if (part.second == 0 || part.first < 0 || part.second < 0)
            return std::nullopt;
        sum += unit * static_cast<double>(part.first) / static_cast<double>(part.second);
    }
    return sum;
}

std::optional<Place> exif_place(const Exiv2::ExifData& exif, std::vector<std::string>& problems) {
    auto latitude = exif_degrees(exif, "Exif.GPSInfo.GPSLatitude");
    auto longitude = exif_degrees(exif, "Exif.GPSInfo.GPSLongitude");
    if (!latitude || !longitude)
        return std::nullopt;
    if (*latitude == 0.0 && *longitude == 0.0) // what cameras write that have not found where they are
        return std::nullopt;
    if (exif_text(exif, "Exif.GPSInfo.GPSLatitudeRef").starts_with('S'))
        *latitude = -*latitude;
    if (exif_text(exif, "Exif.GPSInfo.GPSLongitudeRef").starts_with('W'))
        *longitude = -*longitude;
    if (std::abs(*latitude) <= 90.0 && std::abs(*longitude) <= 180.0)
        return Place{*latitude, *longitude};
    problems.push_back("The position is not a place on Earth and is left out.");
    return std::nullopt;
}

RecordParts parts_from_exif(const Exiv2::ExifData& exif) {
    RecordParts parts;
    parts.taken = exif_time(exif_text(exif, "Exif.Photo.DateTimeOriginal"),
                            exif_text(exif, "Exif.Photo.OffsetTimeOriginal"));
    parts.place = exif_place(exif, parts.problems);
    return parts;
}

std::vector<std::string> iptc_texts(const Exiv2::IptcData& iptc, const char* key) {
    std::vector<std::string> texts;
    const Exiv2::IptcKey wanted(key);
    for (const Exiv2::Iptcdatum& datum : iptc) {
        if (datum.key() != wanted.key())
            continue;
        std::string text = utf8_from(datum.toString());
        if (!text.empty() && std::find(texts.begin(), texts.end(), text) == texts.end())
            texts.push_back(std::move(text));
    }
    return texts;
}

std::string iptc_text(const Exiv2::IptcData& iptc, const char* key) {
    const auto texts = iptc_texts(iptc, key);
    return texts.empty() ? std::string{} : texts.front();
}

RecordParts parts_from_iptc(const Exiv2::IptcData& iptc) {
    RecordParts parts;
    parts.taken = iptc_time(iptc_text(iptc, "Iptc.Application2.DateCreated"),
                            iptc_text(iptc, "Iptc.Application2.TimeCreated"));
    if (std::string caption = iptc_text(iptc, "Iptc.Application2.Caption"); !caption.empty())
        parts.description = LanguageTexts{{"x-default", std::move(caption)}};
    if (auto keywords = iptc_texts(iptc, "Iptc.Application2.Keywords"); !keywords.empty())
        parts.keywords = std::move(keywords);
    std::string place;
    for (const char* key :
         {"Iptc.Application2.City", "Iptc.Application2.ProvinceState", "Iptc.Application2.CountryName"})
        if (const std::string name = iptc_text(iptc, key); !name.empty())
            place += (place.empty() ? "" : ", ") + name;
    if (!place.empty())
        parts.place_name = std::move(place);
    return parts;
}

/// The XMP of a photograph; of some formats Exiv2 only keeps what it made of it.
std::string xmp_of(Exiv2::Image& image) {
    if (!image.xmpPacket().empty() || image.xmpData().empty())
        return image.xmpPacket();
    std::string packet;
    Exiv2::XmpParser::encode(packet, image.xmpData());
    return packet;
}

/// Each kind of metadata by itself, so that one that is broken does not take the others with it.
template <typename Read>
void try_to(std::vector<std::string>& problems, const char* sentence, Read read) {
    try {
        read();
    } catch (...) {
        problems.emplace_back(sentence);
    }
}

/// How a HEIC or AVIF file says that it is turned; none for other files.
std::optional<int> own_orientation(const OpenFile& photo) {
    const auto bytes = FileBytes::of(photo);
    return bytes ? heif_orientation(**bytes) : std::nullopt;
}

/// `turned`: how the file itself says that it is turned, whatever EXIF says.
void read_image(Exiv2::Image& image, std::optional<int> turned, PhotoMetadata& metadata) {
    std::vector<std::string> problems;
    try_to(problems, "The photograph's own metadata is damaged; what could be read of it is used.",
           [&] { image.readMetadata(); });
    metadata.shape.width = std::llabs(image.pixelWidth());
    metadata.shape.height = std::llabs(image.pixelHeight());
    try_to(problems, "The photograph's EXIF is damaged.", [&] {
        metadata.shape.orientation = exif_orientation(image.exifData()).value_or(metadata.shape.orientation);
        complete(metadata.parts, parts_from_exif(image.exifData()));
    });
    metadata.shape.orientation = turned.value_or(metadata.shape.orientation);
    try_to(problems, "The photograph's XMP is damaged.", [&] {
        const std::string bytes = xmp_of(image);
        if (bytes.empty())
            return;
        auto packet = XmpPacket::from(bytes);
        if (!packet) {
            problems.push_back("The photograph's XMP cannot be read: " + packet.error());
            return;
        }
        complete(metadata.parts, parts_from_xmp(*packet, metadata.shape));
        metadata.xmp = std::move(*packet);
    });
    try_to(problems, "The photograph's IPTC is damaged.",
           [&] { complete(metadata.parts, parts_from_iptc(image.iptcData())); });
    metadata.parts.problems.insert(metadata.parts.problems.begin(), problems.begin(), problems.end());
}

} // namespace

Result<PhotoMetadata> photo_metadata(const fs::path& photo) {
    const OpenFile opened(photo, {.looked_at = true});
    const int error = opened.ok() ? 0 : errno;
    if (error == ELOOP)
        if (const auto link = link_on_the_way(photo.parent_path()))
            return Error{left_alone(*link)};
    const auto facts = opened.ok() ? opened.facts() : facts_of_photo(photo);
    if (!facts)
        return Error{"There is no photograph " + quoted(photo) + "."};
    if (facts->kind != FileFacts::Kind::file)
        return Error{quoted(photo) + " is not a file."};
    if (!opened.ok())
        return Error{"You are not allowed to read the photograph " + quoted(photo) + "."};
    PhotoMetadata metadata;
    // The very file that is open, whatever has its name by now.
    const fs::path same = opened.name_of_opened();
    const fs::path name = same.empty() ? fs::absolute(photo) : same;
    if (has_oversized_metadata(name)) {
        metadata.parts.problems.push_back("The photograph " + quoted(photo) +
                                          " holds more metadata than any program writes; it was not read.");
        return metadata;
    }
    prepare_exiv2();
    try {
        // By a whole path, because the factory takes some names ("-", "data:…") for something else than a file.
        const auto image = Exiv2::ImageFactory::open(name.string(), false);
        read_image(*image, own_orientation(opened), metadata);
    } catch (...) {
        metadata.parts.problems.push_back("The metadata of the photograph " + quoted(photo) +
                                          " cannot be read.");
    }
    return metadata;
}

} // namespace tp
