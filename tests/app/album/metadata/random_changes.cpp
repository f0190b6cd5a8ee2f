// SPDX-License-Identifier: Apache-2.0
#include "random_changes.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace tp::test {

namespace {

std::size_t below(std::mt19937_64& random, std::size_t n) { return static_cast<std::size_t>(random() % n); }

double share(std::mt19937_64& random) { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }

LanguageTexts random_texts(std::mt19937_64& random) {
    constexpr std::array<const char*, 5> languages = {"x-default", "de-AT", "en", "he", "zh-Hant-TW"};
    LanguageTexts texts;
    for (std::size_t i = below(random, 4); i > 0; --i)
        texts.emplace(languages[below(random, languages.size())], random_text(random));
    return texts;
}

template <typename T>
void add_once(std::vector<T>& list, T value) {
    if (std::find(list.begin(), list.end(), value) == list.end())
        list.push_back(std::move(value));
}

std::vector<std::string> random_list(std::mt19937_64& random) {
    std::vector<std::string> list;
    for (std::size_t i = below(random, 5); i > 0; --i)
        add_once(list, random_text(random));
    return list;
}

Tag random_tag(std::mt19937_64& random, int number) {
    const auto maybe = [&] { return below(random, 3) == 0 ? std::string{} : random_text(random); };
    Tag tag;
    tag.file = "2026-05-01T101500-" + std::to_string(number) + " <ü>.flac";
    tag.label.kind = static_cast<RecordingKind>(below(random, 5));
    tag.label.person = maybe();
    tag.label.speaker = maybe();
    tag.label.language = below(random, 2) == 0 ? "de-AT" : "";
    tag.label.recorded = below(random, 2) == 0 ? "2026-05-01T10:15:00+02:00" : "";
    tag.label.transcript = maybe();
    tag.duration_s = share(random) * 1e4;
    tag.gain_db = share(random) * 40.0 - 20.0;
    tag.order = static_cast<int>(below(random, 9));
    return tag;
}

} // namespace

std::string random_text(std::mt19937_64& random) {
    constexpr std::array<std::string_view, 22> pieces = {
        "Anna",  " ",           "ü",    "&",      "<b>", "\"", "'",    "\n",  "\r",    "\t",      "]]>",
        "&amp;", "👩‍👧", "שלום", "\u202E", "|",   "/",  "&#0;", "-->", "<?x?>", "e\u0301", "\\"};
    std::string text = "t";
    for (std::size_t i = 1 + below(random, 5); i > 0; --i)
        text += pieces[below(random, pieces.size())];
    return text;
}

SidecarChanges random_changes(std::mt19937_64& random) {
    SidecarChanges changes;
    changes.alt_text = random_texts(random);
    changes.description = random_texts(random);
    changes.keywords = random_list(random);
    changes.persons = random_list(random);
    changes.faces.emplace();
    for (std::size_t i = below(random, 4); i > 0; --i)
        changes.faces->push_back({share(random), share(random), share(random), share(random),
                                  below(random, 2) == 0 ? std::string{} : random_text(random)});
    std::stable_partition(changes.faces->begin(), changes.faces->end(),
                          [](const FaceRegion& face) { return !face.name.empty(); });
    for (const FaceRegion& face : *changes.faces)
        if (!face.name.empty())
            add_once(*changes.persons, face.name);
    changes.tags.emplace();
    for (int i = static_cast<int>(below(random, 4)); i > 0; --i)
        changes.tags->push_back(random_tag(random, i));
    changes.content_hash = below(random, 2) == 0 ? "" : std::string(64, 'a');
    return changes;
}

} // namespace tp::test
