// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/group_care.hpp"

#include "app/album/metadata/read_record.hpp"
#include "app/pages/care/care_words.hpp"
#include "app/photo/people/region_place.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// Its place in the sidecar: that of a mark that is there already, else the one where it was found.
FaceRegion region_of(const PersonFace& face) {
    const auto record = read_record(face.photo);
    const PictureTurn turn{record ? record->orientation : face.orientation, face.turned_degrees};
    if (record)
        for (const FaceRegion& region : record->faces)
            if (same_face(shown_part(region, turn), face.part))
                return region;
    return stored_region(face.part, turn);
}

/// Those of photographs that are there.
std::vector<AlbumKeeper::FaceToName> to_name(const std::vector<PersonFace>& faces, const std::string& name) {
    std::vector<AlbumKeeper::FaceToName> named;
    std::error_code error;
    for (const PersonFace& face : faces) {
        if (!fs::exists(face.photo, error))
            continue;
        FaceRegion region = region_of(face);
        region.name = name;
        named.push_back({face.photo, region});
    }
    return named;
}

std::set<fs::path> photos_of(const std::vector<PersonFace>& faces) {
    std::set<fs::path> photos;
    for (const PersonFace& face : faces)
        photos.insert(face.photo);
    return photos;
}

/// "Not this person", with the way back, as one step.
std::string take_out(AlbumKeeper& keeper, AlbumFaces& groups, const PersonFace& face,
                     const std::string& name) {
    const auto said = std::make_shared<GroupsChange>();
    const auto apart = [&groups, said, id = face.id] {
        auto change = groups.say([id](FaceGroups& all) { return all.take_out(id); });
        if (change)
            *said = std::move(*change);
        return change.error();
    };
    if (std::string problem = apart(); !problem.empty())
        return problem;
    const std::string what =
        name.empty() ? "a face was taken out of its group" : "a face is not that of " + readable(name);
    if (face.said)
        if (std::string problem = keeper.name_faces(to_name({face}, {})); !problem.empty()) {
            groups.undo(*said);
            return problem;
        }
    keeper.history().done({what, [&groups, said] { return groups.undo(*said); }, apart});
    if (face.said)
        keeper.history().join(what);
    return {};
}

} // namespace

GroupCare::GroupCare(OpenAlbum& album, AlbumFaces& groups, KeeperSteps& steps, CareTeller& teller,
                     Suggest suggest)
    : album_(album), groups_(groups), steps_(steps), teller_(teller), suggest_(std::move(suggest)) {
    connect(&groups_, &AlbumFaces::people, this, &GroupCare::take);
    connect(&groups_, &AlbumFaces::changed, this, &GroupCare::changed); // on or off
}

void GroupCare::take(const std::shared_ptr<const People>& people) {
    if (!shown_)
        return;
    const bool first = !people_;
    people_ = people;
    if (on_the_way_ == 0)
        answered_.clear();
    rows_.take(people);
    const PersonFace* const selected = faces_.face(selected_);
    const std::optional<PersonFace> kept = selected ? std::optional(*selected) : std::nullopt;
    faces_.take(open_person());
    selected_ = kept ? faces_.row_of(*kept) : -1;
    if (first)
        teller_.tell(summary());
    emit changed();
}

QString GroupCare::summary() const {
    if (!people_)
        return tr("Looking for people…");
    return CareWords::people(*people_);
}

QString GroupCare::title() const {
    const Person* const person = open_person();
    return person ? CareWords::person(*person) : QString();
}

QString GroupCare::details() const {
    const Person* const person = open_person();
    return person ? CareWords::person_details(*person) : QString();
}

QString GroupCare::name() const {
    const Person* const person = open_person();
    return person ? CareWords::text(person->name) : QString();
}

QString GroupCare::offer() const {
    const Person* const person = open_person();
    if (!person || person->to_confirm == 0)
        return {};
    return CareWords::text(person->name.empty() ? person->perhaps : person->name);
}

void GroupCare::show() {
    shown_ = true;
    open_ = 0;
    selected_ = -1;
    people_.reset();
    rows_.begin_anew();
    faces_.take(nullptr);
    teller_.answer(tr("People"));
    groups_.want_people(true);
    emit changed();
    emit personChosen();
}

void GroupCare::hide() {
    if (!std::exchange(shown_, false))
        return;
    groups_.want_people(false);
    emit changed();
}

void GroupCare::choose(int row) {
    open(row);
    if (open_person())
        teller_.answer(title().endsWith('?') ? tr("%1 %2.").arg(title(), details())
                                             : tr("%1. %2.").arg(title(), details()));
}

bool GroupCare::back() {
    if (open_ != 0)
        choose(-1);
    else if (shown_)
        hide();
    else
        return false;
    return true;
}

void GroupCare::open(int row) {
    const Person* const person = rows_.person(row);
    open_ = person ? person->groups.front() : 0;
    selected_ = -1;
    faces_.take(person);
    emit changed();
    emit personChosen();
}

void GroupCare::nameAll(const QString& name) {
    const Person* const person = open_person();
    const QString clean = name.simplified();
    if (!person || clean.isEmpty())
        return;
    const std::string meant = name_meant(clean);
    if (person->name.empty() || meant == person->name) {
        std::vector<PersonFace> faces = person->faces;
        std::erase_if(faces, [](const PersonFace& face) { return face.said; });
        name_them(faces, meant);
    } else {
        rename(*person, meant);
    }
}

