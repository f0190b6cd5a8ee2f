// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/follow_moves.hpp"
#include "app/album/keeper/path_text.hpp"
#include "app/cli/album/album_index_words.hpp"
#include "app/cli/album/album_json.hpp"
#include "app/cli/album/album_verbs.hpp"
#include "app/cli/album/album_words.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "core/files/file_words.hpp"

#include <QJsonArray>

#include <algorithm>
#include <cstdio>

namespace tp {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> folders_given(const VerbLine& line) {
    std::vector<fs::path> folders;
    for (const QString& word : line.arguments())
        folders.push_back(path_given(word));
    return folders;
}

QJsonArray to_json(const std::vector<Move>& moves) {
    QJsonArray array;
    for (const Move& move : moves)
        array.append(QJsonObject{{"from", path_text(move.from)}, {"to", path_text(move.to)}});
    return array;
}

QJsonObject to_json(const ScanReport& report, const FollowedMoves& moves) {
    QJsonArray duplicates;
    for (const auto& group : report.duplicates) {
        QJsonArray paths;
        for (const fs::path& photo : group)
            paths.append(path_text(photo));
        duplicates.append(paths);
    }
    return {{"photos", static_cast<qint64>(report.found)},
            {"read", static_cast<qint64>(report.read)},
            {"missing", static_cast<qint64>(report.missing)},
            {"moves", to_json(report.moves)},
            {"followed", to_json(moves.followed)},
            {"duplicates", duplicates},
            {"problems", json_texts(report.problems)},
            {"stopped", report.stopped}};
}

void print_for_a_person(const ScanReport& report, const FollowedMoves& moves) {
    print("%zu photographs, %zu of them new or changed, %zu gone.\n", report.found, report.read,
          report.missing);
    for (const Move& move : report.moves) {
        const bool followed = std::find(moves.followed.begin(), moves.followed.end(), move) != moves.followed.end();
        print("%s is now %s%s.\n", quoted(move.from).c_str(), quoted(move.to).c_str(),
              followed ? "; what belongs to it was moved too" : "");
    }
    for (const auto& group : report.duplicates)
        print("%s is there %zu times.\n", quoted(group.front()).c_str(), group.size());
}

/// What belongs to moved photographs goes along, and the index learns where it is now.
FollowedMoves follow(AlbumIndex& index, ScanReport& report) {
    LongWork::step("moving what belongs to moved photographs");
    auto moves =
        follow_moves(index, {[](std::size_t done, std::size_t all) {
                                 LongWork::share(static_cast<double>(done) / static_cast<double>(all));
                             },
                             LongWork::stop_token()});
    if (!moves)
        return {{}, {moves.error()}, false};
    std::vector<fs::path> folders;
    for (const Move& move : moves->followed)
        folders.push_back(move.to.parent_path());
    report.stopped = moves->stopped;
    if (const auto again = rescan_with_progress(index, folders); !again) {
        moves->problems.push_back(again.error());
    } else {
        report.problems.insert(report.problems.end(), again->problems.begin(), again->problems.end());
        report.stopped = report.stopped || again->stopped;
    }
    return *std::move(moves);
}

int scan(const VerbLine& line, bool following) {
    const std::vector<fs::path> folders = folders_given(line);
    std::error_code error;
    for (const fs::path& folder : folders)
        if (!fs::is_directory(folder, error))
            return refused("There is no folder " + quoted(folder) + ".");
    auto index = open_index(line, folders);
    if (!index)
        return refused(index.error());
    auto report = scan_with_progress(*index, folders);
    if (!report)
        return refused(report.error());
    FollowedMoves moves;
    if (following && !report->stopped)
        moves = follow(*index, *report);
    if (line.has("json"))
        print_json(to_json(*report, moves));
    else
        print_for_a_person(*report, moves);
    report->problems.insert(report->problems.end(), moves.problems.begin(), moves.problems.end());
    for (const std::string& problem : report->problems)
        say_problem(problem);
    if (report->stopped)
        return LongWork::stop_code();
    return report->problems.empty() ? exit_done : exit_bad_input;
}

} // namespace

int album_scan(const QStringList& words) {
    VerbLine line(
        "album scan",
        "Brings the index of an album up to date: reads what is new or changed. Photographs that "
        "were moved or\n"
        "renamed are recognised by their content, and what belongs to them is moved too. A scan that was "
        "stopped continues where it was.");
    add_index_options(line)
        .option("look-only", "Moves nothing in the album; only says what moved.")
        .option("json", "One JSON object on stdout.")
        .argument("FOLDER", "The album's folders.", "FOLDER...");
    if (const auto over = line.parse(words, 1, 1000))
        return *over;
    return scan(line, !line.has("look-only"));
}

int album_rebuild(const QStringList& words) {
    VerbLine line("album rebuild", "Rebuilds the index of an album from its files.");
    add_index_options(line)
        .option("json", "One JSON object on stdout.")
        .argument("FOLDER", "The album's folders.", "FOLDER...");
    if (const auto over = line.parse(words, 1, 1000))
        return *over;
    if (const std::string reason = AlbumIndex::discard(cache_of(line, folders_given(line))); !reason.empty())
        return refused("The index cannot be deleted: " + reason);
    return scan(line, false);
}

} // namespace tp
