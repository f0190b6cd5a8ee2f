// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_queries.hpp"

#include "app/album/index/photo_store.hpp"
#include "app/album/index/search_words.hpp"
#include "app/album/index/seen_photos.hpp"
#include "app/album/index/sort_keys.hpp"

#include <QByteArray>
#include <QString>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <set>

namespace tp {

namespace fs = std::filesystem;

namespace {

#define TP_ENTRY "SELECT p.id, f.path, p.name, p.taken, p.moment, p.sort_name"
#define TP_PHOTOS " FROM photos p JOIN folders f ON f.id = p.folder WHERE p.missing = 0"
#define TP_TIME_AFTER                                                                                        \
    " AND (p.moment, p.sort_name, p.id) > (?, ?, ?) ORDER BY p.moment, p.sort_name, p.id LIMIT ?"
#define TP_TIME_BEFORE                                                                                       \
    " AND (p.moment, p.sort_name, p.id) < (?, ?, ?) ORDER BY p.moment DESC, p.sort_name DESC, p.id DESC "    \
    "LIMIT ?"
#define TP_TOPIC                                                                                             \
    " FROM appearances a CROSS JOIN photos p ON p.id = a.photo JOIN folders f ON f.id = p.folder "           \
    "WHERE a.topic = (SELECT id FROM topics WHERE kind = ? AND name = ?)"

/// Each goes along an index from a place on; it never counts what lies before.
constexpr std::array by_time{TP_ENTRY TP_PHOTOS TP_TIME_AFTER, TP_ENTRY TP_PHOTOS TP_TIME_BEFORE};
constexpr std::array by_name{
    TP_ENTRY TP_PHOTOS " AND (p.sort_name, p.id) > (?, ?) ORDER BY p.sort_name, p.id LIMIT ?",
    TP_ENTRY TP_PHOTOS " AND (p.sort_name, p.id) < (?, ?) ORDER BY p.sort_name DESC, p.id DESC LIMIT ?"};
constexpr std::array of_year{TP_ENTRY TP_PHOTOS " AND p.year = ?" TP_TIME_AFTER,
                             TP_ENTRY TP_PHOTOS " AND p.year = ?" TP_TIME_BEFORE};
constexpr std::array of_topic{TP_ENTRY TP_TOPIC " AND (a.moment, a.sort_name, a.photo) > (?, ?, ?) "
                                                "ORDER BY a.moment, a.sort_name, a.photo LIMIT ?",
                              TP_ENTRY TP_TOPIC
                              " AND (a.moment, a.sort_name, a.photo) < (?, ?, ?) "
                              "ORDER BY a.moment DESC, a.sort_name DESC, a.photo DESC LIMIT ?"};
#define TP_COUNT "SELECT count(*) FROM photos WHERE missing = 0"
constexpr const char* before_by_time = TP_COUNT " AND (moment, sort_name, id) < (?, ?, ?)";
constexpr const char* before_by_name = TP_COUNT " AND (sort_name, id) < (?, ?)";
constexpr const char* before_of_year = TP_COUNT " AND year = ? AND (moment, sort_name, id) < (?, ?, ?)";
constexpr const char* before_of_topic =
    "SELECT count(*) FROM appearances WHERE topic = (SELECT id FROM topics WHERE kind = ? AND name = ?) "
    "AND (moment, sort_name, photo) < (?, ?, ?)";
constexpr const char* of_id = TP_ENTRY TP_PHOTOS " AND p.id = ?";
constexpr const char* of_path = TP_ENTRY TP_PHOTOS " AND f.path = ? AND p.name = ?";
constexpr const char* any_of_id = TP_ENTRY ", hex(p.hash), p.missing FROM photos p "
                                           "JOIN folders f ON f.id = p.folder WHERE p.id = ?";

/// Above all texts (UTF-8 of U+10FFFF).
constexpr std::string_view last_text = "\xF4\x8F\xBF\xBF";

PhotoEntry entry_in(const SqlRun& row) {
    return {row.integer(0),
            fs::path(row.bytes(1)) / row.bytes(2),
            row.text(3),
            {row.integer(4), row.text(5), row.integer(0)}};
}

std::optional<PhotoEntry> first_entry(SqlRun run) {
    return run.next() ? std::optional(entry_in(run)) : std::nullopt;
}

std::vector<PhotoId> ids_in(SqlRun run) {
    std::vector<PhotoId> ids;
    while (run.next())
        ids.push_back(run.integer(0));
    return ids;
}

using PlaceLimits = std::numeric_limits<std::int64_t>;
PlaceInList before_all() { return {PlaceLimits::min(), {}, PlaceLimits::min()}; }
PlaceInList behind_all() { return {PlaceLimits::max(), std::string(last_text), PlaceLimits::max()}; }

/// Runs the query of a list in one direction.
struct PageRun {
    SqlConnection& connection;
    std::size_t way; ///< 0 forward, 1 backward
    const PlaceInList& from;
    std::int64_t count;

