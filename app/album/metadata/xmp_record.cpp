// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/xmp_record.hpp"

#include "app/album/metadata/number_text.hpp"
#include "app/album/metadata/tag_list.hpp"
#include "app/album/metadata/time_text.hpp"
#include "app/album/metadata/xmp_names.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace tp {

namespace {

/// "48,12.5N" or "48,12,30N" (XMP specification part 2, GPSCoordinate).
std::optional<double> degrees(std::string_view text, char positive, char negative) {
    if (text.empty() || (text.back() != positive && text.back() != negative))
        return std::nullopt;
    const double sign = text.back() == positive ? 1.0 : -1.0;
    text.remove_suffix(1);
    double sum = 0.0;
    double unit = 1.0;
    for (bool more = true; more; unit /= 60.0) {
        const std::size_t comma = text.find(',');
        const auto part = number_from(text.substr(0, comma));
        if (!part || *part < 0.0 || unit < 1.0 / 3600.0)
            return std::nullopt;
        sum += *part * unit;
        more = comma != std::string_view::npos;
        text.remove_prefix(more ? comma + 1 : text.size());
    }
    return sign * sum;
}

std::string text_in(const XmpPacket& packet, const XmpName& name) {
    const auto value = packet.value(name);
    const auto texts = value ? texts_of(*value) : std::vector<std::string>{};
    return texts.empty() ? std::string{} : texts.front();
}

std::optional<Place> place_of(const XmpPacket& packet, std::vector<std::string>& problems) {
    const std::string latitude = text_in(packet, xmp::latitude);
    const std::string longitude = text_in(packet, xmp::longitude);
    if (latitude.empty() && longitude.empty())
        return std::nullopt;
    const auto north = degrees(latitude, 'N', 'S');
    const auto east = degrees(longitude, 'E', 'W');
    if (north && east && std::abs(*north) <= 90.0 && std::abs(*east) <= 180.0)
        return Place{*north, *east};
    problems.push_back("The position is not a place on Earth and is left out.");
    return std::nullopt;
}

std::optional<std::string> joined(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names)
        if (!name.empty())
            all += (all.empty() ? "" : ", ") + name;
    return all.empty() ? std::nullopt : std::optional(all);
}

std::optional<std::string> place_name_of(const XmpPacket& packet) {
    if (const auto locations = packet.value(xmp::location_created)) {
        const XmpValue& location = locations->items.empty() ? *locations : locations->items.front();
        const auto part = [&](const XmpName& name) {
            const XmpValue* value = location.field(name);
            const auto texts = value == nullptr ? std::vector<std::string>{} : texts_of(*value);
            return texts.empty() ? std::string{} : texts.front();
        };
        if (auto name =
                joined({part(xmp::location_city), part(xmp::location_region), part(xmp::location_country)}))
            return name;
    }
    return joined({text_in(packet, xmp::city), text_in(packet, xmp::region), text_in(packet, xmp::country)});
}

std::optional<std::string> taken_of(const XmpPacket& packet, std::vector<std::string>& problems) {
    for (const XmpName& name : {xmp::date_taken, xmp::date_created, xmp::create_date}) {
        const std::string text = text_in(packet, name);
        if (text.empty())
            continue;
        if (auto time = xmp_time(text))
            return time;
        problems.push_back("The date \"" + readable(text) + "\" is in no calendar and is left out.");
    }
    return std::nullopt;
}

std::optional<LanguageTexts> languages_of(const XmpPacket& packet, const XmpName& name) {
    const auto value = packet.value(name);
    if (!value)
        return std::nullopt;
    LanguageTexts texts;
    const auto add = [&](const XmpValue& item) {
        const std::string language = item.language();
        if (!item.text.empty())
            texts.emplace(language.empty() ? "x-default" : language, item.text);
    };
    if (value->is_list())
        std::for_each(value->items.begin(), value->items.end(), add);
    else
        add(*value);
    return texts;
}

std::optional<std::vector<std::string>> list_of(const XmpPacket& packet, const XmpName& name) {
    const auto value = packet.value(name);
    return value ? std::optional(texts_of(*value)) : std::nullopt;
}

std::optional<std::vector<FaceRegion>> faces_of(const XmpPacket& packet, const PictureShape& shape,
                                                std::vector<std::string>& problems) {
    if (const auto regions = packet.value(xmp::regions))
        return faces_from_mwg(*regions, shape, problems);
    if (const auto info = packet.value(xmp::microsoft_regions))
        return faces_from_microsoft(*info, problems);
    return std::nullopt;
}

} // namespace

std::vector<std::string> texts_of(const XmpValue& value) {
    std::vector<std::string> texts;
    const auto add = [&](const XmpValue& item) {
        if (!item.text.empty() && std::find(texts.begin(), texts.end(), item.text) == texts.end())
            texts.push_back(item.text);
    };
    if (value.is_list())
        std::for_each(value.items.begin(), value.items.end(), add);
    else
        add(value);
    return texts;
}

RecordParts parts_from_xmp(const XmpPacket& packet, const PictureShape& shape) {
    RecordParts parts;
    parts.taken = taken_of(packet, parts.problems);
    parts.place = place_of(packet, parts.problems);
    parts.place_name = place_name_of(packet);
    parts.alt_text = languages_of(packet, xmp::alt_text);
    parts.description = languages_of(packet, xmp::extended_description);
    if (!parts.description)
        parts.description = languages_of(packet, xmp::description);
    parts.faces = faces_of(packet, shape, parts.problems);
    parts.persons = list_of(packet, xmp::persons);
    parts.keywords = list_of(packet, xmp::keywords);
    if (const auto tags = packet.value(xmp::tags))
        parts.tags = tags_from(*tags, parts.problems);
    if (const std::string hash = text_in(packet, xmp::content_hash); !hash.empty())
        parts.content_hash = hash;
    return parts;
}

PhotoRecord record_of(RecordParts parts, const PictureShape& shape) {
    PhotoRecord record;
    record.orientation = shape.orientation;
    record.width = shape.width;
    record.height = shape.height;
    record.taken = std::move(parts.taken).value_or(std::string{});
    record.place = parts.place;
    record.place_name = std::move(parts.place_name).value_or(std::string{});
    record.alt_text = std::move(parts.alt_text).value_or(LanguageTexts{});
    record.description = std::move(parts.description).value_or(LanguageTexts{});
    record.faces = std::move(parts.faces).value_or(std::vector<FaceRegion>{});
    record.persons = std::move(parts.persons).value_or(std::vector<std::string>{});
    record.keywords = std::move(parts.keywords).value_or(std::vector<std::string>{});
    record.tags = std::move(parts.tags).value_or(std::vector<Tag>{});
    record.content_hash = std::move(parts.content_hash).value_or(std::string{});
    record.problems = std::move(parts.problems);
    return record;
}

} // namespace tp
