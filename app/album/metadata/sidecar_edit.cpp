// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/sidecar_edit.hpp"

#include "app/album/metadata/tag_list.hpp"
#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_record.hpp"
#include "app/album/metadata/xmp_text.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace tp {

namespace {

using Names = std::vector<std::string>;

bool has(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void add_name(Names& names, const std::string& name) {
    if (!name.empty() && !has(names, name))
        names.push_back(name);
}

/// One sidecar and what stands behind it, while it is being changed.
class Edit {
public:
    Edit(XmpPacket& sidecar, const Behind& behind)
        : sidecar_(sidecar), behind_(behind), parts_(parts_from_xmp(sidecar, behind.shape)) {
        complete(parts_, behind.parts);
    }

    void set_texts(const XmpName& name, const LanguageTexts& texts, bool hides) {
        XmpValue alt;
        alt.form = XmpValue::Form::alt;
        for (const bool for_all : {true, false}) // x-default goes first
            for (const auto& [language, text] : texts)
                if ((language == "x-default") == for_all) {
                    XmpValue item = XmpValue::of(text);
                    item.qualifiers.push_back({xmp::language, XmpValue::of(language)});
                    alt.items.push_back(std::move(item));
                }
        set_list(name, std::move(alt), hides);
    }

    void set_names(const XmpName& name, XmpValue::Form form, const Names& names, bool hides) {
        XmpValue list;
        list.form = form;
        for (const std::string& text : names)
            list.items.push_back(XmpValue::of(text));
        set_list(name, std::move(list), hides);
    }

    /// Faces and persons, which share names.
    void set_people(const std::optional<std::vector<FaceRegion>>& faces,
                    const std::optional<Names>& persons) {
        const auto faces_before = parts_.faces.value_or(std::vector<FaceRegion>{});
        const Names persons_before = parts_.persons.value_or(Names{});
        Names names_before;
        for (const FaceRegion& face : faces_before)
            add_name(names_before, face.name);
        Names names_of_faces;
        for (const FaceRegion& face : faces.value_or(faces_before))
            add_name(names_of_faces, face.name);

        Names all;
        for (const std::string& person : persons.value_or(persons_before))
            if (persons || !has(names_before, person) || has(names_of_faces, person))
                add_name(all, person);
        for (const std::string& name : names_of_faces)
            add_name(all, name);

        if (faces)
            set_faces(*faces);
        set_names(xmp::persons, XmpValue::Form::bag, all, has_below(xmp::persons));
        for (const std::string& name : persons_before)
            add_name(names_before, name);
        set_people_tags(xmp::digikam_tags, XmpValue::Form::seq, '/', names_before, all);
        set_people_tags(xmp::lightroom_tags, XmpValue::Form::bag, '|', names_before, all);
    }

    void set_tags(const std::vector<Tag>& tags) {
        set_list(xmp::tags, tag_list(tags, sidecar_.value(xmp::tags)), false);
    }

    bool has_below(const XmpName& name) const {
        return std::any_of(behind_.packets.begin(), behind_.packets.end(),
                           [&](const XmpPacket* packet) { return packet->value(name).has_value(); });
    }
    const RecordParts& below() const { return behind_.parts; }
    bool says(const XmpName& name) const { return sidecar_.value(name).has_value(); }

private:
    /// An empty list is only written where it says something: that what stands behind it does not count.
    void set_list(const XmpName& name, XmpValue list, bool hides) {
        if (list.items.empty() && !hides)
            sidecar_.remove(name);
        else
            sidecar_.set(name, list);
    }

    std::optional<XmpValue> value_anywhere(const XmpName& name) const {
        std::optional<XmpValue> value = sidecar_.value(name);
        for (const XmpPacket* packet : behind_.packets)
            if (!value)
                value = packet->value(name);
        return value;
    }

    void set_faces(const std::vector<FaceRegion>& faces) {
        const bool hides = has_below(xmp::regions) || has_below(xmp::microsoft_regions);
        set_regions(xmp::regions, mwg_from_faces(faces, value_anywhere(xmp::regions), behind_.shape), hides);
        if (const auto microsoft = sidecar_.value(xmp::microsoft_regions))
            set_regions(xmp::microsoft_regions, microsoft_from_faces(faces, *microsoft), hides);
    }

    /// Without regions, and without what other programs say there, they are only written to hide others.
    void set_regions(const XmpName& name, const XmpValue& regions, bool hides) {
        const bool says_something =
            std::any_of(regions.fields.begin(), regions.fields.end(), [](const XmpField& field) {
                return field.name != xmp::applied_to &&
                       (!field.value.is_list() || !field.value.items.empty());
            });
        if (says_something || hides)
            sidecar_.set(name, regions);
        else
            sidecar_.remove(name);
    }

    /// Tags below "People" in a program's tree of tags; a name that has the program's separator in it would
    /// be a branch of that tree and gets another letter there.
    void set_people_tags(const XmpName& name, XmpValue::Form form, char separator, const Names& before,
                         const Names& now) {
        const auto tag_of = [&](std::string person) {
            std::replace(person.begin(), person.end(), separator, '-');
            return std::string("People") + separator + person;
        };
        Names gone;
        for (const std::string& person : before)
            if (!has(now, person))
                gone.push_back(tag_of(person));
        Names tags;
        if (const auto value = value_anywhere(name))
            for (const std::string& tag : texts_of(*value))
                if (!has(gone, tag))
                    tags.push_back(tag);
        for (const std::string& person : now)
            add_name(tags, tag_of(person));
        set_names(name, form, tags, has_below(name));
    }

    XmpPacket& sidecar_;
    const Behind& behind_;
    RecordParts parts_;
};

} // namespace

std::string refusal(const SidecarChanges& changes) {
    if (changes.tags) {
        std::set<std::string> files;
        for (const Tag& tag : *changes.tags) {
            if (!is_file_name(tag.file) || holdable(tag.file) != tag.file)
                return "The recording " + quoted_readable(tag.file) +
                       " cannot be listed: XML cannot hold such a file name.";
            if (!files.insert(tag.file).second)
                return "The recording " + quoted_readable(tag.file) + " cannot be listed twice.";
        }
    }
    if (changes.faces)
        for (const FaceRegion& face : *changes.faces)
            for (const double share : {face.x, face.y, face.width, face.height})
                if (!(share >= 0.0) || !(share <= 1.0))
                    return "The face of " + quoted_readable(face.name) + " lies outside the photograph.";
    return {};
}

void edit(XmpPacket& sidecar, const SidecarChanges& changes, const Behind& behind) {
    Edit edit(sidecar, behind);
    if (changes.alt_text)
        edit.set_texts(xmp::alt_text, *changes.alt_text, edit.below().alt_text.has_value());
    if (changes.description)
        edit.set_texts(xmp::extended_description, *changes.description,
                       edit.below().description.has_value() || edit.says(xmp::description));
    if (changes.faces || changes.persons)
        edit.set_people(changes.faces, changes.persons);
    if (changes.keywords)
        edit.set_names(xmp::keywords, XmpValue::Form::bag, *changes.keywords,
                       edit.below().keywords.has_value());
    if (changes.tags)
        edit.set_tags(*changes.tags);
    if (changes.content_hash && changes.content_hash->empty())
        sidecar.remove(xmp::content_hash);
    else if (changes.content_hash)
        sidecar.set(xmp::content_hash, XmpValue::of(*changes.content_hash));
}

} // namespace tp
