// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/name_languages.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_tag = 35, longest_part = 8;
constexpr std::size_t most_language_bytes = 1 << 20; ///< of a file

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// What a file says that must have its place.
Result<NameLanguage> read_in_place(const fs::path& file, const NameLanguages& names) {
    auto name = NameLanguages::read(file);
    if (name && names.place_of(name->person) != file)
        return Error{quoted(file) + " says how the name of " + readable(name->person) +
                     " is read, but is not in its place."};
    return name;
}

/// Makes it what the person's file says; an empty tag: there is none.
std::string put_language(const fs::path& file, const NameLanguage& name) {
    std::string reason;
    if (!name.language.empty()) {
        reason = make_folder(file.parent_path(), Readers::owner_only);
        if (reason.empty())
            reason = replace_file(file, name_language_text(name), Readers::owner_only);
    } else if (!is_gone(file)) {
        reason = remove_file(file);
    }
    return reason.empty() ? reason : "The language of the name cannot be saved: " + reason;
}

} // namespace

bool is_language_tag(std::string_view text) {
    if (text.size() > longest_tag)
        return false;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::string_view part = text.substr(begin, text.find('-', begin) - begin);
        const bool well = !part.empty() && part.size() <= longest_part &&
                          std::all_of(part.begin(), part.end(),
                                      [begin](char c) { return is_letter(c) || (begin > 0 && is_digit(c)); });
        if (!well)
            return false;
        begin += part.size() + 1;
    }
    const std::size_t first = std::min(text.find('-'), text.size());
    return first > 1 ||
           (first < text.size() && std::string_view("xXiI").find(text[0]) != std::string_view::npos);
}

std::string name_language_text(const NameLanguage& name) { return name.language + '\n' + name.person + '\n'; }

Result<NameLanguage> parse_name_language(std::string_view text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    NameLanguage name{{}, std::string(text.substr(0, end))};
    if (!is_language_tag(name.language))
        return Error{"its first line is not a language tag, such as de or pt-BR."};
    std::string_view person = text.substr(std::min(end + 1, text.size()));
    if (person.ends_with('\n'))
        person.remove_suffix(1);
    if (person.empty())
        return Error{"its second line does not say whose name it is."};
    name.person = person;
    return name;
}

Result<NameLanguage> NameLanguages::read(const fs::path& file) {
    const auto text = read_whole(file, most_language_bytes);
    if (!text)
        return Error{text.error()};
    auto name = parse_name_language(*text);
    return name ? name
                : Error{quoted(file) + " does not say in what language a name is read: " + name.error() +
                        " Move it away, then choose the language again."};
}

fs::path NameLanguages::place_of(const std::string& person) const {
    return keeper_.place_of_name(person).replace_extension(file_end);
}

Result<std::string> NameLanguages::of(const std::string& person) const {
    const fs::path file = place_of(person);
    if (is_gone(file))
        return std::string{};
    const auto name = read_in_place(file, *this);
    return name ? Result<std::string>(name->language) : Result<std::string>(Error{name.error()});
}

std::vector<NameLanguage> NameLanguages::all(std::vector<std::string>* problems) const {
    std::vector<fs::path> files;
    const fs::path folder = place_of("a").parent_path();
    for (const FolderEntry& entry : entries_of(folder))
        if (fs::path(entry.name).extension() == file_end)
            files.push_back(folder / entry.name);
    std::vector<NameLanguage> names;
    for (const fs::path& file : files) {
        auto name = read_in_place(file, *this);
        if (name)
            names.push_back(*std::move(name));
        else if (problems)
            problems->push_back(name.error());
    }
    return names;
}

std::string NameLanguages::choose(const std::string& person, const std::string& language) {
    if (person.empty())
        return "A person needs a name before its language can be chosen.";
    if (!language.empty() && !is_language_tag(language))
        return quoted_readable(language) + " is not a language tag, such as de or pt-BR.";
    const auto before = of(person);
    if (!before)
        return before.error();
    if (*before == language)
        return {};
    const auto put = [file = place_of(person), person](const std::string& to) {
        return put_language(file, {person, to});
    };
    if (std::string problem = put(language); !problem.empty())
        return problem;
    keeper_.history().done({"the language of the name of " + readable(person) + " was chosen",
                            [put, was = *before] { return put(was); },
                            [put, language] { return put(language); }});
    return {};
}

std::string NameLanguages::rename(const std::string& from, const std::string& to) {
    const fs::path file = place_of(from), other = place_of(to);
    if (is_gone(file) || to.empty() || from == to)
        return {};
    const std::string what = "the language of the name of " + readable(from);
    if (name_taken(other)) {
        const auto id = std::make_shared<std::string>();
        const auto put_away = [keeper = &keeper_, file, what, id] {
            const auto put = keeper->trash().put({file}, what);
            if (put)
                *id = *put;
            return put.error();
        };
        if (std::string problem = put_away(); !problem.empty())
            return problem;
        keeper_.history().done({what + " was deleted",
                                [keeper = &keeper_, id] { return keeper->trash().restore(*id); }, put_away});
        return {};
    }
    const auto language = of(from);
    if (!language)
        return language.error();
    // The new one first: after a kill there are both, and doing it again puts the old one away.
    const auto give = [tag = *language](const NameLanguage& one, const fs::path& here,
                                        const NameLanguage& two, const fs::path& there) {
        std::string problem = put_language(there, {two.person, tag});
        return problem.empty() ? put_language(here, {one.person, {}}) : problem;
    };
    const NameLanguage old_name{from, {}}, new_name{to, {}};
    if (std::string problem = give(old_name, file, new_name, other); !problem.empty())
        return problem;
    keeper_.history().done(
        {"the language of the name of " + readable(from) + " became that of " + readable(to),
         [=] { return give(new_name, other, old_name, file); },
         [=] { return give(old_name, file, new_name, other); }});
    return {};
}

} // namespace tp
