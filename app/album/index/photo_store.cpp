// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/photo_store.hpp"

#include "app/album/index/sort_keys.hpp"
#include "core/files/file_words.hpp"

#include <set>
#include <string_view>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// Gathers words for one column of the full-text index, each text once.
class Words {
public:
    void add(std::string_view text) {
        if (!text.empty() && seen_.emplace(text).second)
            text_.append(text_.empty() ? "" : "\n").append(text);
    }
    const std::string& text() const { return text_; }

private:
    std::set<std::string, std::less<>> seen_;
    std::string text_;
};

void drop_details(SqlConnection& connection, std::int64_t id) {
    connection.run("DELETE FROM faces WHERE photo = ?", id);
    connection.run("DELETE FROM tags WHERE photo = ?", id);
    connection.run("DELETE FROM texts WHERE photo = ?", id);
    connection.run("DELETE FROM appearances WHERE photo = ?", id);
    connection.run("DELETE FROM words WHERE rowid = ?", id);
}

std::int64_t put_topic(SqlConnection& connection, std::string_view kind, const std::string& name) {
    {
        SqlRun found = connection.run("SELECT id FROM topics WHERE kind = ? AND name = ?", kind, name);
        if (found.next())
            return found.integer(0);
    }
    connection.run("INSERT INTO topics(kind, name, photos) VALUES(?, ?, 0)", kind, name);
    const std::int64_t topic = connection.last_id();
    for (const std::string& start : word_starts(folded(name)))
        connection.run("INSERT INTO topic_starts(topic, folded, photos) VALUES(?, ?, 0)", topic, start);
    return topic;
}

void put_texts(SqlConnection& connection, std::int64_t id, std::string_view kind,
               const LanguageTexts& texts) {
    int nr = 0;
    for (const auto& [language, text] : texts)
        connection.run("INSERT INTO texts VALUES(?, ?, ?, ?, ?)", id, kind, nr++, language, text);
}

void put_texts(SqlConnection& connection, std::int64_t id, std::string_view kind,
               const std::vector<std::string>& texts) {
    int nr = 0;
    for (const std::string& text : texts)
        connection.run("INSERT INTO texts VALUES(?, ?, ?, '', ?)", id, kind, nr++, text);
}

void put_faces(SqlConnection& connection, std::int64_t id, const std::vector<FaceRegion>& faces) {
    int nr = 0;
    for (const FaceRegion& face : faces)
        connection.run("INSERT INTO faces VALUES(?, ?, ?, ?, ?, ?, ?)", id, nr++, face.x, face.y, face.width,
                       face.height, face.name);
}

void put_tags(SqlConnection& connection, std::int64_t id, const std::vector<Tag>& tags) {
    int nr = 0;
    for (const Tag& tag : tags)
        connection.run("INSERT INTO tags VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", id, nr++, tag.file,
                       name_of(tag.label.kind), tag.label.person, tag.label.speaker, tag.label.language,
                       tag.label.recorded, tag.label.transcript, tag.duration_s, tag.gain_db, tag.order);
}

void put_topics(SqlConnection& connection, std::int64_t id, const PhotoRecord& record, std::int64_t moment,
                const std::string& name_key) {
    std::set<std::pair<std::string_view, std::string_view>> topics;
    for (const FaceRegion& face : record.faces)
        topics.emplace("person", face.name);
    for (const std::string& person : record.persons)
        topics.emplace("person", person);
    for (const std::string& keyword : record.keywords)
        topics.emplace("keyword", keyword);
    topics.emplace("place", record.place_name);
    for (const auto& [kind, name] : topics)
        if (!name.empty())
            connection.run("INSERT INTO appearances VALUES(?, ?, ?, ?)",
                           put_topic(connection, kind, std::string(name)), moment, name_key, id);
}

void put_words(SqlConnection& connection, std::int64_t id, const PhotoFacts& facts) {
    const PhotoRecord& record = facts.record;
    Words names, descriptions, transcripts, keywords;
    for (const FaceRegion& face : record.faces)
        names.add(face.name);
    for (const std::string& person : record.persons)
        names.add(person);
    for (const Tag& tag : record.tags) {
        names.add(tag.label.person);
        names.add(tag.label.speaker);
        transcripts.add(tag.label.transcript);
    }
    for (const LanguageTexts* texts : {&record.alt_text, &record.description})
        for (const auto& [language, text] : *texts)
            descriptions.add(text);
    for (const std::string& keyword : record.keywords)
        keywords.add(keyword);
    connection.run("INSERT INTO words(rowid, names, descriptions, transcripts, places, keywords, file, seen) "
                   "VALUES(?, ?, ?, ?, ?, ?, ?, '')",
                   id, names.text(), descriptions.text(), transcripts.text(), record.place_name,
                   keywords.text(),
                   readable(facts.listed.name) + "\n" + readable(facts.folder.filename().string()));
}

/// Makes the folder known where another process has just dropped it.
std::int64_t id_of_folder(SqlConnection& connection, const fs::path& folder) {
    connection.run("INSERT INTO folders(path, stamp, present) VALUES(?, x'', 1) ON CONFLICT(path) DO NOTHING",
                   SqlBytes{folder.native()});
    SqlRun found = connection.run("SELECT id FROM folders WHERE path = ?", SqlBytes{folder.native()});
    found.next();
    return found.integer(0);
}

} // namespace

void put_folder(SqlConnection& connection, const fs::path& folder, const std::string& stamp) {
    connection.run("INSERT INTO folders(path, stamp, present) VALUES(?, ?, 1) ON CONFLICT(path) DO UPDATE "
                   "SET present = 1, stamp = excluded.stamp WHERE present = 0 OR stamp <> excluded.stamp",
                   SqlBytes{folder.native()}, SqlBytes{stamp});
}

