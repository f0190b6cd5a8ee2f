// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/album_keeper.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// The language that a person's name is read in.
struct NameLanguage {
    std::string person;
    std::string language; ///< BCP 47

    bool operator==(const NameLanguage&) const = default;
};

/// Whether a text has the form of a language tag (RFC 5646, section 2.1): parts of 1 to 8 letters and digits
/// of ASCII between hyphens, the first of letters only and of one alone only as "x" or "i"; at most 35
/// characters, which section 4.4.1 finds enough.
bool is_language_tag(std::string_view text);

/// What a file of a name's language holds: the tag, and on the next line the person, whom the file's own name
/// cannot always tell.
std::string name_language_text(const NameLanguage& name);
/// The same read back; the error is the end of a sentence.
Result<NameLanguage> parse_name_language(std::string_view text);

/// In what language people's names are read, one small file a person beside where the spoken names are kept,
/// for whoever looks through an album. Texts that are returned, and steps, are as AlbumKeeper's.
class NameLanguages {
public:
    explicit NameLanguages(AlbumKeeper& keeper) : keeper_(keeper) {}

    /// Where a person's is kept, be it there or not.
    std::filesystem::path place_of(const std::string& person) const;
    /// The tag; empty: none was chosen, and the name is read as the text around it.
    Result<std::string> of(const std::string& person) const;
    /// Everybody's, by file; what cannot be read is said in `problems`, and stays.
    std::vector<NameLanguage> all(std::vector<std::string>* problems = nullptr) const;

    /// An empty tag forgets. A file that cannot be read is not written over.
    std::string choose(const std::string& person, const std::string& language);
    /// Gives it to another name, for a person who is called so everywhere from now on; where that name has
    /// one already, this one goes to the trash. Done where there is none.
    std::string rename(const std::string& from, const std::string& to);

    /// What one file says, wherever it lies; the error is a sentence.
    static Result<NameLanguage> read(const std::filesystem::path& file);
    /// The end of all files' names.
    static constexpr std::string_view file_end = ".language";

private:
    AlbumKeeper& keeper_;
};

} // namespace tp
