// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/care_session.hpp"

#include "app/album/index/album_queries.hpp"
#include "app/pages/care/care_words.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QStandardPaths>
#include <QUrl>

#include <system_error>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {
constexpr std::size_t most_people = 12; ///< suggested at a time
} // namespace

CareSession::CareSession(OpenAlbum& album, Narrator& narrator, EarconPlayer& earcons, Recorder& recorder,
                         Player& player, Preferences& preferences)
    : album_(album), preferences_(preferences), teller_(narrator, earcons), chooser_(narrator), photo_(steps_),
      photos_(album, finder_, thumbnails_, [this] { return language(); }), import_(album, preferences, teller_),
      faces_(photo_, finder_, teller_, [this](const QString& typed) { return people(typed); }),
      recordings_(photo_, teller_), listening_(player, teller_),
      take_(photo_, recordings_, recorder, teller_, [this] { return language(); }),
      trimming_(photo_, recordings_, listening_, teller_),
      descriptions_(photo_, teller_, [this] { return language(); }) {
    connect(&photo_, &CaredPhoto::opened, this, &CareSession::photoChanged);
    connect(&photo_, &CaredPhoto::name_languages_read, this, &CareSession::nameLanguagesRead);
    connect(&photo_, &CaredPhoto::touched, &album_, &OpenAlbum::touched);
    connect(&photos_, &PhotoRows::modelReset, this, &CareSession::photoChanged);
    connect(&photos_, &PhotoRows::rowsMoved, this, &CareSession::photoChanged);
    connect(&steps_, &KeeperSteps::changed, this, &CareSession::stepsChanged);
    connect(&album_, &OpenAlbum::folders_changed, this, &CareSession::albumChanged);
    connect(&import_, &ImportCare::folderWanted, this, [this] { choose(Choosing::album); });
    connect(&chooser_, &FolderChooser::chosen, this, &CareSession::folder_chosen);
    connect(&chooser_, &FolderChooser::cancelled, this, [this] {
        import_.dropWish();
        choose(Choosing::nothing);
        teller_.answer(tr("No folder was chosen."));
    });
    connect(&take_, &Take::begins, &listening_, &Listening::stop);
    const auto go_on = [this] {
        if (!take_.running())
            for (const auto& each : std::exchange(when_recorded_, {}))
                each();
    };
    connect(&take_, &Take::changed, this, go_on, Qt::QueuedConnection); // the take has asked for its own step by then
}

CareSession::~CareSession() { leave(); }

/// What the person chose, else the system's.
QString CareSession::language() const {
    const QString& chosen = preferences_.choices().language;
    const QString own = chosen.isEmpty() ? QLocale().bcp47Name() : chosen;
    return own.isEmpty() || QLocale(own) == QLocale::c() ? QString("en") : own;
}

QString CareSession::photoName() const {
    return photo_.is_open() ? CareWords::file_name(photo_.place().photo) : QString();
}

void CareSession::enter() {
    import_.look();
    photos_.refresh();
    photo_.read_again();
    if (!hasFolders())
        teller_.tell(tr("Care for the album. It has no folder yet. Import photographs, and choose where they are kept."));
    else if (photoOpen())
        teller_.tell(tr("Care for the album. %1 is open: its faces, recordings and description.").arg(photoName()));
    else
        teller_.tell(tr("Care for the album. %1 Choose one, or import more.")
                         .arg(tr("%n photograph(s).", nullptr, photos_.total())));
}

void CareSession::leave() {
    stop();
    descriptions_.save();
    finder_.judge({}); // whoever comes back asks again
    teller_.silence();
}

void CareSession::importFolder() { choose(Choosing::source); }

void CareSession::choose(Choosing what) {
    choosing_ = what;
    emit choosingChanged();
    if (choosing())
        chooser_.begin();
}

void CareSession::folder_chosen(const QString& folder) {
    const Choosing what = choosing_;
    choose(Choosing::nothing);
    if (what == Choosing::source)
        import_.import({QUrl::fromLocalFile(folder)});
    else
        import_.chooseFolder(QUrl::fromLocalFile(folder));
}

