// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "app/album/metadata/read_record.hpp"
#include "audio/recordings/import_sound.hpp"
#include "audio/recordings/recording_file.hpp"
#include "audio/recordings/recording_notes.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"

#include <QByteArray>
#include <QCryptographicHash>
#include <QString>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr double same_face =
    0.3; // overlap of two regions, as a share of both together, that makes them one face

double overlap(const FaceRegion& a, const FaceRegion& b) {
    const auto shared = [](double x, double w, double u, double v) {
        return std::max(0.0, std::min(x + 0.5 * w, u + 0.5 * v) - std::max(x - 0.5 * w, u - 0.5 * v));
    };
    const double both = shared(a.x, a.width, b.x, b.width) * shared(a.y, a.height, b.y, b.height);
    const double either = a.width * a.height + b.width * b.height - both;
    if (either > 0.0)
        return both / either;
    return a.x == b.x && a.y == b.y ? 1.0 : 0.0; // two points
}

bool makes_sense(const FaceRegion& face) {
    const auto inside = [](double centre, double size) {
        return size > 0.0 && centre - 0.5 * size > -0.01 && centre + 0.5 * size < 1.01;
    };
    return inside(face.x, face.width) && inside(face.y, face.height);
}

auto find_face(std::vector<FaceRegion>& faces, const FaceRegion& like) {
    const auto best =
        std::max_element(faces.begin(), faces.end(), [&](const FaceRegion& a, const FaceRegion& b) {
            return overlap(a, like) < overlap(b, like);
        });
    return best != faces.end() && overlap(*best, like) >= same_face ? best : faces.end();
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_about(const Tag& tag, const std::string& person) {
    return tag.label.person == person || tag.label.speaker == person;
}

bool speaks_of(const PhotoRecord& record, const std::string& person) {
    return contains(record.persons, person) ||
           std::any_of(record.faces.begin(), record.faces.end(),
                       [&](const FaceRegion& face) { return face.name == person; }) ||
           std::any_of(record.tags.begin(), record.tags.end(),
                       [&](const Tag& tag) { return is_about(tag, person); });
}

/// The persons of a photograph after its faces changed from one list to another: those who were only on a
/// face that lost the name are taken out; persons without a face stay.
std::vector<std::string> persons_after(std::vector<std::string> persons, const std::string& gone,
                                       const std::string& come, const std::vector<FaceRegion>& faces) {
    const auto on_a_face = [&](const std::string& name) {
        return std::any_of(faces.begin(), faces.end(),
                           [&](const FaceRegion& face) { return face.name == name; });
    };
    if (!gone.empty() && !on_a_face(gone))
        std::erase(persons, gone);
    if (!come.empty() && !contains(persons, come))
        persons.push_back(come);
    return persons;
}

/// Whether a name can be a file's on every system: on sticks too, which have Windows' file systems.
bool is_name_of_files(const QByteArray& name) {
    constexpr std::string_view refused = "\"*:<>?\\|";
    return std::none_of(name.begin(), name.end(), [&](char c) {
        return (c >= 0 && c < ' ') || refused.find(c) != std::string_view::npos;
    });
}

/// Where the name of a person, spoken, is kept: readable where the name can be a file's.
fs::path name_file(const fs::path& album, const std::string& person) {
    constexpr qsizetype longest = 200; // bytes; a file's name has at most 255
    const QByteArray name = QByteArray::fromStdString(person);
    const auto place = [&](QByteArray file) {
        if (file.size() > longest)
            file = file.left(longest) + "-" +
                   QCryptographicHash::hash(name, QCryptographicHash::Sha256).toHex().left(16);
        return album / ".touchphoto" / "people" / (file.toStdString() + ".flac");
    };
    const bool plain = QString::fromUtf8(name).toUtf8() == name && !name.contains('/') &&
                       !name.contains('%') && !name.contains('\0') && !name.startsWith('.');
    const bool everywhere = plain && is_name_of_files(name);
    // An album that has not been on a stick may have it by the name itself.
    if (everywhere || (plain && name_taken(place(name))))
        return place(name);
    return place(name.toPercentEncoding(" ", "/%.\\"));
}

} // namespace

std::string AlbumKeeper::put_face(const FaceToName& to, FaceBefore* before) {
    return change_sidecar(to.photo, [&](const PhotoRecord& record) {
        SidecarChanges changes;
        changes.faces = record.faces;
        const auto there = find_face(*changes.faces, to.face);
        const bool known = there != changes.faces->end();
        const std::string gone = known ? there->name : std::string{};
        if (before && known)
            *before = {true, *there};
        if (known)
            there->name = to.face.name;
        else
            changes.faces->push_back(to.face);
        changes.persons = persons_after(record.persons, gone, to.face.name, *changes.faces);
        return changes;
    });
}

