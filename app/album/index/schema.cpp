// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/schema.hpp"

#include <array>
#include <span>

namespace tp {

namespace {

/// What album, photographs and people are.
constexpr std::array first_version{
    R"(CREATE TABLE folders(
        id INTEGER PRIMARY KEY,
        path BLOB NOT NULL UNIQUE,   -- absolute, without symbolic links
        stamp BLOB NOT NULL,         -- when it was walked; empty: not yet
        present INTEGER NOT NULL))", // 0: gone; kept for the missing photographs in it
    R"(CREATE TABLE photos(
        id INTEGER PRIMARY KEY,
        folder INTEGER NOT NULL REFERENCES folders,
        name BLOB NOT NULL,
        sort_name TEXT NOT NULL,
        hash BLOB,                 -- SHA-256 of its bytes; NULL: it cannot be read
        stamp BLOB NOT NULL,       -- of the file when it was read; empty: read it again
        beside BLOB NOT NULL,      -- of its sidecars and recordings, likewise
        size INTEGER NOT NULL,
        inode INTEGER NOT NULL,
        moment INTEGER NOT NULL,   -- ms since 1970, by `taken`, else by the file's time
        year INTEGER,
        taken TEXT NOT NULL,
        latitude REAL, longitude REAL,
        place_name TEXT NOT NULL,
        orientation INTEGER NOT NULL,
        width INTEGER NOT NULL, height INTEGER NOT NULL,
        said_hash TEXT NOT NULL,   -- what the sidecar says the hash was
        missing INTEGER NOT NULL,
        UNIQUE(folder, name)))",
    "CREATE INDEX photos_by_moment ON photos(moment, sort_name, id) WHERE missing = 0",
    "CREATE INDEX photos_by_name ON photos(sort_name, id) WHERE missing = 0",
    "CREATE INDEX photos_by_year ON photos(year, moment, sort_name, id) WHERE missing = 0",
    "CREATE INDEX photos_by_hash ON photos(hash)",
    "CREATE INDEX photos_missing ON photos(id) WHERE missing = 1",
    // Counted as they change, because counting 100 000 rows takes longer than opening an album may.
    "CREATE TABLE totals(photos INTEGER NOT NULL, missing INTEGER NOT NULL)",
    "INSERT INTO totals VALUES(0, 0)",
    R"(CREATE TRIGGER photo_added AFTER INSERT ON photos BEGIN
        UPDATE totals SET photos = photos + (new.missing = 0), missing = missing + new.missing;
    END)",
    R"(CREATE TRIGGER photo_forgotten AFTER DELETE ON photos BEGIN
        UPDATE totals SET photos = photos - (old.missing = 0), missing = missing - old.missing;
    END)",
    R"(CREATE TRIGGER photo_missed AFTER UPDATE OF missing ON photos WHEN old.missing <> new.missing BEGIN
        UPDATE totals SET photos = photos + old.missing - new.missing,
                          missing = missing + new.missing - old.missing;
    END)",
    R"(CREATE TABLE faces(
        photo INTEGER NOT NULL REFERENCES photos ON DELETE CASCADE, nr INTEGER NOT NULL,
        x REAL NOT NULL, y REAL NOT NULL, width REAL NOT NULL, height REAL NOT NULL, name TEXT NOT NULL,
        PRIMARY KEY(photo, nr)) WITHOUT ROWID)",
    R"(CREATE TABLE tags(
        photo INTEGER NOT NULL REFERENCES photos ON DELETE CASCADE, nr INTEGER NOT NULL,
        file TEXT NOT NULL, kind TEXT NOT NULL, person TEXT NOT NULL, speaker TEXT NOT NULL,
        language TEXT NOT NULL, recorded TEXT NOT NULL, transcript TEXT NOT NULL,
        duration_s REAL NOT NULL, gain_db REAL NOT NULL, place INTEGER NOT NULL,
        PRIMARY KEY(photo, nr)) WITHOUT ROWID)",
    R"(CREATE TABLE texts(
        photo INTEGER NOT NULL REFERENCES photos ON DELETE CASCADE,
        kind TEXT NOT NULL,     -- alt, description, person, keyword, problem
        nr INTEGER NOT NULL,
        language TEXT NOT NULL, -- where the kind has languages
        text TEXT NOT NULL,
        PRIMARY KEY(photo, kind, nr)) WITHOUT ROWID)",
    // People, places and keywords: what photographs can be looked through by, and what typing suggests.
    R"(CREATE TABLE topics(
        id INTEGER PRIMARY KEY, kind TEXT NOT NULL, name TEXT NOT NULL, photos INTEGER NOT NULL,
        UNIQUE(kind, name)))",
    R"(CREATE TABLE appearances(
        topic INTEGER NOT NULL REFERENCES topics,
        moment INTEGER NOT NULL, sort_name TEXT NOT NULL, -- the photograph's
        photo INTEGER NOT NULL REFERENCES photos ON DELETE CASCADE,
        PRIMARY KEY(topic, moment, sort_name, photo)) WITHOUT ROWID)",
    "CREATE INDEX appearances_by_photo ON appearances(photo)",
    R"(CREATE TABLE topic_starts(
        topic INTEGER NOT NULL REFERENCES topics ON DELETE CASCADE,
        folded TEXT NOT NULL, -- the name from one of its words on
        photos INTEGER NOT NULL))",
    "CREATE INDEX topic_starts_by_topic ON topic_starts(topic)",
    // One for each count of letters typed, the commonest first; after three few are left.
    "CREATE INDEX topic_starts_1 ON topic_starts(substr(folded, 1, 1), photos DESC)",
    "CREATE INDEX topic_starts_2 ON topic_starts(substr(folded, 1, 2), photos DESC)",
    "CREATE INDEX topic_starts_3 ON topic_starts(substr(folded, 1, 3), photos DESC)",
    R"(CREATE TRIGGER topic_found AFTER INSERT ON appearances BEGIN
        UPDATE topics SET photos = photos + 1 WHERE id = new.topic;
    END)",
    R"(CREATE TRIGGER topic_lost AFTER DELETE ON appearances BEGIN
        UPDATE topics SET photos = photos - 1 WHERE id = old.topic;
        DELETE FROM topics WHERE id = old.topic AND photos = 0;
    END)",
    R"(CREATE TRIGGER topic_counted AFTER UPDATE OF photos ON topics BEGIN
        UPDATE topic_starts SET photos = new.photos WHERE topic = new.id;
    END)",
};

