// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/index_dump.hpp"

#include <string_view>
#include <vector>

namespace tp {

namespace {

/// On one line: control characters and backslashes as \xNN.
std::string escaped(std::string_view bytes) {
    constexpr std::string_view hex = "0123456789abcdef";
    std::string result;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F || byte == '\\' || byte == '|')
            result += {'\\', 'x', hex[byte >> 4], hex[byte & 15]};
        else
            result += c;
    }
    return result;
}

/// Appends each row on a line of its own; numbers as SQLite prints them, which is exact.
void append(std::string& text, std::string_view title, SqlRun run, int columns) {
    while (run.next()) {
        text += title;
        for (int i = 0; i < columns; ++i)
            text.append("|").append(run.null(i) ? "NULL" : escaped(run.bytes(i)));
        text += '\n';
    }
}

std::vector<std::int64_t> photos_by_path(SqlConnection& connection) {
    std::vector<std::int64_t> ids;
    SqlRun run = connection.run("SELECT p.id FROM photos p JOIN folders f ON f.id = p.folder "
                                "WHERE p.missing = 0 ORDER BY f.path, p.name");
    while (run.next())
        ids.push_back(run.integer(0));
    return ids;
}

void append_photo(std::string& text, SqlConnection& connection, std::int64_t id) {
    append(text, "photo",
           connection.run("SELECT f.path, p.name, p.sort_name, hex(p.hash), p.size, p.moment, p.year, "
                          "p.taken, printf('%!.17g', p.latitude), printf('%!.17g', p.longitude), "
                          "p.place_name, p.orientation, p.width, p.height, p.said_hash "
                          "FROM photos p JOIN folders f ON f.id = p.folder WHERE p.id = ?",
                          id),
           15);
    append(text, " face",
           connection.run("SELECT printf('%!.17g', x), printf('%!.17g', y), printf('%!.17g', width), "
                          "printf('%!.17g', height), name FROM faces WHERE photo = ? ORDER BY nr",
                          id),
           5);
    append(text, " tag",
           connection.run("SELECT file, kind, person, speaker, language, recorded, transcript, "
                          "printf('%!.17g', duration_s), printf('%!.17g', gain_db), place FROM tags "
                          "WHERE photo = ? ORDER BY nr",
                          id),
           10);
    append(text, " text",
           connection.run("SELECT kind, language, text FROM texts WHERE photo = ? ORDER BY kind, nr", id), 3);
    append(text, " topic",
           connection.run("SELECT t.kind, t.name, a.moment, a.sort_name FROM appearances a "
                          "JOIN topics t ON t.id = a.topic WHERE a.photo = ? ORDER BY t.kind, t.name",
                          id),
           4);
    append(
        text, " words",
        connection.run(
            "SELECT names, descriptions, transcripts, places, keywords, file FROM words WHERE rowid = ?", id),
        6);
}

} // namespace

std::string dump_of(SqlConnection& connection) {
    std::string text;
    append(text, "photos", connection.run("SELECT photos FROM totals"), 1);
    append(text, "folder", connection.run("SELECT path FROM folders WHERE present = 1 ORDER BY path"), 1);
    for (const std::int64_t id : photos_by_path(connection))
        append_photo(text, connection, id);
    append(text, "topic", connection.run("SELECT kind, name, photos FROM topics ORDER BY kind, name"), 3);
    append(text, "start",
           connection.run("SELECT t.kind, t.name, s.folded, s.photos FROM topic_starts s "
                          "JOIN topics t ON t.id = s.topic ORDER BY t.kind, t.name, s.folded"),
           4);
    return text;
}

} // namespace tp
