// SPDX-License-Identifier: Apache-2.0
#include "app/album/check/name_check.hpp"

#include "app/album/check/recording_check.hpp"
#include "app/album/keeper/name_languages.hpp"
#include "app/album/keeper/recording_facts.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <filesystem>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// A name was being recorded when its program ended.
void misplaced_name(const fs::path& file, const std::string& person, const fs::path& place,
                    Findings& findings) {
    const std::string sentence =
        quoted(file) + " says the name of " + readable(person) + " but is not in its place.";
    if (name_taken(place))
        findings.add(
            Finding::Kind::unlisted_recording, file, sentence,
            "Another one has it, so this one goes to the trash.", [&] {
                return findings.keeper().trash().put({file}, "how somebody says " + readable(person)).error();
            });
    else
        findings.add(Finding::Kind::unlisted_recording, file, sentence,
                     "It goes there, " + quoted(place) + ".", [&] { return move_file(file, place); });
}

void check_name_language(const fs::path& file, const std::set<std::string>* known_people,
                         Findings& findings) {
    const auto to_trash = [&] {
        return findings.keeper().trash().put({file}, "the language of somebody's name").error();
    };
    const auto name = looked_twice([&] { return NameLanguages::read(file); });
    if (!name)
        return findings.add_damaged(Finding::Kind::damaged_name_language, file, name.error(),
                                    "It goes to the trash, and the language can be chosen again.", to_trash);
    if (const fs::path place = NameLanguages(findings.keeper()).place_of(name->person); place != file) {
        const std::string sentence = quoted(file) + " says how the name of " + readable(name->person) +
                                     " is read, but is not in its place.";
        if (name_taken(place))
            return findings.add(Finding::Kind::damaged_name_language, file, sentence,
                                "Another one has it, so this one goes to the trash.", to_trash);
        return findings.add(Finding::Kind::damaged_name_language, file, sentence,
                            "It goes there, " + quoted(place) + ".", [&] { return move_file(file, place); });
    }
    if (known_people && !known_people->contains(name->person))
        findings.add(Finding::Kind::left_behind, file,
                     quoted(file) + " says how the name of " + readable(name->person) +
                         ", who is on no photograph, is read.");
}

void check_name(const fs::path& file, const std::set<std::string>* known_people, Findings& findings) {
    const auto facts = looked_twice([&] { return recording_facts(file); });
    if (!facts) {
        findings.add_damaged(
            Finding::Kind::unreadable_recording, file, facts.error(),
            "It goes to the trash, and the name can be recorded again.",
            [&] { return findings.keeper().trash().put({file}, "a name that cannot be heard").error(); });
        return;
    }
    const std::string& person = facts->label.person;
    if (person.empty()) {
        findings.add(Finding::Kind::unlisted_recording, file,
                     quoted(file) + " does not say whose name it is.");
        return;
    }
    if (const fs::path place = findings.keeper().place_of_name(person); place != file)
        misplaced_name(file, person, place, findings);
    else if (known_people && !known_people->contains(person))
        findings.add(Finding::Kind::left_behind, file,
                     quoted(file) + " says the name of " + readable(person) + ", who is on no photograph.");
}

} // namespace

void check_names(const std::set<std::string>* known_people, Findings& findings) {
    const fs::path folder = findings.keeper().place_of_name("a").parent_path();
    check_unfinished(folder, findings);
    for (const std::string& file : recordings_in(folder))
        if (file.ends_with(NameLanguages::file_end))
            check_name_language(folder / file, known_people, findings);
        else
            check_name(folder / file, known_people, findings);
    check_readers(folder, recordings_in(folder), findings);
}

} // namespace tp
