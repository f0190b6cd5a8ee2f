// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/known_faces.hpp"

#include <algorithm>

namespace tp {

namespace fs = std::filesystem;

namespace {

#define TP_STORED                                                                                            \
    "SELECT k.id, (SELECT min(id) FROM photos WHERE hash = k.hash), k.numbers, "                             \
    "(SELECT moment FROM photos WHERE hash = k.hash AND taken <> '' LIMIT 1), k.said, k.face_group "
#define TP_PLACED                                                                                            \
    "SELECT k.id, f.path, p.name, p.moment, p.orientation, s.turned, sf.left, sf.top, sf.right, sf.bottom "  \
    "FROM known_faces k JOIN seen_faces sf ON sf.hash = k.hash AND sf.nr = k.nr JOIN seen s ON s.hash = "    \
    "k.hash "                                                                                                \
    "JOIN photos p ON p.hash = k.hash AND p.missing = 0 JOIN folders f ON f.id = p.folder "

StoredFace stored_face(const SqlRun& run) {
    StoredFace face{run.integer(0), run.integer(1), run.bytes(2), {}, run.text(4), run.integer(5)};
    if (!run.null(3))
        face.moment_ms = run.integer(3);
    return face;
}

std::vector<PlacedFace> placed_faces(SqlRun run) {
    std::vector<PlacedFace> faces;
    while (run.next())
        faces.push_back({run.integer(0), fs::path(run.bytes(1)) / run.bytes(2), run.integer(3),
                         static_cast<int>(run.integer(4)), static_cast<int>(run.integer(5)),
                         Rect{Vec2(run.real(6), run.real(7)), Vec2(run.real(8), run.real(9))}});
    return faces;
}

std::string outcome(const Result<bool>& done) { return done ? std::string() : done.error(); }

std::vector<FacesToGroup::Copy> copies_of(SqlConnection& connection, const std::string& hash) {
    std::vector<std::pair<PhotoId, int>> photos;
    {
        SqlRun run = connection.run(
            "SELECT id, orientation FROM photos WHERE hash = ? AND missing = 0 ORDER BY id", SqlBytes{hash});
        while (run.next())
            photos.emplace_back(run.integer(0), static_cast<int>(run.integer(1)));
    }
    std::vector<FacesToGroup::Copy> copies;
    for (const auto& [photo, orientation] : photos) {
        FacesToGroup::Copy copy{orientation, {}};
        SqlRun run =
            connection.run("SELECT x, y, width, height, name FROM faces WHERE photo = ? ORDER BY nr", photo);
        while (run.next())
            copy.regions.push_back({run.real(0), run.real(1), run.real(2), run.real(3), run.text(4)});
        copies.push_back(std::move(copy));
    }
    return copies;
}

FacesToGroup faces_to_group(SqlConnection& connection, const std::string& hash) {
    FacesToGroup photo;
    photo.hash = hash;
    {
        SqlRun run = connection.run("SELECT turned FROM seen WHERE hash = ?", SqlBytes{hash});
        photo.turned_degrees = run.next() ? static_cast<int>(run.integer(0)) : 0;
    }
    {
        SqlRun run = connection.run(TP_STORED ", sf.left, sf.top, sf.right, sf.bottom FROM known_faces k "
                                              "JOIN seen_faces sf ON sf.hash = k.hash AND sf.nr = k.nr "
                                              "WHERE k.hash = ? ORDER BY k.nr",
                                    SqlBytes{hash});
        while (run.next())
            photo.faces.push_back(
                {stored_face(run), Rect{Vec2(run.real(6), run.real(7)), Vec2(run.real(8), run.real(9))}});
    }
    photo.copies = copies_of(connection, hash);
    return photo;
}

/// Nothing has come, gone or been said since it was read.
bool is_still_so(SqlConnection& connection, const FacesToGroup& then) {
    const FacesToGroup now = faces_to_group(connection, then.hash);
    const auto id_of = [](const FacesToGroup::Face& face) { return face.stored.id; };
    return now.turned_degrees == then.turned_degrees && now.copies == then.copies &&
           std::ranges::equal(now.faces, then.faces, {}, id_of, id_of);
}

} // namespace

Result<StoredGroups> KnownFaces::all() {
    return index_.guarded([&] {
        SqlConnection& connection = index_.connection();
        StoredGroups all;
        SqlRun faces = connection.run(TP_STORED "FROM known_faces k WHERE k.face_group <> 0 ORDER BY k.id");
        while (faces.next())
            all.faces.push_back(stored_face(faces));
        SqlRun names = connection.run("SELECT id, name FROM face_groups");
        while (names.next())
            all.names[names.integer(0)] = names.text(1);
        SqlRun apart = connection.run("SELECT face, face_group FROM faces_apart");
        while (apart.next())
            all.apart.emplace_back(apart.integer(0), apart.integer(1));
        SqlRun last = connection.run("SELECT id FROM last_face_group");
        all.last = last.next() ? last.integer(0) : 0;
        return all;
    });
}

Result<std::optional<FacesToGroup>> KnownFaces::next(const std::string& after) {
    return index_.guarded([&]() -> std::optional<FacesToGroup> {
        SqlConnection& connection = index_.connection();
        std::string hash;
        {
            SqlRun run = connection.run("SELECT hash FROM to_group WHERE hash > ? ORDER BY hash LIMIT 1",
                                        SqlBytes{after});
            if (!run.next())
                return std::nullopt;
            hash = run.bytes(0);
        }
        return faces_to_group(connection, hash);
    });
}

Result<std::vector<std::int64_t>> KnownFaces::gone() {
    return index_.guarded([&] {
        std::vector<std::int64_t> gone;
        SqlRun run = index_.connection().run("SELECT id FROM gone_faces");
        while (run.next())
            gone.push_back(run.integer(0));
        return gone;
    });
}

std::string KnownFaces::keep(const GroupsKept& kept) {
    return outcome(index_.guarded([&] {
        SqlConnection& connection = index_.connection();
        SqlTransaction all(connection);
        for (const auto& [face, group] : kept.groups_of)
            connection.run("UPDATE known_faces SET face_group = ? WHERE id = ?", group, face);
        for (const auto& [face, name] : kept.said)
            connection.run("UPDATE known_faces SET said = ? WHERE id = ?", name, face);
        for (const auto& [group, name] : kept.names)
            if (name)
                connection.run("INSERT OR REPLACE INTO face_groups VALUES(?, ?)", group, *name);
            else
                connection.run("DELETE FROM face_groups WHERE id = ?", group);
        for (const auto& [face, group] : kept.no_more_apart)
            connection.run("DELETE FROM faces_apart WHERE face = ? AND face_group = ?", face, group);
        for (const auto& [face, group] : kept.apart) // the face may have gone meanwhile
            connection.run("INSERT OR IGNORE INTO faces_apart SELECT id, ? FROM known_faces WHERE id = ?",
                           group, face);
        for (const FacesToGroup& photo : kept.done)
            if (is_still_so(connection, photo))
                connection.run("DELETE FROM to_group WHERE hash = ?", SqlBytes{photo.hash});
        for (const std::int64_t face : kept.taken_away)
            connection.run("DELETE FROM gone_faces WHERE id = ?", face);
        connection.run("UPDATE last_face_group SET id = max(id, ?)", kept.last);
        all.commit();
        return true;
    }));
}

std::string KnownFaces::begin_anew() {
    return outcome(index_.guarded([&] {
        SqlConnection& connection = index_.connection();
        SqlTransaction all(connection);
        connection.run("UPDATE known_faces SET face_group = 0, said = ''");
        connection.run("DELETE FROM face_groups");
        connection.run("DELETE FROM faces_apart");
        connection.run("DELETE FROM gone_faces");
        connection.run("INSERT OR IGNORE INTO to_group SELECT DISTINCT hash FROM known_faces");
        all.commit();
        return true;
    }));
}

Result<bool> KnownFaces::forget() {
    return index_.guarded([&] {
        SqlConnection& connection = index_.connection();
        {
            SqlRun run = connection.run("SELECT 1 FROM known_faces LIMIT 1");
            if (!run.next())
                return false;
        }
        SqlTransaction all(connection);
        connection.run("DELETE FROM known_faces");
        connection.run("DELETE FROM face_groups");
        connection.run("DELETE FROM faces_apart");
        connection.run("DELETE FROM to_group");
        connection.run("DELETE FROM gone_faces");
        connection.run("UPDATE seen SET marked = 0 WHERE marked <> 0");
        connection.run("UPDATE seen_faces SET no_guess = 0 WHERE no_guess <> 0");
        all.commit();
        index_.erase_traces();
        return true;
    });
}

Result<std::vector<PlacedFace>> KnownFaces::placed() {
    return index_.guarded([&] {
        return placed_faces(index_.connection().run(TP_PLACED "ORDER BY p.moment DESC, p.id DESC, k.nr"));
    });
}

Result<std::vector<PlacedFace>> KnownFaces::placed_on(const fs::path& photo) {
    return index_.guarded([&] {
        return placed_faces(index_.connection().run(TP_PLACED "WHERE f.path = ? AND p.name = ? ORDER BY k.nr",
                                                    SqlBytes{photo.parent_path().native()},
                                                    SqlBytes{photo.filename().native()}));
    });
}

Result<std::size_t> KnownFaces::to_look() {
    return index_.guarded([&] {
        SqlRun run = index_.connection().run(
            "SELECT count(*) FROM photos p WHERE missing = 0 AND hash IS NOT NULL AND "
            "NOT EXISTS (SELECT 1 FROM looked WHERE hash = p.hash AND marked = 1)");
        return run.next() ? static_cast<std::size_t>(run.integer(0)) : std::size_t{0};
    });
}

Result<std::size_t> KnownFaces::not_guessed() {
    return index_.guarded([&] {
        SqlRun run =
            index_.connection().run("SELECT count(*) FROM seen_faces WHERE no_guess <> 0 AND EXISTS "
                                    "(SELECT 1 FROM photos WHERE hash = seen_faces.hash AND missing = 0)");
        return run.next() ? static_cast<std::size_t>(run.integer(0)) : std::size_t{0};
    });
}

} // namespace tp