void put_photo(SqlConnection& connection, const PhotoFacts& facts) {
    const PhotoRecord& record = facts.record;
    const ListedPhoto& listed = facts.listed;
    const std::optional<Moment> taken = moment_of(record.taken);
    const std::int64_t moment = taken ? taken->ms : listed.modified_ns / 1'000'000;
    const std::string name_key = sort_key(listed.name);
    const std::int64_t folder = id_of_folder(connection, facts.folder);
    connection.run("INSERT INTO photos(folder, name, sort_name, hash, stamp, beside, size, inode, moment, "
                   "year, taken, latitude, longitude, place_name, orientation, width, height, said_hash, "
                   "missing) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 0) "
                   "ON CONFLICT(folder, name) DO UPDATE SET hash = excluded.hash, stamp = excluded.stamp, "
                   "beside = excluded.beside, size = excluded.size, inode = excluded.inode, "
                   "moment = excluded.moment, year = excluded.year, taken = excluded.taken, "
                   "latitude = excluded.latitude, longitude = excluded.longitude, "
                   "place_name = excluded.place_name, orientation = excluded.orientation, "
                   "width = excluded.width, height = excluded.height, said_hash = excluded.said_hash, "
                   "missing = 0, worded = ''",
                   folder, SqlBytes{listed.name}, name_key,
                   facts.sha256.empty() ? std::nullopt : std::optional(SqlBytes{facts.sha256}),
                   SqlBytes{listed.stamp}, SqlBytes{listed.beside}, listed.size, listed.inode, moment,
                   taken ? std::optional(taken->year) : std::nullopt, record.taken,
                   record.place ? std::optional(record.place->latitude) : std::nullopt,
                   record.place ? std::optional(record.place->longitude) : std::nullopt, record.place_name,
                   record.orientation, static_cast<std::int64_t>(record.width),
                   static_cast<std::int64_t>(record.height), record.content_hash);
    std::int64_t id = 0;
    {
        SqlRun found = connection.run("SELECT id FROM photos WHERE folder = ? AND name = ?", folder,
                                      SqlBytes{listed.name});
        found.next();
        id = found.integer(0);
    }
    drop_details(connection, id);
    put_faces(connection, id, record.faces);
    put_tags(connection, id, record.tags);
    put_texts(connection, id, "alt", record.alt_text);
    put_texts(connection, id, "description", record.description);
    put_texts(connection, id, "person", record.persons);
    put_texts(connection, id, "keyword", record.keywords);
    put_texts(connection, id, "problem", record.problems);
    put_topics(connection, id, record, moment, name_key);
    put_words(connection, id, facts);
}

void miss_photo(SqlConnection& connection, std::int64_t id) {
    drop_details(connection, id);
    connection.run("UPDATE photos SET missing = 1, beside = x'' WHERE id = ?", id);
}

void forget_photo(SqlConnection& connection, std::int64_t id) {
    drop_details(connection, id);
    connection.run("DELETE FROM photos WHERE id = ?", id);
}

void forget_faces_of_missing(SqlConnection& connection) {
    connection.run("DELETE FROM known_faces WHERE NOT EXISTS "
                   "(SELECT 1 FROM photos WHERE hash = known_faces.hash AND missing = 0)");
    connection.run("UPDATE seen SET marked = 0 WHERE marked <> 0 AND NOT EXISTS "
                   "(SELECT 1 FROM photos WHERE hash = seen.hash AND missing = 0)");
}

std::optional<PhotoRecord> stored_record(SqlConnection& connection, std::int64_t id) {
    PhotoRecord record;
    {
        SqlRun run = connection.run("SELECT orientation, width, height, taken, latitude, longitude, "
                                    "place_name, said_hash FROM photos WHERE id = ?",
                                    id);
        if (!run.next())
            return std::nullopt;
        record.orientation = static_cast<int>(run.integer(0));
        record.width = run.integer(1);
        record.height = run.integer(2);
        record.taken = run.text(3);
        if (!run.null(4) && !run.null(5))
            record.place = Place{run.real(4), run.real(5)};
        record.place_name = run.text(6);
        record.content_hash = run.text(7);
    }
    SqlRun faces =
        connection.run("SELECT x, y, width, height, name FROM faces WHERE photo = ? ORDER BY photo, nr", id);
    while (faces.next())
        record.faces.push_back({faces.real(0), faces.real(1), faces.real(2), faces.real(3), faces.text(4)});
    SqlRun tags = connection.run("SELECT file, kind, person, speaker, language, recorded, transcript, "
                                 "duration_s, gain_db, place FROM tags WHERE photo = ? ORDER BY photo, nr",
                                 id);
    while (tags.next())
        record.tags.push_back({tags.text(0),
                               {recording_kind(tags.text(1)).value_or(RecordingKind::memo), tags.text(2),
                                tags.text(3), tags.text(4), tags.text(5), tags.text(6)},
                               tags.real(7),
                               tags.real(8),
                               static_cast<int>(tags.integer(9))});
    SqlRun texts =
        connection.run("SELECT kind, language, text FROM texts WHERE photo = ? ORDER BY photo, kind, nr", id);
    while (texts.next()) {
        const std::string kind = texts.text(0);
        if (kind == "alt")
            record.alt_text[texts.text(1)] = texts.text(2);
        else if (kind == "description")
            record.description[texts.text(1)] = texts.text(2);
        else
            (kind == "person"    ? record.persons
             : kind == "keyword" ? record.keywords
                                 : record.problems)
                .push_back(texts.text(2));
    }
    return record;
}

} // namespace tp
