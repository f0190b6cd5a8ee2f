// SPDX-License-Identifier: Apache-2.0
#include "sidecar_check.hpp"

#include "app/album/metadata/sidecar_edit.hpp"
#include "app/album/metadata/tag_list.hpp"
#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_record.hpp"
#include "core/base/utf8.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tp::test {

namespace {

bool inside(double share) { return share >= 0.0 && share <= 1.0; }

/// What a packet says, with named faces first, as they are written.
PhotoRecord record_in(const XmpPacket& packet, const PictureShape& shape) {
    PhotoRecord record = record_of(parts_from_xmp(packet, shape), shape);
    std::stable_partition(record.faces.begin(), record.faces.end(),
                          [](const FaceRegion& face) { return !face.name.empty(); });
    return record;
}

std::string changed(const XmpPacket& packet, const XmpPacket& again) {
    for (const XmpName& name : packet.names())
        if (packet.value(name) != again.value(name))
            return "the value of " + name.name + " changed";
    return {};
}

SidecarChanges everything_in(const PhotoRecord& record) {
    SidecarChanges changes{record.alt_text, record.description, record.faces,       record.persons,
                           record.keywords, record.tags,        record.content_hash};
    return changes;
}

/// A name that is longer in what was written is one of a face, which persons always contain.
bool contains(const std::vector<std::string>& all, const std::vector<std::string>& some) {
    return std::all_of(some.begin(), some.end(), [&](const std::string& text) {
        return std::find(all.begin(), all.end(), text) != all.end();
    });
}

std::string complaint(std::string_view bytes, const PictureShape& shape) {
    auto packet = XmpPacket::from(bytes);
    if (!packet)
        return packet.error().size() > 10 && packet.error().ends_with('.') ? ""
                                                                           : "no words: " + packet.error();
    const auto copy = XmpPacket::from(packet->bytes());
    if (!copy)
        return "what was kept cannot be read: " + copy.error();
    if (std::string fault = changed(*packet, *copy); !fault.empty())
        return fault;
    const PhotoRecord before = record_in(*packet, shape);
    if (std::string fault = complaint_about_record(before); !fault.empty())
        return fault;

    const SidecarChanges changes = everything_in(before);
    if (!refusal(changes).empty())
        return {}; // names of files that XML cannot hold
    Behind behind;
    behind.shape = shape;
    edit(*packet, changes, behind);
    const auto written = XmpPacket::from(packet->bytes());
    if (!written)
        return "what was written cannot be read: " + written.error();
    if (std::string fault = changed(*packet, *written); !fault.empty())
        return fault;
    const PhotoRecord after = record_in(*written, shape);
    if (after.alt_text != before.alt_text || after.description != before.description)
        return "a description changed";
    if (after.faces != before.faces)
        return "a face changed";
    if (after.tags != before.tags || after.content_hash != before.content_hash)
        return "a tag changed";
    if (after.keywords != before.keywords || !contains(after.persons, before.persons))
        return "a keyword or person changed";
    return {};
}

} // namespace

std::string complaint_about_record(const PhotoRecord& record) {
    for (const FaceRegion& face : record.faces)
        if (!inside(face.x) || !inside(face.y) || !inside(face.width) || !inside(face.height))
            return "a face lies outside";
    for (const Tag& tag : record.tags)
        if (!is_file_name(tag.file) || !std::isfinite(tag.duration_s) || !std::isfinite(tag.gain_db) ||
            tag.duration_s < 0.0 || tag.order < 0)
            return "a tag makes no sense";
    if (record.place &&
        (!(std::abs(record.place->latitude) <= 90.0) || !(std::abs(record.place->longitude) <= 180.0)))
        return "the place is not on Earth";
    for (const std::string& problem : record.problems)
        if (!problem.ends_with('.') || !is_utf8(problem))
            return "no sentence: " + problem;
    for (const auto& texts : {record.keywords, record.persons})
        if (!std::all_of(texts.begin(), texts.end(), is_utf8))
            return "a text is not UTF-8";
    return {};
}

std::string complaint_about_sidecar(std::string_view bytes) { return complaint(bytes, {400, 300, 1}); }

std::string complaint_about_regions(std::string_view properties) {
    std::string text = "<rdf:RDF xmlns:rdf=\"" + xmp::rdf_uri + "\"";
    for (const auto& [uri, prefix] : xmp::usual_prefixes)
        if (uri != xmp::rdf_uri)
            text.append(" xmlns:").append(prefix).append("=\"").append(uri).append("\"");
    text.append("><rdf:Description>").append(properties).append("</rdf:Description></rdf:RDF>");
    for (const PictureShape& shape : {PictureShape{}, PictureShape{400, 300, 1}, PictureShape{400, 300, 6}})
        if (std::string fault = complaint(text, shape); !fault.empty())
            return fault;
    return {};
}

} // namespace tp::test
