// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/recording_list.hpp"

#include "app/album/metadata/read_record.hpp"
#include "app/pages/care/care_words.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/files/file_name.hpp"

#include <QLocale>
#include <QVariantMap>

#include <algorithm>
#include <climits>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// In the order in which recordings are heard: a person's own order, then by kind (playback_order.hpp).
std::vector<Tag> as_played(std::vector<Tag> tags) {
    std::stable_sort(tags.begin(), tags.end(), [](const Tag& a, const Tag& b) {
        const auto rank = [](const Tag& tag) { return tag.order > 0 ? tag.order : INT_MAX; };
        return std::pair(rank(a), a.label.kind) < std::pair(rank(b), b.label.kind);
    });
    return tags;
}

/// Changes places with what is played `by` before or after it, as far as there is one. `place`: where it is now.
std::string change_places(AlbumKeeper& keeper, const fs::path& photo, const std::string& file, int by,
                          std::ptrdiff_t& place) {
    const auto record = read_record(photo);
    if (!record)
        return record.error();
    std::vector<std::string> files;
    for (const Tag& tag : as_played(record->tags))
        files.push_back(tag.file);
    const auto at = std::find(files.begin(), files.end(), file);
    if (at == files.end())
        return keeper.order_recordings(photo, {file}); // says that it is not there
    place = std::clamp<std::ptrdiff_t>(at - files.begin() + by, 0, std::ssize(files) - 1);
    if (files.begin() + place == at)
        return {};
    std::iter_swap(at, files.begin() + place);
    return keeper.order_recordings(photo, files);
}

/// BCP 47; the system's and those of recordings are added.
const QStringList common_languages{"", "en", "de", "ko", "fr", "es", "tr", "ar"};

} // namespace

RecordingList::RecordingList(CaredPhoto& photo, CareTeller& teller) : photo_(photo), teller_(teller) {
    connect(&photo_, &CaredPhoto::changed, this, &RecordingList::list);
}

/// The chosen one stays the chosen one where it is still there; else the one that came to its place is.
void RecordingList::list() {
    std::vector<Tag> tags = as_played(photo_.record().tags);
    if (tags == tags_)
        return;
    tags_ = std::move(tags);
    const int same = index_of(chosen_file_);
    become(same >= 0 ? same : std::min(std::max(chosen_, 0), count() - 1));
}

void RecordingList::become(int chosen) {
    chosen_ = chosen;
    const std::string before = std::exchange(chosen_file_, chosen_ < 0 ? std::string{} : chosen_tag()->file);
    emit changed();
    if (chosen_file_ != before)
        emit chosenChanged();
}

int RecordingList::index_of(const std::string& file) const {
    const auto found =
        std::find_if(tags_.begin(), tags_.end(), [&](const Tag& tag) { return tag.file == file; });
    return found == tags_.end() ? -1 : static_cast<int>(found - tags_.begin());
}

void RecordingList::choose_file(const PhotoPlace& place, const std::string& file) {
    if (const int found = place.photo == photo_.place().photo ? index_of(file) : -1; found >= 0)
        become(found);
}

const Tag* RecordingList::chosen_tag() const {
    return chosen_ < 0 ? nullptr : &tags_[static_cast<std::size_t>(chosen_)];
}

QString RecordingList::words_of(int recording) const {
    return CareWords::recording(tags_[static_cast<std::size_t>(recording)].label);
}

QVariantList RecordingList::rows() const {
    QVariantList rows;
    for (int i = 0; i < count(); ++i)
        rows << QVariantMap{{"text", words_of(i)},
                            {"detail", CareWords::recording_details(tags_[static_cast<std::size_t>(i)])},
                            {"chosen", i == chosen_}};
    return rows;
}

QString RecordingList::chosenText() const { return chosen_ < 0 ? QString() : words_of(chosen_); }

QStringList RecordingList::kinds() const { return CareWords::kinds(); }

int RecordingList::kind() const { return chosen_ < 0 ? -1 : static_cast<int>(chosen_tag()->label.kind); }

QString RecordingList::person() const {
    return chosen_ < 0 ? QString() : QString::fromStdString(chosen_tag()->label.person);
}

QString RecordingList::speaker() const {
    return chosen_ < 0 ? QString() : QString::fromStdString(chosen_tag()->label.speaker);
}

QStringList RecordingList::languages() const {
    QStringList all = common_languages;
    if (const QString own = QLocale().bcp47Name().section('-', 0, 0); !own.isEmpty() && !all.contains(own))
        all << own;
    for (const Tag& tag : tags_)
        if (const QString one = QString::fromStdString(tag.label.language); !all.contains(one))
            all << one;
    return all;
}

QStringList RecordingList::languageNames() const {
    QStringList names;
    for (const QString& one : languages())
        names << (one.isEmpty() ? tr("Not given") : CareWords::language(one));
    return names;
}

int RecordingList::language() const {
    return chosen_ < 0
               ? -1
               : static_cast<int>(languages().indexOf(QString::fromStdString(chosen_tag()->label.language)));
}