bool CareSession::stop() {
    if (choosing()) {
        chooser_.cancel();
        return true;
    }
    const bool sounding = listening_.playing();
    const bool recording = take_.running();
    listening_.stop();
    take_.finish();
    return sounding || recording;
}

void CareSession::openRow(int row) {
    if (const fs::path photo = photos_.photo(row); !photo.empty())
        open_photo(photo);
}

void CareSession::open_photo(const fs::path& photo) {
    stop();
    photo_.open({photo, &album_.keeper_for(photo)});
    teller_.answer(photoName());
}

void CareSession::closePhoto() {
    stop();
    photo_.close();
}

void CareSession::deletePhoto() {
    if (!photo_.is_open())
        return;
    const PhotoPlace place = photo_.place();
    closePhoto(); // so that nothing more is begun with it
    when_recorded([this, place] {
        photo_.change(
            place, [](AlbumKeeper& keeper, const fs::path& photo) { return keeper.delete_photo(photo); },
            [this, place](const QString& problem) {
                if (!problem.isEmpty()) {
                    teller_.problem(problem);
                    if (!photo_.is_open())
                        photo_.open(place);
                    return;
                }
                gone_ = place.photo;
                teller_.did(Earcon::deleted,
                            tr("Deleted: %1. Undo brings it back.").arg(CareWords::file_name(place.photo)));
            });
    });
}

void CareSession::when_recorded(std::function<void()> then) {
    stop();
    if (take_.running())
        when_recorded_.push_back(std::move(then));
    else
        then();
}

bool CareSession::refused_while_recording() {
    if (take_.running())
        teller_.problem(tr("A recording is being made. Finish it first."));
    return take_.running();
}

void CareSession::step_taken_back(bool back, const QString& what, const QString& problem) {
    if (!problem.isEmpty()) {
        teller_.problem(problem);
        return;
    }
    std::error_code error;
    const bool open_is_gone = photo_.is_open() && !fs::exists(photo_.place().photo, error);
    if (open_is_gone) {
        gone_ = photo_.place().photo;
        photo_.close();
    } else if (!gone_.empty() && fs::exists(gone_, error)) {
        const fs::path photo = gone_;
        gone_.clear();
        album_.touched(photo);
        photo_.open({photo, &album_.keeper_for(photo)});
    } else {
        photo_.read_again();
    }
    if (!gone_.empty())
        album_.touched(gone_);
    if (photo_.is_open())
        album_.touched(photo_.place().photo);
    teller_.did(Earcon::undone, back ? tr("Undone: %1.").arg(what) : tr("Redone: %1.").arg(what));
}

void CareSession::undo() {
    if (refused_while_recording())
        return;
    steps_.undo([this](const QString& problem) { step_taken_back(true, steps_.next_redo(), problem); });
}

void CareSession::redo() {
    if (refused_while_recording())
        return;
    steps_.redo([this](const QString& problem) { step_taken_back(false, steps_.next_undo(), problem); });
}

void CareSession::mend() {
    if (photo_.is_open())
        emit mendAsked(QFile::decodeName(photo_.place().photo.c_str()));
}

void CareSession::print() {
    if (photo_.is_open())
        emit printAsked(QFile::decodeName(photo_.place().photo.c_str()));
}

QStringList CareSession::people(const QString& typed) const {
    AlbumQueries queries = album_.queries();
    QStringList names;
    if (typed.trimmed().isEmpty()) {
        if (const auto topics = queries.topics("person", {}, most_people))
            for (const TopicEntry& topic : *topics)
                names << QString::fromStdString(topic.name);
    } else if (const auto topics = queries.suggestions(typed.toStdString(), 3 * most_people)) {
        for (const TopicEntry& topic : *topics)
            if (topic.kind == "person" && names.size() < static_cast<qsizetype>(most_people))
                names << QString::fromStdString(topic.name);
    }
    return names;
}

QUrl CareSession::picturesFolder() const {
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QUrl::fromLocalFile(QFileInfo(pictures).isDir() ? pictures : QDir::homePath());
}

} // namespace tp