/// Full-text search. Of photographs that are in the database already only the next scan knows the words:
/// clearing `beside` makes it read what lies beside them again.
constexpr std::array second_version{
    R"(CREATE VIRTUAL TABLE words USING fts5(
        names, descriptions, transcripts, places, keywords, file,
        prefix = '1 2 3 4 5 6', tokenize = 'unicode61 remove_diacritics 2'))",
    "INSERT INTO words(words, rank) VALUES('rank', 'bm25(10.0, 4.0, 3.0, 5.0, 5.0, 1.0)')",
    "UPDATE photos SET beside = x''",
};

/// What was looked at: by the bytes of a photograph, so that it is known again wherever the file goes. `worded` says in
/// what words a photograph can be found by it; empty: none yet.
constexpr std::array third_version{
    R"(CREATE TABLE seen(
        hash BLOB PRIMARY KEY,      -- SHA-256 of the photograph
        look INTEGER NOT NULL,      -- the version of what looked
        width INTEGER NOT NULL, height INTEGER NOT NULL, -- px; 0: a look was begun and came to nothing
        turned INTEGER NOT NULL, light INTEGER NOT NULL, colours INTEGER NOT NULL, blurred INTEGER NOT NULL)
        WITHOUT ROWID)",
    R"(CREATE TABLE seen_faces(
        hash BLOB NOT NULL REFERENCES seen ON DELETE CASCADE, nr INTEGER NOT NULL,
        left REAL NOT NULL, top REAL NOT NULL, right REAL NOT NULL, bottom REAL NOT NULL,
        cut_off INTEGER NOT NULL, mien INTEGER NOT NULL, eyes INTEGER NOT NULL, facing INTEGER NOT NULL,
        PRIMARY KEY(hash, nr)) WITHOUT ROWID)",
    R"(CREATE TRIGGER content_forgotten AFTER DELETE ON photos
        WHEN NOT EXISTS (SELECT 1 FROM photos WHERE hash = old.hash) BEGIN
        DELETE FROM seen WHERE hash = old.hash;
    END)",
    R"(CREATE TRIGGER content_changed AFTER UPDATE OF hash ON photos
        WHEN NOT EXISTS (SELECT 1 FROM photos WHERE hash = old.hash) BEGIN
        DELETE FROM seen WHERE hash = old.hash;
    END)",
    "ALTER TABLE photos ADD COLUMN worded TEXT NOT NULL DEFAULT ''",
    "DROP TABLE words",
    R"(CREATE VIRTUAL TABLE words USING fts5(
        names, descriptions, transcripts, places, keywords, file, seen,
        prefix = '1 2 3 4 5 6', tokenize = 'unicode61 remove_diacritics 2'))",
    "INSERT INTO words(words, rank) VALUES('rank', 'bm25(10.0, 4.0, 3.0, 5.0, 5.0, 1.0, 2.0)')",
    "UPDATE photos SET beside = x''",
};

