// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace tp {

/// What a person saw in each photograph of a set without contours placed by hand.
class WildLabels {
public:
    /// A line a photograph: its file's name, then words, with blanks between; # begins a comment. The name
    /// may hold blanks and ends with the last word that has a dot in it. The words are those of
    /// tests/faces/wild_labels.txt, whose first lines say what each means. The error names the line that
    /// cannot be used.
    static Result<WildLabels> from_text(std::string_view text);

    /// The words about a photograph, by the name of its file alone; null: there is no line about it.
    const std::set<std::string>* of(const std::filesystem::path& photo) const;
    /// Whether the line about it has that word; false without a line.
    bool says(const std::filesystem::path& photo, const std::string& word) const;
    /// Whether a face of 40 px or more of a living person is seen from a side from which it can be described.
    bool is_plain(const std::filesystem::path& photo) const;
    /// All words, by the photographs' names.
    const std::map<std::string, std::set<std::string>>& words() const { return words_; }

private:
    std::map<std::string, std::set<std::string>> words_;
};

/// The words that figures are made of.
namespace wild_label {
inline constexpr const char* right_eye_covered = "right_eye_covered";
inline constexpr const char* left_eye_covered = "left_eye_covered";
inline constexpr const char* mouth_covered = "mouth_covered";
inline constexpr const char* no_face = "no_face"; ///< of 40 px or more
inline constexpr const char* jaw_beard = "jaw_beard";
inline constexpr const char* jaw_hair = "jaw_hair";
inline constexpr const char* painting = "painting";
inline constexpr const char* turned_away = "turned_away"; ///< the far eye
} // namespace wild_label

/// The labels in a file; an error where it cannot be read.
Result<WildLabels> read_wild_labels(const std::filesystem::path& file);

} // namespace tp