std::string AlbumKeeper::put_face_back(const FaceToName& put, const FaceBefore& before) {
    if (before.was_there)
        return put_face({put.photo, before.face});
    return change_sidecar(put.photo, [&](const PhotoRecord& record) {
        SidecarChanges changes;
        changes.faces = record.faces;
        if (const auto there = find_face(*changes.faces, put.face); there != changes.faces->end()) {
            const std::string gone = there->name;
            changes.faces->erase(there);
            changes.persons = persons_after(record.persons, gone, {}, *changes.faces);
        }
        return changes;
    });
}

std::string AlbumKeeper::name_faces(const std::vector<FaceToName>& faces) {
    for (const FaceToName& face : faces)
        if (!makes_sense(face.face))
            return "The place of the face must lie in the picture, 0 to 1 from its left and upper edge.";
    if (faces.empty())
        return {};
    const auto before = std::make_shared<std::vector<FaceBefore>>(); // of those that were put, in their order
    const auto back = [this, faces, before] {
        for (; !before->empty(); before->pop_back())
            if (std::string problem = put_face_back(faces[before->size() - 1], before->back());
                !problem.empty())
                return problem;
        return std::string{};
    };
    const auto put = [this, faces, before, back] {
        std::string problem;
        for (const FaceToName& face : faces) {
            FaceBefore was;
            problem = put_face(face, &was);
            if (!problem.empty())
                break;
            before->push_back(was);
        }
        const std::string stuck = problem.empty() ? std::string{} : back();
        return problem + (stuck.empty() ? std::string{} : " Some photographs kept the new name: " + stuck);
    };
    if (std::string problem = put(); !problem.empty())
        return problem;
    const std::string& name = faces.front().face.name;
    history_.done({faces.size() > 1 && !name.empty()
                       ? std::to_string(faces.size()) + " faces were named " + readable(name)
                   : name.empty() ? "a face lost its name"
                                  : "a face was named " + readable(name),
                   back, put});
    return {};
}

std::string AlbumKeeper::name_face(const fs::path& photo, const FaceRegion& face) {
    return name_faces({{photo, face}});
}

std::string AlbumKeeper::rename_on(const fs::path& photo, const std::string& from, const std::string& to) {
    const auto record = read_record(photo);
    if (!record)
        return record.error();
    for (const Tag& tag : record->tags)
        if (is_about(tag, from)) {
            RecordingLabel label = tag.label;
            if (label.person == from)
                label.person = to;
            if (label.speaker == from)
                label.speaker = to;
            if (std::string problem = relabel(photo, tag.file, label); !problem.empty())
                return problem;
        }
    return change_sidecar(photo, [&](const PhotoRecord& now) {
        SidecarChanges changes;
        std::vector<FaceRegion> faces = now.faces;
        for (FaceRegion& face : faces)
            if (face.name == from)
                face.name = to;
        const bool named = contains(now.persons, from);
        if (faces != now.faces)
            changes.faces = faces;
        if (named || faces != now.faces)
            changes.persons = persons_after(now.persons, from, to, faces);
        return changes;
    });
}

std::string AlbumKeeper::rename_back(const fs::path& photo, const PhotoRecord& before,
                                     const std::string& from, const std::string& to) {
    for (const Tag& tag : before.tags)
        if (is_about(tag, from))
            if (std::string problem = relabel(photo, tag.file, tag.label); !problem.empty())
                return problem;
    return change_sidecar(photo, [&](const PhotoRecord& now) {
        SidecarChanges changes;
        changes.faces = now.faces;
        for (const FaceRegion& face : before.faces)
            if (const auto there = find_face(*changes.faces, face);
                face.name == from && there != changes.faces->end() && there->name == to)
                there->name = from;
        changes.persons = now.persons;
        if (!contains(before.persons, to))
            std::erase(*changes.persons, to);
        if (contains(before.persons, from))
            changes.persons->push_back(from);
        return changes;
    });
}