/// What is new; faces that are known again, and groups of those that seem to be one person's. `to_group` and `gone_faces` are what the
/// groups do not know yet of: kept, so that a program that ended goes on with them.
constexpr std::array fourth_version{
    "ALTER TABLE seen ADD COLUMN marked INTEGER NOT NULL DEFAULT 0",         // 1: faces may be known again
    "ALTER TABLE seen_faces ADD COLUMN no_guess INTEGER NOT NULL DEFAULT 0", // why not; 0: it may be guessed
    R"(CREATE TABLE known_faces(
        id INTEGER PRIMARY KEY AUTOINCREMENT, -- none is given twice
        hash BLOB NOT NULL, nr INTEGER NOT NULL,
        numbers BLOB NOT NULL,                -- by what it is known again
        said TEXT NOT NULL DEFAULT '',        -- who it is, as the groups know it; empty: nobody has said
        face_group INTEGER NOT NULL DEFAULT 0, -- 0: none yet
        UNIQUE(hash, nr), FOREIGN KEY(hash, nr) REFERENCES seen_faces ON DELETE CASCADE))",
    "CREATE TABLE face_groups(id INTEGER PRIMARY KEY, name TEXT NOT NULL)",
    "CREATE TABLE last_face_group(id INTEGER NOT NULL)",
    "INSERT INTO last_face_group VALUES(0)",
    R"(CREATE TABLE faces_apart(
        face INTEGER NOT NULL REFERENCES known_faces ON DELETE CASCADE, face_group INTEGER NOT NULL,
        PRIMARY KEY(face, face_group)) WITHOUT ROWID)",
    "CREATE TABLE to_group(hash BLOB PRIMARY KEY) WITHOUT ROWID",
    "CREATE TABLE gone_faces(id INTEGER PRIMARY KEY)",
    "CREATE TABLE told(last INTEGER NOT NULL)", // the photograph that came last when news were told; 0: never
    "INSERT INTO told VALUES(0)",
    R"(CREATE TRIGGER known_face_came AFTER INSERT ON known_faces BEGIN
        INSERT OR IGNORE INTO to_group VALUES(new.hash);
    END)",
    R"(CREATE TRIGGER known_face_went AFTER DELETE ON known_faces BEGIN
        INSERT OR IGNORE INTO gone_faces VALUES(old.id);
    END)",
    R"(CREATE TRIGGER face_said AFTER INSERT ON faces BEGIN
        INSERT OR IGNORE INTO to_group SELECT DISTINCT k.hash FROM photos p JOIN known_faces k ON k.hash = p.hash
            WHERE p.id = new.photo;
    END)",
    R"(CREATE TRIGGER face_not_said AFTER DELETE ON faces BEGIN
        INSERT OR IGNORE INTO to_group SELECT DISTINCT k.hash FROM photos p JOIN known_faces k ON k.hash = p.hash
            WHERE p.id = old.photo;
    END)",
};

/// A photograph that is looked at when the program is ended by somebody is looked at again; one that has ended it twice is not.
/// While a look is under way `width` is 0 and `height` says how often one was begun.
constexpr std::array fifth_version{
    "DELETE FROM seen WHERE width = 0",
    "CREATE VIEW looked AS SELECT hash, look, marked FROM seen WHERE width > 0 OR height = 0 OR height >= 2",
};

/// The step at i leads from version i to i + 1.
constexpr std::array<std::span<const char* const>, 5> steps{first_version, second_version, third_version,
                                                            fourth_version, fifth_version};

} // namespace

int schema_version() { return static_cast<int>(steps.size()); }

int version_of(SqlConnection& connection) {
    SqlRun run = connection.run("PRAGMA user_version");
    return run.next() ? static_cast<int>(run.integer(0)) : 0;
}

void migrate(SqlConnection& connection, int version) {
    if (version_of(connection) >= version)
        return;
    SqlTransaction all(connection);
    for (int i = version_of(connection); i < version; ++i)
        for (const char* sql : steps[static_cast<std::size_t>(i)])
            connection.run_once(sql);
    connection.run_once("PRAGMA user_version = " + std::to_string(version));
    all.commit();
}

void touch_tables(SqlConnection& connection) {
    for (const char* table :
         {"folders", "photos", "totals", "faces", "tags", "texts", "topics", "appearances", "topic_starts",
          "seen", "seen_faces", "known_faces", "face_groups", "last_face_group", "faces_apart", "to_group",
          "gone_faces", "told", "looked"})
        connection.run_once("SELECT * FROM " + std::string(table) + " LIMIT 1");
    connection.run_once("SELECT rowid FROM words WHERE words MATCH '\"a\"*' LIMIT 1");
}

} // namespace tp
