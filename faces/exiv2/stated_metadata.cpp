// SPDX-License-Identifier: Apache-2.0
#include "faces/exiv2/stated_metadata.hpp"

#include "core/processes/foreign_decoder.hpp"
#include "faces/exiv2/exif_orientation.hpp"
#include "faces/exiv2/metadata_messages.hpp"
#include "faces/exiv2/prepare_exiv2.hpp"

#include <exiv2/exiv2.hpp>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>
#include <variant>

namespace tp {

namespace {

constexpr std::uint64_t most_bytes_here = std::uint64_t{2} << 30;

std::string exif_text(const Exiv2::ExifData& exif, const char* key) {
    const auto found = exif.findKey(Exiv2::ExifKey(key));
    return found == exif.end() || found->count() == 0 ? std::string{} : found->toString();
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

/// Negative where the text under `key` begins with `below_zero`.
std::optional<double> signed_degrees(std::optional<double> degrees, const Exiv2::ExifData& exif,
                                     const char* key, char below_zero) {
    return degrees && exif_text(exif, key).starts_with(below_zero) ? -*degrees : degrees;
}

void read_exif(const Exiv2::ExifData& exif, StatedMetadata& stated) {
    stated.orientation = exif_orientation(exif);
    stated.taken = exif_text(exif, "Exif.Photo.DateTimeOriginal");
    stated.taken_offset = exif_text(exif, "Exif.Photo.OffsetTimeOriginal");
    stated.latitude = signed_degrees(exif_degrees(exif, "Exif.GPSInfo.GPSLatitude"), exif,
                                     "Exif.GPSInfo.GPSLatitudeRef", 'S');
    stated.longitude = signed_degrees(exif_degrees(exif, "Exif.GPSInfo.GPSLongitude"), exif,
                                      "Exif.GPSInfo.GPSLongitudeRef", 'W');
}

/// The texts under `key` that are not empty.
std::vector<std::string> iptc_texts(const Exiv2::IptcData& iptc, const char* key, std::size_t most) {
    std::vector<std::string> texts;
    const Exiv2::IptcKey wanted(key);
    for (const Exiv2::Iptcdatum& datum : iptc) {
        if (texts.size() == most)
            break;
        if (datum.record() != wanted.record() || datum.tag() != wanted.tag())
            continue;
        if (std::string text = datum.toString(); !text.empty())
            texts.push_back(std::move(text));
    }
    return texts;
}

std::string iptc_text(const Exiv2::IptcData& iptc, const char* key) {
    auto texts = iptc_texts(iptc, key, 1);
    return texts.empty() ? std::string{} : std::move(texts.front());
}

void read_iptc(const Exiv2::IptcData& iptc, StatedMetadata& stated) {
    stated.date = iptc_text(iptc, "Iptc.Application2.DateCreated");
    stated.time = iptc_text(iptc, "Iptc.Application2.TimeCreated");
    stated.caption = iptc_text(iptc, "Iptc.Application2.Caption");
    stated.keywords = iptc_texts(iptc, "Iptc.Application2.Keywords", most_stated_keywords);
    for (const char* key :
         {"Iptc.Application2.City", "Iptc.Application2.ProvinceState", "Iptc.Application2.CountryName"})
        if (std::string place = iptc_text(iptc, key); !place.empty())
            stated.places.push_back(std::move(place));
}

/// Of some formats Exiv2 keeps only what it made of the XMP.
void read_xmp(Exiv2::Image& image, StatedMetadata& stated) {
    stated.xmp = image.xmpPacket();
    if (stated.xmp.empty() && !image.xmpData().empty())
        Exiv2::XmpParser::encode(stated.xmp, image.xmpData());
}

/// Each kind of metadata by itself, so that one that is broken does not take the others with it.
template <typename Read>
void try_to(bool& is_damaged, Read read) {
    try {
        read();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (...) {
        is_damaged = true;
    }
}

StatedMetadata stated_of(Exiv2::Image& image) {
    StatedMetadata stated;
    try_to(stated.is_damaged, [&] { image.readMetadata(); });
    stated.width = std::llabs(image.pixelWidth());
    stated.height = std::llabs(image.pixelHeight());
    try_to(stated.exif_is_damaged, [&] { read_exif(image.exifData(), stated); });
    try_to(stated.xmp_is_damaged, [&] { read_xmp(image, stated); });
    try_to(stated.iptc_is_damaged, [&] { read_iptc(image.iptcData(), stated); });
    return stated;
}

std::optional<StatedMetadata> stated_here(const OpenFile& file) {
    const auto facts = file.facts();
    if (!facts || facts->bytes > most_bytes_here)
        return std::nullopt;
    try {
        std::vector<unsigned char> bytes(static_cast<std::size_t>(facts->bytes));
        const auto read = file.read_at(0, {reinterpret_cast<char*>(bytes.data()), bytes.size()});
        return read == bytes.size() ? stated_in(bytes) : std::nullopt;
    } catch (const std::bad_alloc&) {
        return std::nullopt;
    }
}

} // namespace

std::optional<StatedMetadata> stated_in(std::span<const unsigned char> file) {
    prepare_exiv2();
    try {
        const auto image = Exiv2::ImageFactory::open(file.data(), static_cast<long>(file.size()));
        return stated_of(*image);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (...) {
        return std::nullopt;
    }
}

std::optional<StatedMetadata> stated_metadata(OpenFile file) {
    ForeignDecoders* const decoders = foreign_decoders();
    const auto helper = decoders != nullptr ? std::optional(decoders->metadata.lease()) : std::nullopt;
    if (!helper || !*helper)
        return stated_here(file);
    Descriptor descriptor = file.handed_over();
    if (!descriptor.ok())
        return std::nullopt;
    auto said = (**helper)->ask(metadata_question(std::move(descriptor)));
    auto* const answer = std::get_if<Message>(&said);
    return answer != nullptr ? metadata_in(*answer) : std::nullopt;
}

} // namespace tp
