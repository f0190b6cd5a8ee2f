// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/recording_list.hpp"

#include "app/pages/care/care_words.hpp"
#include "audio/sentences/sentences.hpp"

#include <QFile>
#include <QLocale>
#include <QVariantMap>

#include <algorithm>
#include <climits>
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

/// BCP 47; the system's and those of recordings are added.
const QStringList common_languages{"", "en", "de", "ko", "fr", "es", "tr", "ar"};

} // namespace

RecordingList::RecordingList(CaredPhoto& photo, CareTeller& teller) : photo_(photo), teller_(teller) {
    connect(&photo_, &CaredPhoto::opened, this, [this] {
        file_.clear();
        list();
    });
    connect(&photo_, &CaredPhoto::changed, this, &RecordingList::list);
}

/// The chosen one stays the chosen one where it is still there; else the one that came to its place is.
void RecordingList::list() {
    tags_ = as_played(photo_.record().tags);
    const auto same = std::find_if(tags_.begin(), tags_.end(), [&](const Tag& tag) { return tag.file == file_; });
    const std::string before = file_;
    int chosen = same != tags_.end() ? static_cast<int>(same - tags_.begin()) : std::min(chosen_, count() - 1);
    if (chosen < 0 && count() > 0)
        chosen = 0;
    chosen_ = chosen;
    if (same == tags_.end() && chosen_ >= 0)
        file_ = tags_[static_cast<std::size_t>(chosen_)].file;
    emit changed();
    if (file_ != before || chosen_ < 0)
        emit chosenChanged();
}

void RecordingList::become(int chosen) {
    chosen_ = chosen;
    file_ = chosen_ < 0 ? std::string{} : tags_[static_cast<std::size_t>(chosen_)].file;
    emit changed();
    emit chosenChanged();
}

void RecordingList::choose_file(const std::string& file) {
    file_ = file;
    list();
    emit chosenChanged();
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
    return chosen_ < 0 ? -1
                       : static_cast<int>(languages().indexOf(QString::fromStdString(chosen_tag()->label.language)));
}

void RecordingList::choose(int recording) {
    if (recording < 0 || recording >= count())
        return;
    become(recording);
    teller_.answer(tr("%1, %2, %3 of %4")
                       .arg(words_of(recording), CareWords::recording_details(*chosen_tag()))
                       .arg(recording + 1)
                       .arg(count()));
}

void RecordingList::move(int by) {
    const int to = chosen_ + by;
    if (chosen_ < 0 || to < 0 || to >= count()) {
        teller_.problem(by < 0 ? tr("This is the first one.") : tr("This is the last one."));
        return;
    }
    std::vector<std::string> files;
    for (const Tag& tag : tags_)
        files.push_back(tag.file);
    std::swap(files[static_cast<std::size_t>(chosen_)], files[static_cast<std::size_t>(to)]);
    photo_.change(
        photo_.place(), [files](AlbumKeeper& keeper, const fs::path& photo) { return keeper.order_recordings(photo, files); },
        [this, to](const QString& problem) {
            if (problem.isEmpty())
                teller_.did(Earcon::saved,
                            tr("%1 is now number %2 of %3.").arg(chosenText()).arg(to + 1).arg(count()));
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
        [file = file_](AlbumKeeper& keeper, const fs::path& photo) { return keeper.delete_recording(photo, file); },
        [this, what](const QString& problem) {
            if (problem.isEmpty())
                teller_.did(Earcon::deleted, tr("Deleted: %1. Undo brings it back.").arg(what));
            else
                teller_.problem(problem);
        });
}

void RecordingList::relabel(const RecordingLabel& label) {
    if (chosen_ < 0 || label == chosen_tag()->label)
        return;
    photo_.change(
        photo_.place(),
        [file = file_, label](AlbumKeeper& keeper, const fs::path& photo) {
            return keeper.label_recording(photo, file, label);
        },
        [this, label](const QString& problem) {
            if (problem.isEmpty())
                teller_.did(Earcon::saved, tr("Saved: %1.").arg(CareWords::recording(label)));
            else
                teller_.problem(problem);
        });
}

void RecordingList::setKind(int kind) {
    if (chosen_ < 0 || kind < 0 || kind >= CareWords::kinds().size())
        return;
    RecordingLabel label = chosen_tag()->label;
    label.kind = static_cast<RecordingKind>(kind);
    relabel(label);
}

void RecordingList::setPerson(const QString& name) {
    if (chosen_ < 0)
        return;
    RecordingLabel label = chosen_tag()->label;
    label.person = name.simplified().toStdString();
    relabel(label);
}

void RecordingList::setSpeaker(const QString& name) {
    if (chosen_ < 0)
        return;
    RecordingLabel label = chosen_tag()->label;
    label.speaker = name.simplified().toStdString();
    relabel(label);
}

void RecordingList::setLanguage(int language) {
    const QStringList known = languages();
    if (chosen_ < 0 || language < 0 || language >= known.size())
        return;
    RecordingLabel label = chosen_tag()->label;
    label.language = known[language].toStdString();
    relabel(label);
}

void RecordingList::addFiles(const QList<QUrl>& sounds, int kind) {
    if (!photo_.is_open())
        return;
    RecordingLabel label;
    label.kind = static_cast<RecordingKind>(std::clamp(kind, 0, static_cast<int>(CareWords::kinds().size()) - 1));
    for (const QUrl& sound : sounds) {
        if (!sound.isLocalFile()) {
            teller_.problem(tr("Only a sound that is a file on this computer can be added."));
            continue;
        }
        const fs::path file = QFile::encodeName(sound.toLocalFile()).toStdString();
        const auto added = std::make_shared<AlbumKeeper::Added>();
        photo_.change(
            photo_.place(),
            [file, label, added](AlbumKeeper& keeper, const fs::path& photo) {
                auto done = keeper.add_recording(photo, file, label);
                if (done)
                    *added = *done;
                return done.error();
            },
            [this, added](const QString& problem) {
                if (!problem.isEmpty()) {
                    teller_.problem(problem);
                    return;
                }
                choose_file(added->tag.file);
                teller_.did(Earcon::saved,
                            tr("Added: %1, %2. %3")
                                .arg(CareWords::recording(added->tag.label), CareWords::recording_details(added->tag),
                                     in_persons_language(added->warning))
                                .trimmed());
            });
    }
}

} // namespace tp