    SqlRun operator()(AllByTime) const {
        return connection.run(by_time[way], from.moment, from.sort_name, from.id, count);
    }
    SqlRun operator()(AllByName) const {
        return connection.run(by_name[way], from.sort_name, from.id, count);
    }
    SqlRun operator()(OfYear list) const {
        return connection.run(of_year[way], list.year, from.moment, from.sort_name, from.id, count);
    }
    SqlRun operator()(const OfTopic& list) const {
        return connection.run(of_topic[way], list.kind, list.name, from.moment, from.sort_name, from.id,
                              count);
    }
};

/// Counts what lies before a place.
struct CountRun {
    SqlConnection& connection;
    const PlaceInList& place;

    SqlRun operator()(AllByTime) const {
        return connection.run(before_by_time, place.moment, place.sort_name, place.id);
    }
    SqlRun operator()(AllByName) const { return connection.run(before_by_name, place.sort_name, place.id); }
    SqlRun operator()(OfYear list) const {
        return connection.run(before_of_year, list.year, place.moment, place.sort_name, place.id);
    }
    SqlRun operator()(const OfTopic& list) const {
        return connection.run(before_of_topic, list.kind, list.name, place.moment, place.sort_name, place.id);
    }
};

constexpr const char* suggestions_1 =
    "SELECT t.id, t.kind, t.name, t.photos FROM topic_starts s JOIN topics t ON t.id = s.topic "
    "WHERE substr(s.folded, 1, 1) = ? ORDER BY s.photos DESC LIMIT ?";
constexpr const char* suggestions_2 =
    "SELECT t.id, t.kind, t.name, t.photos FROM topic_starts s JOIN topics t ON t.id = s.topic "
    "WHERE substr(s.folded, 1, 2) = ? ORDER BY s.photos DESC LIMIT ?";
constexpr const char* suggestions_3 =
    "SELECT t.id, t.kind, t.name, t.photos FROM topic_starts s JOIN topics t ON t.id = s.topic "
    "WHERE substr(s.folded, 1, 3) = substr(?, 1, 3) AND s.folded >= ? AND s.folded < ? "
    "ORDER BY s.photos DESC LIMIT ?";

/// The words of the full-text search themselves (https://www.sqlite.org/fts5.html#the_fts5vocab_virtual_table_module).
constexpr const char* vocabulary =
    "CREATE VIRTUAL TABLE IF NOT EXISTS temp.vocabulary USING fts5vocab('main', 'words', 'row')";

/// Folded, with single blanks between words and none around them.
std::string typed_start(std::string_view typed) {
    return QString::fromStdString(folded(typed)).simplified().toStdString();
}

} // namespace

Result<std::vector<PhotoEntry>> AlbumQueries::page(const PhotoList& list,
                                                   const std::optional<PlaceInList>& from, std::size_t count,
                                                   Direction direction) {
    const PlaceInList end = direction == Direction::forward ? before_all() : behind_all();
    return index_.guarded([&] {
        std::vector<PhotoEntry> photos;
        SqlRun run = std::visit(PageRun{index_.connection(), direction == Direction::forward ? 0u : 1u,
                                        from ? *from : end, static_cast<std::int64_t>(count)},
                                list);
        while (run.next())
            photos.push_back(entry_in(run));
        return photos;
    });
}

Result<std::optional<PhotoEntry>> AlbumQueries::neighbour(const PhotoList& list, const PlaceInList& of,
                                                          Direction direction) {
    Result<std::vector<PhotoEntry>> one = page(list, of, 1, direction);
    if (!one)
        return Error{one.error()};
    return one->empty() ? std::nullopt : std::optional(std::move(one->front()));
}

Result<std::size_t> AlbumQueries::count_before(const PhotoList& list,
                                               const std::optional<PlaceInList>& place) {
    const PlaceInList end = behind_all();
    return index_.guarded([&] {
        SqlRun run = std::visit(CountRun{index_.connection(), place ? *place : end}, list);
        return run.next() ? static_cast<std::size_t>(run.integer(0)) : std::size_t{0};
    });
}

Result<std::optional<PhotoEntry>> AlbumQueries::find(const fs::path& photo) {
    return index_.guarded([&] {
        return first_entry(index_.connection().run(of_path, SqlBytes{photo.parent_path().native()},
                                                   SqlBytes{photo.filename().native()}));
    });
}

Result<std::optional<PhotoEntry>> AlbumQueries::with_content(std::string_view sha256) {
    const std::string bytes =
        QByteArray::fromHex(QByteArray(sha256.data(), static_cast<qsizetype>(sha256.size()))).toStdString();
    return index_.guarded([&] {
        return first_entry(index_.connection().run(TP_ENTRY TP_PHOTOS " AND p.hash = ? ORDER BY p.id LIMIT 1",
                                                   SqlBytes{bytes}));
    });
}

Result<std::optional<PhotoSummary>> AlbumQueries::summary(PhotoId photo) {
    return index_.guarded([&]() -> std::optional<PhotoSummary> {
        PhotoSummary summary;
        {
            SqlRun run = index_.connection().run(any_of_id, photo);
            if (!run.next())
                return std::nullopt;
            summary.entry = entry_in(run);
            summary.sha256 = QString::fromStdString(run.text(6)).toLower().toStdString();
            summary.missing = run.integer(7) != 0;
        }
        summary.record = stored_record(index_.connection(), photo).value_or(PhotoRecord{});
        summary.seen = stored_sight(index_.connection(), photo);
        return summary;
    });
}

Result<std::optional<PhotoEntry>> AlbumQueries::surprise(std::uint64_t seed) {
    return index_.guarded([&]() -> std::optional<PhotoEntry> {
        constexpr int attempts = 64; // numbers of photographs that are gone are hit in vain
        std::uint64_t last = 0;
        {
            SqlRun run = index_.connection().run("SELECT max(id) FROM photos");
            last = run.next() ? static_cast<std::uint64_t>(run.integer(0)) : 0;
        }
        if (last == 0)
            return std::nullopt;
        std::mt19937_64 random(seed);
        for (int i = 0; i < attempts; ++i)
            if (auto found = entry(static_cast<PhotoId>(1 + random() % last)))
                return found;
        return first_entry(index_.connection().run(TP_ENTRY TP_PHOTOS " AND p.id >= ? ORDER BY p.id LIMIT 1",
                                                   static_cast<PhotoId>(1 + random() % last)));
    });
}

Result<std::vector<PhotoEntry>> AlbumQueries::search(std::string_view typed, std::size_t count) {
    const std::vector<std::string> terms = search_terms(typed);
    if (terms.empty())
        return std::vector<PhotoEntry>{};
    return index_.guarded([&] { return entries(best_matches(terms, count)); });
}

std::vector<PhotoId> AlbumQueries::best_matches(const std::vector<std::string>& terms, std::size_t count) {
    // bm25 counts every photograph of every term: 0.3 s for a letter in an album of 100 000. Terms with more
    // than this many say little about what is meant; they only choose.
    constexpr std::int64_t telling = 500;
    SqlConnection& connection = index_.connection();
    const auto matches = [&](const std::string& query, std::int64_t most) {
        return ids_in(connection.run("SELECT rowid FROM words WHERE words MATCH ? LIMIT ?", query, most));
    };
    std::vector<std::string> rare;
    for (const std::string& term : terms)
        if (matches(term, telling).size() < telling)
            rare.push_back(term);
    if (rare.empty())
        return matches(all_of(terms), static_cast<std::int64_t>(count));
    std::vector<PhotoId> ranked = ids_in(
        connection.run("SELECT rowid FROM words WHERE words MATCH ? ORDER BY rank, rowid", all_of(rare)));
    if (rare.size() < terms.size()) {
        const std::vector<PhotoId> all = matches(all_of(terms), telling); // in the order of their numbers
        std::erase_if(ranked, [&](PhotoId id) { return !std::binary_search(all.begin(), all.end(), id); });
    }
    ranked.resize(std::min(ranked.size(), count));
    return ranked;
}

Result<std::vector<TopicEntry>> AlbumQueries::suggestions(std::string_view typed, std::size_t count) {
    const std::string start = typed_start(typed);
    const auto letters = QString::fromStdString(start).toUcs4().size();
    if (letters == 0)
        return std::vector<TopicEntry>{};
    const auto most = static_cast<std::int64_t>(2 * count); // a name of which two words begin so comes twice
    const auto run = [&](SqlConnection& connection) {
        return letters == 1 ? connection.run(suggestions_1, start, most)
               : letters == 2
                   ? connection.run(suggestions_2, start, most)
                   : connection.run(suggestions_3, start, start, start + std::string(last_text), most);
    };
    return index_.guarded([&] {
        std::vector<TopicEntry> topics;
        std::set<std::int64_t> seen;
        SqlRun found = run(index_.connection());
        while (topics.size() < count && found.next())
            if (seen.insert(found.integer(0)).second)
                topics.push_back({found.text(1), found.text(2), static_cast<std::size_t>(found.integer(3))});
        return topics;
    });
}

Result<std::vector<std::string>> AlbumQueries::next_letters(std::string_view typed) {
    constexpr std::size_t most = 100;
    // Composed again, as full-text search has the syllables of Hangul.
    const QString words = QString::fromStdString(folded(typed)).normalized(QString::NormalizationForm_C);
    qsizetype begin = words.size();
    while (begin > 0 && (words[begin - 1].isLetterOrNumber() || words[begin - 1].isSurrogate()))
        --begin;
    const std::string begun = words.mid(begin).toStdString();
    return index_.guarded([&] {
        std::vector<std::string> letters;
        SqlConnection& connection = index_.connection();
        connection.run(vocabulary);
        // From each letter to the first word behind it, so that it takes no longer where there are more words.
        std::string from = begun + '\x01';
        while (letters.size() < most) {
            SqlRun run = connection.run(
                "SELECT term FROM temp.vocabulary WHERE term >= ? ORDER BY term LIMIT 1", from);
            if (!run.next())
                break;
            const std::string term = run.text(0);
            if (term.compare(0, begun.size(), begun) != 0)
                break;
            const QString rest = QString::fromStdString(term.substr(begun.size()));
            const std::string letter = rest.left(rest[0].isHighSurrogate() ? 2 : 1).toStdString();
            if (!search_terms(letter).empty()) // unicode61 takes some signs for letters that are none
                letters.push_back(letter);
            from = begun + letter + std::string(last_text);
        }
        return letters;
    });
}

Result<std::vector<TopicEntry>> AlbumQueries::topics(std::string_view kind, std::string_view after,
                                                     std::size_t count) {
    return index_.guarded([&] {
        std::vector<TopicEntry> topics;
        SqlRun run = index_.connection().run("SELECT kind, name, photos FROM topics WHERE kind = ? AND "
                                             "name > ? ORDER BY name LIMIT ?",
                                             kind, after, static_cast<std::int64_t>(count));
        while (run.next())
            topics.push_back({run.text(0), run.text(1), static_cast<std::size_t>(run.integer(2))});
        return topics;
    });
}

Result<std::vector<int>> AlbumQueries::years() {
    return index_.guarded([&] {
        std::vector<int> years;
        int year = std::numeric_limits<int>::min();
        while (true) {
            SqlRun run = index_.connection().run(
                "SELECT year FROM photos WHERE missing = 0 AND year > ? ORDER BY year LIMIT 1", year);
            if (!run.next())
                return years;
            year = static_cast<int>(run.integer(0));
            years.push_back(year);
        }
    });
}

std::vector<PhotoEntry> AlbumQueries::entries(const std::vector<PhotoId>& photos) {
    std::vector<PhotoEntry> entries;
    for (const PhotoId photo : photos)
        if (auto found = entry(photo))
            entries.push_back(std::move(*found));
    return entries;
}

std::optional<PhotoEntry> AlbumQueries::entry(PhotoId photo) {
    return first_entry(index_.connection().run(of_id, photo));
}

} // namespace tp