Result<std::size_t> AlbumKeeper::rename_person(const std::vector<fs::path>& photos, const std::string& from,
                                               const std::string& to) {
    if (from.empty() || to.empty() || from == to)
        return Error{"A person needs a name, and a different one than before."};
    /// What the photographs that changed said before.
    const auto changed = std::make_shared<std::vector<std::pair<fs::path, PhotoRecord>>>();
    const auto back = [this, changed, from, to] {
        for (const auto& [photo, before] : *changed)
            if (std::string problem = rename_back(photo, before, from, to); !problem.empty())
                return problem;
        return std::string{};
    };
    for (const fs::path& photo : photos) {
        const std::string unknown = outside(photo);
        const auto record = unknown.empty() ? read_record(photo) : Result<PhotoRecord>(Error{unknown});
        std::string problem = record.error();
        if (record && speaks_of(*record, from)) {
            changed->emplace_back(photo, *record);
            problem = rename_on(photo, from, to);
        }
        if (problem.empty())
            continue;
        const std::string stuck = back();
        return Error{problem +
                     (stuck.empty() ? std::string{} : " Some photographs kept the new name: " + stuck)};
    }
    if (!changed->empty())
        history_.done({readable(from) + " became " + readable(to), back, [this, changed, from, to] {
                           for (const auto& [photo, before] : *changed)
                               if (std::string problem = rename_on(photo, from, to); !problem.empty())
                                   return problem;
                           return std::string{};
                       }});
    return changed->size();
}

fs::path AlbumKeeper::place_of_name(const std::string& person) const { return name_file(album_, person); }

std::optional<fs::path> AlbumKeeper::name_recording(const std::string& person) const {
    const fs::path file = place_of_name(person);
    return file_there(file) ? std::optional(file) : std::nullopt;
}

std::string AlbumKeeper::keep_name_recording(const std::string& person, const fs::path& sound) {
    if (person.empty())
        return "A person needs a name before it can be recorded.";
    const fs::path file = place_of_name(person);
    if (const std::string reason = make_folder(file.parent_path(), Readers::owner_only); !reason.empty())
        return "The name cannot be saved: " + reason;
    const auto taken_in =
        import_sound(sound, file.parent_path(), {{RecordingKind::person, person, {}, {}, {}, {}}, {}});
    if (!taken_in)
        return quoted(sound) + " cannot be added: " + taken_in.error();
    const auto earlier = std::make_shared<std::string>(); // in the trash
    const auto put_away = [this, file, person](std::string& id) {
        const auto put = trash_.put({file}, "how somebody says " + readable(person));
        if (put)
            id = *put;
        return put.error();
    };
    std::string problem = name_taken(file) ? put_away(*earlier) : std::string{};
    if (problem.empty())
        problem = move_file(taken_in->file, file);
    if (!problem.empty()) {
        remove_file(taken_in->file);
        if (const std::string stuck = earlier->empty() ? std::string{} : trash_.restore(*earlier);
            !stuck.empty())
            problem += " " + stuck;
        return "The name cannot be saved: " + problem;
    }
    const auto later = std::make_shared<std::string>();
    const auto exchange = [this, put_away](std::string& away, const std::string& back) {
        std::string stuck = put_away(away);
        return !stuck.empty() || back.empty() ? stuck : trash_.restore(back);
    };
    history_.done({"the name of " + readable(person) + " was recorded",
                   [exchange, earlier, later] { return exchange(*later, *earlier); },
                   [this, exchange, earlier, later] {
                       return earlier->empty() ? trash_.restore(*later) : exchange(*earlier, *later);
                   }});
    return {};
}

std::string AlbumKeeper::rename_name_recording(const std::string& from, const std::string& to) {
    const fs::path file = place_of_name(from);
    if (to.empty() || from == to || is_gone(file) || link_there(file))
        return {};
    if (name_taken(place_of_name(to))) {
        const std::string what = "how somebody says " + readable(from);
        const auto id = std::make_shared<std::string>();
        const auto put_away = [this, file, what, id] {
            const auto put = trash_.put({file}, what);
            if (put)
                *id = *put;
            return put.error();
        };
        if (std::string problem = put_away(); !problem.empty())
            return problem;
        history_.done({what + " was deleted", [this, id] { return trash_.restore(*id); }, put_away});
        return {};
    }
    const auto give = [this](const std::string& one, const std::string& other) -> std::string {
        const fs::path place = place_of_name(one);
        const auto about = about_recording(place);
        if (!about)
            return quoted(place) + " cannot be used: " + about.error();
        RecordingNotes notes = about->notes;
        notes.label.person = other;
        std::string reason = relabel_recording(place, notes); // after a kill the check moves it to its place
        if (reason.empty())
            reason = move_file(place, place_of_name(other));
        return reason.empty() ? reason : quoted(place) + " cannot be renamed: " + reason;
    };
    if (std::string problem = give(from, to); !problem.empty())
        return problem;
    history_.done({"the recorded name of " + readable(from) + " became that of " + readable(to),
                   [give, from, to] { return give(to, from); }, [give, from, to] { return give(from, to); }});
    return {};
}

} // namespace tp