std::string GroupCare::name_meant(const QString& words) const {
    const auto is_shown_so = [&](const std::string& name) {
        return !name.empty() && CareWords::text(name).simplified() == words;
    };
    if (const Person* const person = open_person(); person && is_shown_so(person->perhaps))
        return person->perhaps;
    for (int row = 0; const Person* const person = rows_.person(row); ++row)
        if (is_shown_so(person->name))
            return person->name;
    return words.toStdString();
}

void GroupCare::confirm() {
    if (const QString who = offer(); !who.isEmpty())
        nameAll(who);
}

void GroupCare::name_them(const std::vector<PersonFace>& faces, const std::string& name) {
    std::map<AlbumKeeper*, std::vector<PersonFace>> by_keeper;
    for (const PersonFace& face : faces)
        by_keeper[&album_.keeper_for(face.photo)].push_back(face);
    Steps steps;
    for (const auto& [keeper, of_it] : by_keeper)
        steps[keeper] = [theirs = of_it, name](AlbumKeeper& of_album) {
            return of_album.name_faces(to_name(theirs, name));
        };
    write(steps, CareWords::text(name), photos_of(faces));
}

/// On all photographs on which somebody has said the old name, recordings included.
void GroupCare::rename(const Person& person, const std::string& name) {
    std::vector<PersonFace> said = person.faces;
    std::erase_if(said, [](const PersonFace& face) { return !face.said; });
    std::map<AlbumKeeper*, std::set<fs::path>> by_keeper;
    for (const PersonFace& face : said)
        by_keeper[&album_.keeper_for(face.photo)].insert(face.photo);
    Steps steps;
    for (const auto& [keeper, photos] : by_keeper)
        steps[keeper] = [photos = std::vector(photos.begin(), photos.end()), from = person.name,
                         to = name](AlbumKeeper& of_album) {
            return of_album.rename_person(photos, from, to).error();
        };
    write(steps, CareWords::text(name), photos_of(said));
}

void GroupCare::write(const Steps& steps, const QString& name, const std::set<fs::path>& photos) {
    const Answer answer = answered();
    if (steps.empty()) {
        named(answer, name, {}, {});
        return;
    }
    const auto left = std::make_shared<std::size_t>(steps.size());
    const auto problems = std::make_shared<QString>();
    for (const auto& [keeper, step] : steps)
        steps_.run(*keeper, step, [this, answer, left, problems, name, photos](const QString& problem) {
            if (!problem.isEmpty())
                *problems = problem;
            if (--*left == 0)
                named(answer, name, photos, *problems);
        });
}

GroupCare::Answer GroupCare::answered() {
    Answer groups;
    if (const Person* const person = open_person())
        groups.insert(person->groups.begin(), person->groups.end());
    answered_.insert(groups.begin(), groups.end());
    ++on_the_way_;
    open(next_without_a_name());
    return groups;
}

void GroupCare::named(const Answer& answer, const QString& name, const std::set<fs::path>& photos,
                      const QString& problem) {
    --on_the_way_;
    for (const fs::path& photo : photos)
        album_.touched(photo);
    if (!problem.isEmpty()) {
        for (const GroupId group : answer)
            answered_.erase(group);
        teller_.problem(problem);
        return;
    }
    const QString told =
        tr("Saved: %1, on %2.").arg(name, tr("%n photograph(s)", nullptr, static_cast<int>(photos.size())));
    if (const Person* const person = open_person())
        teller_.did(Earcon::saved,
                    tr("%1 Who is the next? %2.").arg(told, CareWords::person_details(*person)));
    else if (next_without_a_name() < 0)
        teller_.did(Earcon::saved, tr("%1 Nobody is left without a name.").arg(told));
    else
        teller_.did(Earcon::saved, told);
}

int GroupCare::next_without_a_name() const {
    for (int row = 0; const Person* const person = rows_.person(row); ++row)
        if (person->name.empty() && !answered_.contains(person->groups.front()))
            return row;
    return -1;
}

void GroupCare::select(int face) {
    selected_ = faces_.face(face) ? face : -1;
    emit changed();
    if (selected_ >= 0)
        teller_.answer(tr("Selected: %1.").arg(CareWords::file_name(faces_.face(selected_)->photo)));
}

void GroupCare::notThisPerson(int face) {
    const Person* const person = open_person();
    const PersonFace* const wrong = faces_.face(face);
    if (!person || !wrong)
        return;
    const QString who = name();
    steps_.run(
        album_.keeper_for(wrong->photo),
        [&groups = groups_, face = *wrong, name = person->name](AlbumKeeper& keeper) {
            return take_out(keeper, groups, face, name);
        },
        [this, who, photo = wrong->photo](const QString& problem) {
            album_.touched(photo);
            if (!problem.isEmpty())
                teller_.problem(problem);
            else
                teller_.did(Earcon::deleted, who.isEmpty() ? tr("This face is somebody else's.")
                                                           : tr("This face is not that of %1.").arg(who));
        });
}

void GroupCare::openPhoto() {
    if (const PersonFace* const face = faces_.face(selected_)) {
        const fs::path photo = face->photo;
        hide();
        emit photoAsked(photo);
    }
}

/// Whom the faces are like comes first.
QStringList GroupCare::suggestions(const QString& typed) const {
    QStringList names = suggest_(typed);
    if (const QString who = offer(); typed.trimmed().isEmpty() && name().isEmpty() && !who.isEmpty()) {
        names.removeAll(who);
        names.prepend(who);
    }
    return names;
}

} // namespace tp