void RecordingList::choose(int recording) {
    if (recording < 0 || recording >= count())
        return;
    if (recording != chosen_)
        become(recording);
    teller_.answer(tr("%1, %2, %3 of %4")
                       .arg(words_of(recording), CareWords::recording_details(*chosen_tag()))
                       .arg(recording + 1)
                       .arg(count()));
}

void RecordingList::move(int by) {
    const int to = chosen_ + by + (moving_ == chosen_file_ ? moves_by_ : 0);
    if (chosen_ < 0 || to < 0 || to >= count()) {
        teller_.problem(by < 0 ? tr("This is the first one.") : tr("This is the last one."));
        return;
    }
    moving_ = chosen_file_;
    moves_by_ = to - chosen_;
    ++moves_;
    const auto place = std::make_shared<std::ptrdiff_t>();
    photo_.change(
        photo_.place(),
        [file = chosen_file_, by, place](AlbumKeeper& keeper, const fs::path& photo) {
            return change_places(keeper, photo, file, by, *place);
        },
        [this, file = chosen_file_, by, place, what = chosenText(), of = count()](const QString& problem) {
            if (--moves_ == 0)
                moves_by_ = 0;
            else if (moving_ == file)
                moves_by_ -= by;
            if (problem.isEmpty())
                teller_.did(Earcon::saved,
                            tr("%1 is now number %2 of %3.").arg(what).arg(*place + 1).arg(of));
            else
                teller_.problem(problem);
        });
}

void RecordingList::remove() {
    if (chosen_ < 0)
        return;
    const QString what = chosenText();
    photo_.change(
        photo_.place(),
        [file = chosen_file_](AlbumKeeper& keeper, const fs::path& photo) {
            return keeper.delete_recording(photo, file);
        },
        [this, what](const QString& problem) {
            if (problem.isEmpty())
                teller_.did(Earcon::deleted, tr("Deleted: %1. Undo brings it back.").arg(what));
            else
                teller_.problem(problem);
        });
}

/// The label is asked of the disk when the step's turn comes, for others may be on their way there.
void RecordingList::relabel(std::function<void(RecordingLabel&)> change) {
    if (chosen_ < 0)
        return;
    const auto label = std::make_shared<RecordingLabel>(chosen_tag()->label);
    change(*label);
    if (relabelling_ == 0 && *label == chosen_tag()->label)
        return;
    ++relabelling_;
    photo_.change(
        photo_.place(),
        [file = chosen_file_, label, change = std::move(change)](AlbumKeeper& keeper, const fs::path& photo) {
            const auto record = read_record(photo);
            if (!record)
                return record.error();
            for (const Tag& tag : record->tags)
                if (tag.file == file) {
                    *label = tag.label;
                    change(*label);
                }
            return keeper.label_recording(photo, file, *label);
        },
        [this, label](const QString& problem) {
            --relabelling_;
            if (problem.isEmpty())
                teller_.did(Earcon::saved, tr("Saved: %1.").arg(CareWords::recording(*label)));
            else
                teller_.problem(problem);
        });
}

void RecordingList::setKind(int kind) {
    if (kind < 0 || kind >= CareWords::kinds().size())
        return;
    relabel([kind](RecordingLabel& label) { label.kind = static_cast<RecordingKind>(kind); });
}

void RecordingList::setPerson(const QString& name) {
    relabel([name = name.simplified().toStdString()](RecordingLabel& label) { label.person = name; });
}

void RecordingList::setSpeaker(const QString& name) {
    relabel([name = name.simplified().toStdString()](RecordingLabel& label) { label.speaker = name; });
}

void RecordingList::setLanguage(int language) {
    const QStringList known = languages();
    if (language < 0 || language >= known.size())
        return;
    relabel([tag = known[language].toStdString()](RecordingLabel& label) { label.language = tag; });
}

void RecordingList::addFiles(const QList<QUrl>& sounds, int kind) {
    if (!photo_.is_open())
        return;
    RecordingLabel label;
    label.kind =
        static_cast<RecordingKind>(std::clamp(kind, 0, static_cast<int>(CareWords::kinds().size()) - 1));
    for (const QUrl& sound : sounds) {
        if (!sound.isLocalFile()) {
            teller_.problem(tr("Only a sound that is a file on this computer can be added."));
            continue;
        }
        const fs::path file = path_named(sound.toLocalFile().toStdString());
        const PhotoPlace place = photo_.place();
        const auto added = std::make_shared<AlbumKeeper::Added>();
        photo_.change(
            place,
            [file, label, added](AlbumKeeper& keeper, const fs::path& photo) {
                auto done = keeper.add_recording(photo, file, label);
                if (done)
                    *added = *done;
                return done.error();
            },
            [this, place, added](const QString& problem) {
                if (!problem.isEmpty()) {
                    teller_.problem(problem);
                    return;
                }
                choose_file(place, added->tag.file);
                teller_.did(Earcon::saved, tr("Added: %1, %2. %3")
                                               .arg(CareWords::recording(added->tag.label),
                                                    CareWords::recording_details(added->tag),
                                                    in_persons_language(added->warning))
                                               .trimmed());
            });
    }
}

} // namespace tp
