// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/care_session.hpp"

#include "app/pages/care/care_words.hpp"
#include "app/pages/care/described_in.hpp"
#include "core/files/file_name.hpp"

namespace tp {
namespace fs = std::filesystem;

CareSession::CareSession(OpenAlbum& album, AlbumFaces& groups, Narrator& narrator, EarconPlayer& earcons,
                         Recorder& recorder, Player& player, Preferences& preferences)
    : album_(album), teller_(narrator, earcons), photo_(steps_),
      photos_(album, finder_, thumbnails_, [&preferences] { return own_language(preferences); }),
      import_(album, preferences, teller_), folders_(album, import_, narrator, teller_), people_(album),
      faces_(photo_, finder_, groups, teller_, [this](const QString& typed) { return people_.known(typed); }),
      groups_(album, groups, steps_, teller_, [this](const QString& typed) { return people_.known(typed); }),
      recordings_(photo_, teller_), listening_(player, teller_),
      take_(photo_, recordings_, recorder, teller_, [&preferences] { return own_language(preferences); }),
      trimming_(photo_, recordings_, listening_, teller_),
      descriptions_(photo_, teller_, [&preferences] { return own_language(preferences); }),
      draft_(album, photo_, descriptions_, teller_, [&preferences] { return own_language(preferences); }),
      recording_(take_, listening_, teller_), history_(steps_, photo_, album, recording_, teller_) {
    connect(&photo_, &CaredPhoto::opened, this, &CareSession::photoChanged);
    connect(&photo_, &CaredPhoto::name_languages_read, this, &CareSession::nameLanguagesRead);
    connect(&photo_, &CaredPhoto::unread, this, &CareSession::tellProblem);
    connect(&photo_, &CaredPhoto::touched, &album_, &OpenAlbum::touched);
    connect(&groups_, &GroupCare::photoAsked, this, &CareSession::open_photo);
    connect(&photos_, &PhotoRows::modelReset, this, &CareSession::photoChanged);
    connect(&photos_, &PhotoRows::rowsMoved, this, &CareSession::photoChanged);
    connect(&take_, &Take::changed, this, &CareSession::keepingChanged);
    connect(&steps_, &KeeperSteps::changed, this, &CareSession::keepingChanged);
}

CareSession::~CareSession() { leave(); }

QString CareSession::photoName() const {
    return photo_.is_open() ? CareWords::file_name(photo_.place().photo) : QString();
}

void CareSession::enter() {
    import_.look();
    photos_.refresh();
    photo_.read_again();
    if (!folders_.hasFolders())
        teller_.tell(tr("Look after the album. It has no folder yet. Import photographs, and choose where to "
                        "keep them."));
    else if (photoOpen())
        teller_.tell(
            tr("Look after the album. %1 is open: its faces, recordings and description.").arg(photoName()));
    else
        teller_.tell(tr("Look after the album. %1 Choose one, or import more.")
                         .arg(tr("%n photograph(s).", nullptr, photos_.total())));
}

void CareSession::leave() {
    stop();
    recording_.stop(); // where a folder was being chosen meanwhile
    descriptions_.save();
    finder_.judge({}); // whoever comes back asks again
    groups_.hide();
    teller_.silence();
}

bool CareSession::stop() {
    if (!folders_.choosing())
        return recording_.stop() || groups_.back();
    folders_.chooser()->cancel();
    return true;
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
    history_.delete_photo(place);
}

void CareSession::mend() {
    if (photo_.is_open())
        emit mendAsked(QString::fromStdString(name_in_utf8(photo_.place().photo)));
}

void CareSession::print() {
    if (photo_.is_open())
        emit printAsked(QString::fromStdString(name_in_utf8(photo_.place().photo)));
}

} // namespace tp
