// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/wild_labels.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace tp {

namespace {

/// A word that is not here is a slip of the pen, which would otherwise count as "not covered".
constexpr std::string_view known[] = {
    wild_label::right_eye_covered, wild_label::left_eye_covered, wild_label::mouth_covered,
    wild_label::no_face, wild_label::jaw_beard, wild_label::jaw_hair, wild_label::painting,
    wild_label::turned_away,
    // clang-format off
    "jaw_hand", "jaw_scarf", "moustache", "laughing", "mouth_open", "glasses", "sunglasses", "hat", "turned", "group"
    // clang-format on
};

} // namespace

Result<WildLabels> WildLabels::from_text(std::string_view text) {
    WildLabels labels;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        const auto wrong = [&](const std::string& why) {
            return Error{"Line " + std::to_string(number) + " of the labels " + why + "."};
        };
        std::istringstream words(line);
        std::vector<std::string> all;
        for (std::string word; words >> word;)
            all.push_back(word);
        if (all.empty() || all.front().starts_with('#'))
            continue;
        const auto ending = std::find_if(all.rbegin(), all.rend(), [](const std::string& word) {
            return word.find('.') != std::string::npos;
        });
        if (ending == all.rend())
            return wrong("does not begin with a file's name");
        std::string name;
        for (auto word = all.begin(); word != ending.base(); ++word)
            name += (name.empty() ? "" : " ") + *word;
        const auto [entry, is_new] = labels.words_.try_emplace(name, ending.base(), all.end());
        if (!is_new)
            return wrong("is the second one about " + name);
        for (const std::string& word : entry->second)
            if (std::find(std::begin(known), std::end(known), word) == std::end(known))
                return wrong("has the word \"" + word + "\", which is not known");
    }
    return labels;
}

const std::set<std::string>* WildLabels::of(const std::filesystem::path& photo) const {
    const auto entry = words_.find(photo.filename().string());
    return entry == words_.end() ? nullptr : &entry->second;
}

bool WildLabels::says(const std::filesystem::path& photo, const std::string& word) const {
    const std::set<std::string>* words = of(photo);
    return words && words->contains(word);
}

bool WildLabels::is_plain(const std::filesystem::path& photo) const {
    return !says(photo, wild_label::no_face) && !says(photo, wild_label::painting) &&
           !says(photo, wild_label::turned_away);
}

Result<WildLabels> read_wild_labels(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream)
        return Error{"The labels \"" + file.string() + "\" cannot be read."};
    return WildLabels::from_text(std::string(std::istreambuf_iterator<char>(stream), {}));
}

} // namespace tp
