// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/merge.hpp"

#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_record.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace tp {

namespace {

/// As far apart as two people may mark one face.
constexpr double same_face = 0.05;

/// Of two versions of something both are told: what it is now, and what the other said.
std::string told(const std::string& what, std::string_view now, std::string_view other) {
    return what + " was " + quoted_readable(other) + " in another copy; it is " + quoted_readable(now) + " now.";
}

/// What a merge of records takes care of.
bool is_merged(const XmpName& name) {
    return name == xmp::alt_text || name == xmp::extended_description || name == xmp::persons ||
           name == xmp::keywords || name == xmp::regions || name == xmp::microsoft_regions ||
           name == xmp::tags || name == xmp::content_hash;
}

class Merger {
public:
    Merger(const RecordParts& current, const RecordParts& other, bool other_is_newer)
        : current_(current), other_(other), other_is_newer_(other_is_newer) {}

    Merge run() {
        texts("The short description", current_.alt_text, other_.alt_text, merge_.changes.alt_text);
        texts("The description", current_.description, other_.description, merge_.changes.description);
        unite(current_.persons, other_.persons, merge_.changes.persons);
        unite(current_.keywords, other_.keywords, merge_.changes.keywords);
        faces();
        tags();
        hash();
        return std::move(merge_);
    }

private:
    void texts(const std::string& what, const std::optional<LanguageTexts>& current,
               const std::optional<LanguageTexts>& other, std::optional<LanguageTexts>& change) {
        if (!other)
            return;
        LanguageTexts all = current.value_or(LanguageTexts{});
        for (const auto& [language, text] : *other) {
            const auto [place, added] = all.emplace(language, text);
            if (!added && place->second != text)
                merge_.told.push_back(
                    told(language == "x-default" ? what : what + " in " + quoted_readable(language), place->second,
                         text));
        }
        if (!current || all != *current)
            change = std::move(all);
    }

    void unite(const std::optional<std::vector<std::string>>& current,
               const std::optional<std::vector<std::string>>& other,
               std::optional<std::vector<std::string>>& change) const {
        if (!other)
            return;
        std::vector<std::string> all = current.value_or(std::vector<std::string>{});
        for (const std::string& text : *other)
            if (std::find(all.begin(), all.end(), text) == all.end())
                all.push_back(text);
        if (!current || all != *current)
            change = std::move(all);
    }

    void faces() {
        if (!other_.faces)
            return;
        std::vector<FaceRegion> all = current_.faces.value_or(std::vector<FaceRegion>{});
        for (const FaceRegion& face : *other_.faces) {
            const auto found = std::find_if(all.begin(), all.end(), [&](const FaceRegion& known) {
                return std::abs(known.x - face.x) < same_face && std::abs(known.y - face.y) < same_face;
            });
            if (found == all.end()) {
                all.push_back(face);
            } else if (found->name.empty()) {
                found->name = face.name;
            } else if (!face.name.empty() && face.name != found->name) {
                merge_.told.push_back(told("The name of a face", found->name, face.name));
            }
        }
        std::stable_partition(all.begin(), all.end(),
                              [](const FaceRegion& face) { return !face.name.empty(); });
        if (!current_.faces || all != *current_.faces)
            merge_.changes.faces = std::move(all);
    }

    /// The newer of two different texts, or the one that is there; both are told where they differ.
    void label(const std::string& what, std::string& current, const std::string& other) {
        if (other.empty() || other == current)
            return;
        if (current.empty()) {
            current = other;
            return;
        }
        std::string loser = other;
        if (other_is_newer_)
            std::swap(current, loser);
        merge_.told.push_back(told(what, current, loser));
    }

    template <typename T>
    void number(T& current, const T& other) const {
        if (current == T{} || (other_is_newer_ && other != T{}))
            current = other;
    }

    void tag(Tag& current, const Tag& other) {
        const std::string whose = "of the recording " + quoted_readable(current.file);
        if (other.label.kind != current.label.kind) {
            const auto now = other_is_newer_ ? other.label.kind : current.label.kind;
            const auto before = other_is_newer_ ? current.label.kind : other.label.kind;
            current.label.kind = now;
            merge_.told.push_back(told("The kind " + whose, name_of(now), name_of(before)));
        }
        label("The person " + whose, current.label.person, other.label.person);
        label("The speaker " + whose, current.label.speaker, other.label.speaker);
        label("The language " + whose, current.label.language, other.label.language);
        label("The time " + whose, current.label.recorded, other.label.recorded);
        label("The transcript " + whose, current.label.transcript, other.label.transcript);
        number(current.duration_s, other.duration_s);
        number(current.gain_db, other.gain_db);
        number(current.order, other.order);
    }

    void tags() {
        if (!other_.tags)
            return;
        std::vector<Tag> all = current_.tags.value_or(std::vector<Tag>{});
        for (const Tag& other : *other_.tags) {
            const auto found = std::find_if(all.begin(), all.end(),
                                            [&](const Tag& known) { return known.file == other.file; });
            if (found == all.end())
                all.push_back(other);
            else
                tag(*found, other);
        }
        if (!current_.tags || all != *current_.tags)
            merge_.changes.tags = std::move(all);
    }

    void hash() {
        if (!other_.content_hash)
            return;
        if (!current_.content_hash)
            merge_.changes.content_hash = other_.content_hash;
        else if (*other_.content_hash != *current_.content_hash)
            merge_.told.push_back(
                told("The fingerprint of the photograph", *current_.content_hash, *other_.content_hash));
    }

    const RecordParts& current_;
    const RecordParts& other_;
    bool other_is_newer_;
    Merge merge_;
};

/// Adds what only `other` has of what other programs wrote, and unites their lists of tags. Tells which of their entries differ.
std::vector<std::string> add_foreign(XmpPacket& current, const XmpPacket& other) {
    std::string differing;
    for (const XmpName& name : other.names()) {
        const auto theirs = other.value(name);
        const auto ours = current.value(name);
        if (!theirs || is_merged(name))
            continue;
        if (!ours) {
            current.set(name, *theirs);
        } else if (name == xmp::digikam_tags || name == xmp::lightroom_tags) {
            XmpValue all = *ours;
            for (const XmpValue& item : theirs->items)
                if (std::find(all.items.begin(), all.items.end(), item) == all.items.end())
                    all.items.push_back(item);
            if (all != *ours)
                current.set(name, all);
        } else if (*ours != *theirs) {
            differing += (differing.empty() ? "" : ", ") + readable(name.name);
        }
    }
    if (differing.empty())
        return {};
    return {"What other programs wrote differs in: " + differing + ". The other version is in the copy."};
}

} // namespace

Merge merged(const RecordParts& current, const RecordParts& other, bool other_is_newer) {
    return Merger(current, other, other_is_newer).run();
}

RecordParts added_meanwhile(RecordParts parts) {
    RecordParts added;
    added.keywords = std::move(parts.keywords);
    return added;
}

std::vector<std::string> bring_in(XmpPacket& sidecar, const XmpPacket& other, const RecordParts& parts,
                                  bool other_is_newer, const Behind& behind) {
    Merge merge = merged(parts_from_xmp(sidecar, behind.shape), parts, other_is_newer);
    const auto foreign = add_foreign(sidecar, other);
    merge.told.insert(merge.told.end(), foreign.begin(), foreign.end());
    edit(sidecar, merge.changes, behind);
    return merge.told;
}

} // namespace tp
