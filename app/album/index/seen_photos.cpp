// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/seen_photos.hpp"

#include <QByteArray>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace tp {

namespace {

std::string bytes_of(std::string_view hexadecimal) {
    return QByteArray::fromHex(QByteArray(hexadecimal.data(), static_cast<qsizetype>(hexadecimal.size())))
        .toStdString();
}

/// A number of the database as one of the kinds up to `last`; the first one where it is none.
template <typename Kind>
Kind kind_in(std::int64_t number, Kind last) {
    return number >= 0 && number <= static_cast<std::int64_t>(last) ? static_cast<Kind>(number) : Kind{};
}

int number_of(auto kind) { return static_cast<int>(kind); }

std::optional<PhotoId> first_id(SqlRun run) {
    return run.next() ? std::optional(run.integer(0)) : std::nullopt;
}

} // namespace

std::optional<SeenPhoto> stored_sight(SqlConnection& connection, PhotoId photo) {
    SeenPhoto seen;
    {
        SqlRun run = connection.run("SELECT width, height, turned, light, colours, blurred FROM seen "
                                    "WHERE hash = (SELECT hash FROM photos WHERE id = ?)",
                                    photo);
        if (!run.next())
            return std::nullopt;
        seen.width = static_cast<int>(run.integer(0));
        seen.height = static_cast<int>(run.integer(1));
        seen.turned_degrees = static_cast<int>(run.integer(2));
        seen.light = kind_in(run.integer(3), Light::bright_background);
        seen.colours = kind_in(run.integer(4), Colours::violet);
        seen.blurred = run.integer(5) != 0;
    }
    SqlRun faces =
        connection.run("SELECT left, top, right, bottom, cut_off, mien, eyes, facing FROM seen_faces "
                       "WHERE hash = (SELECT hash FROM photos WHERE id = ?) ORDER BY nr",
                       photo);
    while (faces.next()) {
        SeenFace face;
        face.part = {Vec2(faces.real(0), faces.real(1)), Vec2(faces.real(2), faces.real(3))};
        face.cut_off = faces.integer(4) != 0;
        face.mien = kind_in(faces.integer(5), Mien::perhaps_laughing);
        face.eyes = kind_in(faces.integer(6), Eyes::shut);
        face.facing = kind_in(faces.integer(7), Facing::right);
        seen.faces.push_back(face);
    }
    return seen;
}

Result<std::optional<PhotoToWord>> SeenPhotos::summarised(std::optional<PhotoId> photo) {
    if (!photo)
        return std::optional<PhotoToWord>();
    Result<std::optional<PhotoSummary>> summary = AlbumQueries(index_).summary(*photo);
    if (!summary)
        return Error{summary.error()};
    if (!*summary)
        return std::optional<PhotoToWord>();
    return index_.guarded([&]() -> std::optional<PhotoToWord> {
        SqlRun run =
            index_.connection().run("SELECT 1 FROM looked WHERE hash = ? AND look >= ? AND marked >= ?",
                                    SqlBytes{bytes_of((*summary)->sha256)}, look_, marks_ ? 1 : 0);
        return PhotoToWord{std::move(**summary), !run.next()};
    });
}

Result<std::optional<PhotoToWord>> SeenPhotos::next(std::string_view worded,
                                                    const std::optional<PlaceInList>& before) {
    using Limits = std::numeric_limits<std::int64_t>;
    const PlaceInList from = before.value_or(PlaceInList{Limits::max(), {}, Limits::max()});
    const auto photo = index_.guarded([&] {
        return first_id(index_.connection().run(
            "SELECT id FROM photos WHERE missing = 0 AND (moment, sort_name, id) < (?, ?, ?) AND worded <> ? "
            "AND hash IS NOT NULL ORDER BY moment DESC, sort_name DESC, id DESC LIMIT 1",
            from.moment, from.sort_name, from.id, worded));
    });
    if (!photo)
        return Error{photo.error()};
    return summarised(*photo);
}

Result<std::optional<PhotoToWord>> SeenPhotos::of(PhotoId photo, std::string_view worded) {
    const auto found = index_.guarded([&] {
        return first_id(index_.connection().run(
            "SELECT id FROM photos WHERE id = ? AND missing = 0 AND worded <> ? AND hash IS NOT NULL", photo,
            worded));
    });
    if (!found)
        return Error{found.error()};
    return summarised(*found);
}

std::string SeenPhotos::begin(std::string_view sha256) {
    const auto begun = index_.guarded([&] {
        SqlRun run = index_.connection().run(
            "SELECT height FROM seen WHERE hash = ? AND look = ? AND marked = ? AND width = 0",
            SqlBytes{bytes_of(sha256)}, look_, marks_ ? 1 : 0);
        return run.next() ? static_cast<int>(run.integer(0)) : 0;
    });
    if (!begun)
        return begun.error();
    Looked looked;
    looked.seen.height = *begun + 1;
    return put(sha256, looked);
}

std::string SeenPhotos::put(std::string_view sha256, const Looked& looked) {
    const SeenPhoto& seen = looked.seen;
    const std::string hash = bytes_of(sha256);
    const auto done = index_.guarded([&] {
        SqlConnection& connection = index_.connection();
        SqlTransaction all(connection);
        connection.run("DELETE FROM seen WHERE hash = ?", SqlBytes{hash}); // with its faces
        connection.run("INSERT INTO seen VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)", SqlBytes{hash}, look_,
                       seen.width, seen.height, seen.turned_degrees, number_of(seen.light),
                       number_of(seen.colours), seen.blurred ? 1 : 0, marks_ ? 1 : 0);
        for (std::size_t i = 0; i < seen.faces.size(); ++i) {
            const SeenFace& face = seen.faces[i];
            const FaceMark mark = i < looked.marks.size() ? looked.marks[i] : FaceMark();
            const auto nr = static_cast<std::int64_t>(i);
            connection.run("INSERT INTO seen_faces VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", SqlBytes{hash},
                           nr, face.part.min.x, face.part.min.y, face.part.max.x, face.part.max.y,
                           face.cut_off ? 1 : 0, number_of(face.mien), number_of(face.eyes),
                           number_of(face.facing), number_of(mark.why));
            if (!mark.numbers.empty())
                connection.run("INSERT INTO known_faces(hash, nr, numbers) VALUES(?, ?, ?)", SqlBytes{hash},
                               nr, SqlBytes{mark.numbers});
        }
        all.commit();
        return true;
    });
    return done ? std::string() : done.error();
}

std::string SeenPhotos::forget(std::string_view sha256) {
    const std::string hash = bytes_of(sha256);
    const auto done = index_.guarded([&] {
        index_.connection().run("DELETE FROM seen WHERE hash = ?", SqlBytes{hash});
        return true;
    });
    return done ? std::string() : done.error();
}

std::string SeenPhotos::put_words(PhotoId photo, std::string_view worded, std::string_view words) {
    const auto done = index_.guarded([&] {
        SqlConnection& connection = index_.connection();
        SqlTransaction all(connection);
        connection.run("UPDATE words SET seen = ? WHERE rowid = ?", words, photo);
        connection.run("UPDATE photos SET worded = ? WHERE id = ?", worded, photo);
        all.commit();
        return true;
    });
    return done ? std::string() : done.error();
}

} // namespace tp
