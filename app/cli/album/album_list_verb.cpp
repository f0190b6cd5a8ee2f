// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_queries.hpp"
#include "app/album/keeper/path_text.hpp"
#include "app/cli/album/album_index_words.hpp"
#include "app/cli/album/album_json.hpp"
#include "app/cli/album/album_verbs.hpp"
#include "app/cli/album/album_words.hpp"
#include "app/cli/terminal.hpp"
#include "core/files/file_words.hpp"

#include <QStringList>

#include <cstdio>

namespace tp {

namespace {

constexpr int most_lines = 10'000'000;

void print_entries(const std::vector<PhotoEntry>& entries, bool json) {
    for (const PhotoEntry& entry : entries)
        if (json)
            print_json({{"photo", path_text(entry.path)}, {"taken", json_text(entry.taken)}});
        else
            print("%s\t%s\n", entry.taken.empty() ? "-" : readable(entry.taken).c_str(),
                  readable(entry.path.string()).c_str());
}

VerbLine& add_list_options(VerbLine& line) {
    return add_index_options(line)
        .option("limit", "At most this many.", "N", QString::number(most_lines))
        .option("json", "One JSON object per line.")
        .argument("ALBUM", "The album's folder.");
}

} // namespace

int album_list(const QStringList& words) {
    VerbLine line("album list", "The photographs of an album by time, as its index has them (\"album scan\" "
                                "brings it up to date; an\n"
                                "index that is empty is filled first).");
    add_list_options(line)
        .option("by-name", "Sorted by name instead of by time.")
        .option("person", "Only those that show this person.", "NAME")
        .option("year", "Only those of this year.", "YEAR");
    if (const auto over = line.parse(words, 1, 1))
        return *over;
    const auto limit = line.whole("limit", 1, most_lines);
    const auto year = line.has("year") ? line.whole("year", 0, 9999) : Result<int>(0);
    if (!limit || !year)
        return wrong_usage("album list", limit ? year.error() : limit.error());
    PhotoList list = AllByTime{};
    if (line.has("by-name"))
        list = AllByName{};
    if (line.has("year"))
        list = OfYear{*year};
    if (line.has("person"))
        list = OfTopic{"person", line.text("person").toStdString()};
    auto index = filled_index(line, {path_given(line.arguments().first())});
    if (!index)
        return refused(index.error());
    const auto found = AlbumQueries(*index).page(list, std::nullopt, static_cast<std::size_t>(*limit));
    if (!found)
        return refused(found.error());
    print_entries(*found, line.has("json"));
    return exit_done;
}

int album_search(const QStringList& words) {
    VerbLine line(
        "album search",
        "Photographs that have all the words in names, descriptions, transcripts, places, keywords or the\n"
        "file's name, the best first. Letter case and accents do not count; the last word may be half "
        "typed.");
    add_list_options(line).argument("WORD", "What to search for.", "WORD...");
    if (const auto over = line.parse(words, 2, 1000))
        return *over;
    const auto limit = line.whole("limit", 1, most_lines);
    if (!limit)
        return wrong_usage("album search", limit.error());
    auto index = filled_index(line, {path_given(line.arguments().first())});
    if (!index)
        return refused(index.error());
    const std::string typed = line.arguments().mid(1).join(QLatin1Char(' ')).toStdString();
    const auto found = AlbumQueries(*index).search(typed, static_cast<std::size_t>(*limit));
    if (!found)
        return refused(found.error());
    print_entries(*found, line.has("json"));
    return exit_done;
}

} // namespace tp
