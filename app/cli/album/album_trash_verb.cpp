// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/album_keeper.hpp"
#include "app/cli/album/album_json.hpp"
#include "app/cli/album/album_verbs.hpp"
#include "app/cli/album/album_words.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "core/files/file_words.hpp"

#include <array>
#include <cstdio>

namespace tp {

namespace {

int trash_list(const QStringList& words) {
    VerbLine line("album trash list", "What was deleted from an album, newest first.");
    line.option("json", "One JSON object per line.").argument("ALBUM", "The album's folder.");
    if (const auto over = line.parse(words, 1, 1))
        return *over;
    LongWork::step("reading what is in the trash");
    std::vector<std::string> problems;
    for (const TrashEntry& entry : Trash(path_given(line.arguments().first())).entries(&problems))
        if (line.has("json"))
            print_json(to_json(entry));
        else
            print("%s\t%s\t%s\n", entry.id.c_str(), entry.deleted.c_str(), readable(entry.what).c_str());
    for (const std::string& problem : problems)
        say_problem(problem);
    return problems.empty() ? exit_done : exit_bad_input;
}

int trash_restore(const QStringList& words) {
    VerbLine line("album trash restore", "Puts something back to where it was.");
    line.argument("ALBUM", "The album's folder.").argument("ID", "Its name in \"trash list\".");
    if (const auto over = line.parse(words, 2, 2))
        return *over;
    AlbumKeeper keeper(path_given(line.arguments().first()));
    const std::string problem = keeper.restore(line.arguments()[1].toStdString());
    return problem.empty() ? int{exit_done} : refused(problem);
}

int trash_empty(const QStringList& words) {
    VerbLine line("album trash empty",
                  "Deletes for good what is in an album's trash. This cannot be undone.");
    line.option("yes", "Really deletes; without it nothing is deleted.")
        .argument("ALBUM", "The album's folder.");
    if (const auto over = line.parse(words, 1, 1))
        return *over;
    Trash trash(path_given(line.arguments().first()));
    if (!line.has("yes"))
        return wrong_usage("album trash empty", "It deletes " + std::to_string(trash.entries().size()) +
                                                    " things for good; say --yes if you want that.");
    LongWork::step("emptying the trash");
    const std::string problem = trash.empty();
    return problem.empty() ? int{exit_done} : refused(problem);
}

} // namespace

int album_trash(const QStringList& words) {
    static constexpr std::array<SubVerb, 3> verbs{{
        {"list", "what was deleted, newest first", trash_list},
        {"restore", "put something back to where it was", trash_restore},
        {"empty", "delete it all for good", trash_empty},
    }};
    return run_sub_verb("album trash", verbs, words);
}

} // namespace tp
