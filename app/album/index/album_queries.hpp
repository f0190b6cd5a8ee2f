// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"
#include "app/album/metadata/photo_record.hpp"
#include "app/photo/seen/seen_photo.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tp {

/// Where a photograph stands in a list: after this one the list goes on, also when others came or went
/// meanwhile.
struct PlaceInList {
    std::int64_t moment = 0;
    std::string sort_name;
    PhotoId id = 0;
};

struct PhotoEntry {
    PhotoId id = 0;
    std::filesystem::path path;
    std::string taken; ///< ISO 8601; empty: unknown
    PlaceInList place;
};

struct AllByTime {}; ///< those without a time by that of their file
struct AllByName {};
struct OfYear {
    int year;
};
/// Everything that shows a person, was taken at a place, or has a keyword; by time.
struct OfTopic {
    std::string kind; ///< "person", "place", "keyword"
    std::string name;
};
using PhotoList = std::variant<AllByTime, AllByName, OfYear, OfTopic>;

enum class Direction { forward, backward };

struct TopicEntry {
    std::string kind, name;
    std::size_t photos = 0;
    bool operator==(const TopicEntry&) const = default;
};

struct PhotoSummary {
    PhotoEntry entry;
    std::string sha256; ///< hexadecimal; empty: it cannot be read
    bool missing = false;
    PhotoRecord record;            ///< what the last scan read; of a missing one little
    std::optional<SeenPhoto> seen; ///< nothing: nobody has looked yet
};

/// What pages ask of an index. Nothing here but `count_before` takes longer because the album is larger; missing
/// photographs are in no list. Errors are sentences about the database.
class AlbumQueries {
public:
    explicit AlbumQueries(AlbumIndex& index) : index_(index) {}

    /// The next `count` photographs of a list from a place on, nearest first; from its end where there is
    /// none.
    Result<std::vector<PhotoEntry>> page(const PhotoList& list, const std::optional<PlaceInList>& from,
                                         std::size_t count, Direction direction = Direction::forward);
    /// The next or previous one; none at the end of the list.
    Result<std::optional<PhotoEntry>> neighbour(const PhotoList& list, const PlaceInList& of,
                                                Direction direction);
    /// How many of a list lie before a place; all of it where there is none. Counts them one by one, about 0.25 µs each:
    /// for a jump, not for a step.
    Result<std::size_t> count_before(const PhotoList& list, const std::optional<PlaceInList>& place);
    Result<std::optional<PhotoEntry>> find(const std::filesystem::path& photo);
    /// A photograph with these bytes, by their SHA-256 in hexadecimal.
    Result<std::optional<PhotoEntry>> with_content(std::string_view sha256);
    Result<std::optional<PhotoSummary>> summary(PhotoId photo);
    /// Any photograph, each as likely as another; the same for the same seed and index.
    Result<std::optional<PhotoEntry>> surprise(std::uint64_t seed);

    /// Photographs of which all words typed are in names, descriptions, transcripts, places, keywords or the
    /// file's name; letter case and accents do not count, the last word may be half typed. The best first
    /// (bm25); words that very many photographs have do not count for that.
    Result<std::vector<PhotoEntry>> search(std::string_view typed, std::size_t count);
    /// People, places and keywords with a word that begins as typed, the commonest first.
    Result<std::vector<TopicEntry>> suggestions(std::string_view typed, std::size_t count);

    /// The letters and digits with which a word that `search` finds goes on after the last word typed, in small letters
    /// without accents and in their order, at most 100: for who spells without a keyboard. Where nothing or a blank was
    /// typed last, those with which a word begins.
    Result<std::vector<std::string>> next_letters(std::string_view typed);

    /// People, places or keywords by name, from after one on.
    Result<std::vector<TopicEntry>> topics(std::string_view kind, std::string_view after, std::size_t count);
    Result<std::vector<int>> years();

private:
    std::vector<PhotoId> best_matches(const std::vector<std::string>& terms, std::size_t count);
    std::vector<PhotoEntry> entries(const std::vector<PhotoId>& photos);
    std::optional<PhotoEntry> entry(PhotoId photo);

    AlbumIndex& index_;
};

} // namespace tp
