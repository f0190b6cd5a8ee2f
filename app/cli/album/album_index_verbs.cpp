// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/path_text.hpp"
#include "app/cli/album/album_index_words.hpp"
#include "app/cli/album/album_json.hpp"
#include "app/cli/album/album_verbs.hpp"
#include "app/cli/album/album_words.hpp"
#include "core/files/file_words.hpp"

#include <QJsonArray>

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

QJsonObject to_json(const ScanReport& report) {
    QJsonArray moves, duplicates;
    for (const Move& move : report.moves)
        moves.append(QJsonObject{{"from", path_text(move.from)}, {"to", path_text(move.to)}});
    for (const auto& group : report.duplicates) {
        QJsonArray paths;
        for (const fs::path& photo : group)
            paths.append(path_text(photo));
        duplicates.append(paths);
    }
    return {{"photos", static_cast<qint64>(report.found)},
            {"read", static_cast<qint64>(report.read)},
            {"missing", static_cast<qint64>(report.missing)},
            {"moves", moves},
            {"duplicates", duplicates},
            {"problems", json_texts(report.problems)},
            {"stopped", report.stopped}};
}

void print_for_a_person(const ScanReport& report) {
    std::printf("%zu photographs, %zu of them new or changed, %zu gone.\n", report.found, report.read,
                report.missing);
    for (const Move& move : report.moves)
        std::printf("%s is now %s.\n", quoted(move.from).c_str(), quoted(move.to).c_str());
    for (const auto& group : report.duplicates)
        std::printf("%s is there %zu times.\n", quoted(group.front()).c_str(), group.size());
}

int scan(const VerbLine& line) {
    const std::vector<fs::path> folders = folders_given(line);
    std::error_code error;
    for (const fs::path& folder : folders)
        if (!fs::is_directory(folder, error))
            return refused("There is no folder " + quoted(folder) + ".");
    auto index = open_index(line, folders);
    if (!index)
        return refused(index.error());
    StopOnSignal stop;
    const auto report = scan_with_progress(*index, folders, stop);
    if (!report)
        return refused(report.error());
    if (line.has("json"))
        print_line(to_json(*report));
    else
        print_for_a_person(*report);
    for (const std::string& problem : report->problems)
        say_problem(problem);
    if (report->stopped)
        return stop.exit_code();
    return report->problems.empty() ? exit_done : exit_bad_input;
}

} // namespace

int album_scan(const QStringList& words) {
    VerbLine line("album scan",
                  "Brings the index of an album up to date: reads what is new or changed. Photographs that "
                  "were moved or\n"
                  "renamed are recognised by their content. One that was stopped goes on where it was.");
    add_index_options(line)
        .option("json", "One JSON object on stdout.")
        .argument("FOLDER", "The album's folders.", "FOLDER...");
    if (const auto over = line.parse(words, 1, 1000))
        return *over;
    return scan(line);
}

int album_rebuild(const QStringList& words) {
    VerbLine line("album rebuild", "Throws the index of an album away and makes it again from the files.");
    add_index_options(line)
        .option("json", "One JSON object on stdout.")
        .argument("FOLDER", "The album's folders.", "FOLDER...");
    if (const auto over = line.parse(words, 1, 1000))
        return *over;
    if (const std::string reason = AlbumIndex::discard(cache_of(line, folders_given(line))); !reason.empty())
        return refused("The index cannot be thrown away: " + reason);
    return scan(line);
}

} // namespace tp
