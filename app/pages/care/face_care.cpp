// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/face_care.hpp"

#include "app/album/keeper/name_languages.hpp"
#include "app/pages/care/care_words.hpp"
#include "audio/sentences/sentences.hpp"

#include <QRect>
#include <QRectF>
#include <QVariantMap>

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr int crop_px = 320;
const QStringList usual_languages{"en", "de", "ko", "fr", "es", "it", "pt", "nl", "pl", "tr", "vi"};

Rect part_of(const Rect& box, const Extraction& extraction) {
    const Vec2 size(extraction.width, extraction.height);
    return {box.min / size, box.max / size};
}

/// The face with some of what is round it.
QImage crop(const QImage& image, const Rect& part) {
    if (image.isNull())
        return {};
    const double around = 0.25 * std::max(part.width() * image.width(), part.height() * image.height());
    const QRectF pixels(part.min.x * image.width(), part.min.y * image.height(), part.width() * image.width(),
                        part.height() * image.height());
    const QRect inside = pixels.adjusted(-around, -around, around, around).toAlignedRect() & image.rect();
    const QImage cut = image.copy(inside);
    return std::max(cut.width(), cut.height()) <= crop_px
               ? cut
               : cut.scaled(crop_px, crop_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

double size_of_part(const Rect& part) { return part.width() * part.height(); }

} // namespace

FaceCare::FaceCare(CaredPhoto& photo, FaceFinder& finder, AlbumFaces& groups, CareTeller& teller,
                   Suggest suggest)
    : photo_(photo), finder_(finder), groups_(groups), teller_(teller), suggest_(std::move(suggest)),
      languages_(usual_languages) {
    connect(&photo_, &CaredPhoto::opened, this, [this] {
        found_.reset();
        offers_.clear();
        chosen_ = -1;
        ++choice_;
        list_faces();
        finder_.want(photo_.place().photo);
        ask();
    });
    connect(&groups_, &AlbumFaces::changed, this, &FaceCare::ask);
    connect(&groups_, &AlbumFaces::offered, this,
            [this](const std::filesystem::path& of, const std::vector<FaceOffer>& offers) {
                if (of != photo_.place().photo)
                    return;
                offers_ = offers;
                list_faces();
            });
    connect(&photo_, &CaredPhoto::changed, this, &FaceCare::list_faces);
    connect(&finder_, &FaceFinder::found, this, [this](std::shared_ptr<const FoundFaces> found) {
        if (found->photo != photo_.place().photo)
            return;
        found_ = std::move(found);
        list_faces();
    });
}

void FaceCare::ask() {
    if (!groups_.on())
        offers_.clear();
    if (photo_.is_open())
        groups_.ask(photo_.place().photo);
}

std::string FaceCare::offer_for(const Rect& part) const {
    const auto found = std::ranges::find_if(offers_, [&](const FaceOffer& offer) {
        return offer.turned_degrees == turn().turned_degrees && same_face(offer.part, part);
    });
    return found == offers_.end() ? std::string() : found->name;
}

PictureTurn FaceCare::turn() const {
    return {photo_.record().orientation, found_ ? found_->extraction.turned_degrees : 0};
}

/// What was found and what was marked, as one list: a found face that somebody marked has the mark's place and name.
void FaceCare::list_faces() {
    const Rect chosen = chosen_ >= 0 ? faces_[static_cast<std::size_t>(chosen_)].part : Rect{};
    faces_.clear();
    for (const FaceRegion& region : photo_.record().faces)
        faces_.push_back({shown_part(region, turn()), region, {}, {}});
    if (found_ && found_->extraction.width > 0)
        for (const Face& face : found_->extraction.faces) {
            const Rect part = part_of(face.box, found_->extraction);
            const auto same = std::find_if(faces_.begin(), faces_.end(), [&](const KnownFace& known) {
                return same_face(known.part, part);
            });
            const QString problem = face.mended.empty() ? in_persons_language(face.problem) : QString();
            if (same == faces_.end())
                faces_.push_back({part, stored_region(part, turn()), problem, {}});
            else
                same->problem = problem;
        }
    for (KnownFace& face : faces_)
        face.offer = face.region.name.empty() ? offer_for(face.part) : std::string();
    std::stable_sort(faces_.begin(), faces_.end(), [](const KnownFace& a, const KnownFace& b) {
        return std::pair(!a.region.name.empty(), -size_of_part(a.part)) <
               std::pair(!b.region.name.empty(), -size_of_part(b.part));
    });
    const auto again = std::find_if(faces_.begin(), faces_.end(), [&](const KnownFace& face) {
        return face.part.min == chosen.min && face.part.max == chosen.max;
    });
    chosen_ = chosen_ < 0 || again == faces_.end() ? -1 : static_cast<int>(again - faces_.begin());
    list_languages();
    emit changed();
}

std::string FaceCare::chosen_language() const {
    const std::string name = chosenName().toStdString();
    for (const NameLanguage& each : photo_.name_languages())
        if (each.person == name)
            return each.language;
    return {};
}

/// The usual ones and, while it may be chosen again, one that somebody chose in another way.
void FaceCare::list_languages() {
    const QString own = QString::fromStdString(chosen_language());
    QStringList all = languages_;
    if (chosenName().isEmpty())
        all = usual_languages;
    else if (!own.isEmpty() && !all.contains(own))
        all = usual_languages + QStringList{own};
    if (all == languages_)
        return;
    languages_ = all;
    emit languagesChanged();
}

QStringList FaceCare::languages() const {
    QStringList words;
    for (const QString& tag : languages_)
        words << CareWords::language(tag);
    return words;
}

int FaceCare::language() const {
    return static_cast<int>(languages_.indexOf(QString::fromStdString(chosen_language())));
}

QString FaceCare::face_words(int face) const {
    const KnownFace& known = faces_[static_cast<std::size_t>(face)];
    if (!known.region.name.empty())
        return CareWords::text(known.region.name);
    return known.offer.empty() ? tr("Face without a name")
                               : tr("Perhaps %1").arg(CareWords::text(known.offer));
}

QVariantList FaceCare::faces() const {
    QVariantList list;
    for (int i = 0; i < count(); ++i) {
        const KnownFace& face = faces_[static_cast<std::size_t>(i)];
        list << QVariantMap{{"text", face_words(i)},
                            {"problem", face.problem},
                            {"named", !face.region.name.empty()},
                            {"offer", CareWords::text(face.offer)},
                            {"picture", found_ ? crop(found_->image, face.part) : QImage()},
                            {"chosen", i == chosen_}};
    }
    return list;
}

QString FaceCare::chosenName() const {
    return chosen_ < 0 ? QString() : QString::fromStdString(faces_[static_cast<std::size_t>(chosen_)].region.name);
}

int FaceCare::next_without_a_name() const {
    return !faces_.empty() && faces_.front().region.name.empty() ? 0 : -1; // they come first
}

QString FaceCare::summary() const {
    if (!photo_.is_open())
        return {};
    if (!found_)
        return tr("Looking for faces…");
    if (faces_.empty())
        return found_->extraction.problem.empty() ? tr("No face was found on this photograph.")
                                                  : in_persons_language(found_->extraction.problem);
    const auto unnamed = static_cast<int>(std::count_if(
        faces_.begin(), faces_.end(), [](const KnownFace& face) { return face.region.name.empty(); }));
    if (count() == 1)
        return unnamed == 0 ? tr("One face, with a name.") : tr("One face, without a name.");
    const QString faces = tr("%n face(s)", nullptr, count());
    return unnamed == 0 ? tr("%1, all with a name.").arg(faces)
                        : tr("%1, %2.").arg(faces, tr("%n without a name", nullptr, unnamed));
}

void FaceCare::open_for_naming(int face) {
    chosen_ = face;
    ++choice_;
    list_languages();
    emit changed();
    emit faceChosen();
}

void FaceCare::choose(int face) {
    open_for_naming(face >= 0 && face < count() ? face : -1);
    if (chosen_ >= 0)
        teller_.answer(tr("%1, %2 of %3. Type a name or choose one below.")
                           .arg(face_words(chosen_))
                           .arg(chosen_ + 1)
                           .arg(count()));
}

void FaceCare::keep_name(const KnownFace& face, const QString& name, std::function<void()> then) {
    FaceRegion region = face.region;
    region.name = name.toStdString();
    photo_.change(
        photo_.place(),
        [region](AlbumKeeper& keeper, const std::filesystem::path& photo) {
            return keeper.name_face(photo, region);
        },
        [this, then = std::move(then)](const QString& problem) {
            if (problem.isEmpty())
                then();
            else
                teller_.problem(problem);
        });
}

void FaceCare::name(const QString& typed) {
    if (chosen_ < 0)
        return;
    const QString name = typed.simplified();
    keep_name(faces_[static_cast<std::size_t>(chosen_)], name, [this, name, choice = choice_] {
        const bool waited =
            choice == choice_; // no other face was opened meanwhile, here or on another photograph
        if (waited)
            open_for_naming(name.isEmpty() ? -1 : next_without_a_name());
        const QString told = name.isEmpty() ? tr("This face has no name now.") : tr("Saved: %1.").arg(name);
        teller_.did(Earcon::saved, waited && chosen_ >= 0 ? tr("%1 Who is the next face?").arg(told) : told);
    });
}

void FaceCare::accept(int face) {
    if (face < 0 || face >= count() || faces_[static_cast<std::size_t>(face)].offer.empty())
        return;
    const std::string name = faces_[static_cast<std::size_t>(face)].offer;
    keep_name(faces_[static_cast<std::size_t>(face)], QString::fromStdString(name),
              [this, name, choice = choice_] {
                  const int next = choice == choice_ ? next_without_a_name() : -1;
                  const QString told = tr("Saved: %1.").arg(CareWords::text(name));
                  teller_.did(Earcon::saved, next < 0 ? told : tr("%1 %2?").arg(told, face_words(next)));
              });
}

void FaceCare::readNameIn(int language) {
    const QString name = chosenName();
    if (name.isEmpty() || language < -1 || language >= languages_.size())
        return;
    const QString tag = language < 0 ? QString() : languages_[language];
    photo_.change(
        photo_.place(),
        [name = name.toStdString(), tag = tag.toStdString()](AlbumKeeper& keeper, const std::filesystem::path&) {
            return NameLanguages(keeper).choose(name, tag);
        },
        [this, name, tag](const QString& problem) {
            if (!problem.isEmpty())
                teller_.problem(problem);
            else
                teller_.did(
                    Earcon::saved,
                    tag.isEmpty()
                        ? tr("Saved: %1 is read in the page's language.").arg(name)
                        : tr("Saved: %1. Language of the name: %2.").arg(name, CareWords::language(tag)));
        });
}

QStringList FaceCare::suggestions(const QString& typed) const {
    QStringList here, elsewhere;
    if (chosen_ >= 0 && typed.trimmed().isEmpty())
        if (const std::string& offer = faces_[static_cast<std::size_t>(chosen_)].offer; !offer.empty())
            elsewhere << QString::fromStdString(offer);
    for (const QString& person : suggest_(typed)) {
        const bool on_it = std::any_of(faces_.begin(), faces_.end(), [&](const KnownFace& face) {
            return QString::fromStdString(face.region.name) == person;
        });
        if (!elsewhere.contains(person))
            (on_it ? here : elsewhere) << person;
    }
    return elsewhere + here;
}

} // namespace tp
