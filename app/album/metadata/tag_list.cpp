// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/tag_list.hpp"

#include "app/album/metadata/number_text.hpp"
#include "app/album/metadata/xmp_names.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace {

constexpr int most_order = 1'000'000;

std::string text_of(const XmpValue& tag, const XmpName& field) {
    const XmpValue* value = tag.field(field);
    return value == nullptr ? std::string{} : value->text;
}

double number_of(const XmpValue& tag, const XmpName& field) {
    return number_from(text_of(tag, field)).value_or(0.0);
}

Tag tag_from(const XmpValue& value) {
    Tag tag;
    tag.file = text_of(value, xmp::tag_file);
    tag.label.kind = recording_kind(text_of(value, xmp::tag_kind)).value_or(RecordingKind::memo);
    tag.label.person = text_of(value, xmp::tag_person);
    tag.label.speaker = text_of(value, xmp::tag_speaker);
    tag.label.language = text_of(value, xmp::tag_language);
    tag.label.recorded = text_of(value, xmp::tag_recorded);
    tag.label.transcript = text_of(value, xmp::tag_transcript);
    tag.duration_s = std::max(0.0, number_of(value, xmp::tag_duration));
    tag.gain_db = number_of(value, xmp::tag_gain);
    const double order = number_of(value, xmp::tag_order);
    tag.order = order >= 1.0 && order <= most_order ? static_cast<int>(order) : 0;
    return tag;
}

void set(XmpValue& value, const XmpName& field, const std::string& text) {
    if (text.empty())
        value.remove_field(field);
    else
        value.set_field(field, XmpValue::of(text));
}

void set(XmpValue& value, const XmpName& field, double number) {
    set(value, field, number == 0.0 || !std::isfinite(number) ? std::string{} : number_text(number));
}

XmpValue value_of(const Tag& tag, XmpValue value) {
    value.form = XmpValue::Form::structure;
    set(value, xmp::tag_file, tag.file);
    set(value, xmp::tag_kind, std::string(name_of(tag.label.kind)));
    set(value, xmp::tag_person, tag.label.person);
    set(value, xmp::tag_speaker, tag.label.speaker);
    set(value, xmp::tag_language, tag.label.language);
    set(value, xmp::tag_recorded, tag.label.recorded);
    set(value, xmp::tag_transcript, tag.label.transcript);
    set(value, xmp::tag_duration, tag.duration_s);
    set(value, xmp::tag_gain, tag.gain_db);
    set(value, xmp::tag_order, static_cast<double>(tag.order));
    return value;
}

} // namespace

bool is_file_name(std::string_view name) {
    return !name.empty() && name != "." && name != ".." &&
           name.find_first_of(std::string_view("/\\\0", 3)) == std::string_view::npos;
}

std::vector<Tag> tags_from(const XmpValue& list, std::vector<std::string>& problems) {
    std::vector<Tag> tags;
    for (const XmpValue& value : list.items) {
        Tag tag = tag_from(value);
        const std::string name = '"' + readable(tag.file) + '"';
        if (!is_file_name(tag.file))
            problems.push_back("A recording is listed as " + name +
                               ", which is not a file name; it is left out.");
        else if (std::any_of(tags.begin(), tags.end(), [&](const Tag& t) { return t.file == tag.file; }))
            problems.push_back("The recording " + name + " is listed twice; the first is used.");
        else
            tags.push_back(std::move(tag));
    }
    return tags;
}

XmpValue tag_list(const std::vector<Tag>& tags, const std::optional<XmpValue>& before) {
    XmpValue list;
    list.form = XmpValue::Form::seq;
    for (const Tag& tag : tags) {
        XmpValue known;
        if (before)
            for (const XmpValue& item : before->items)
                if (text_of(item, xmp::tag_file) == tag.file)
                    known = item;
        list.items.push_back(value_of(tag, std::move(known)));
    }
    return list;
}

} // namespace tp
