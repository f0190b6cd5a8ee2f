// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_session.hpp"

#include "audio/sentences/sentences.hpp"

#include <stop_token>
#include <utility>

namespace tp {

MendSession::MendSession(Narrator& narrator)
    : narrator_(narrator), view_(photo_), selection_(photo_, view_, narrator),
      history_(photo_, selection_, narrator), drag_(photo_, view_, selection_, history_, narrator),
      editing_(photo_, view_, selection_, history_, drag_, narrator), preview_(photo_, narrator),
      file_(photo_, selection_, history_, narrator) {
    connect(&selection_, &MendSelection::nothingInHand, this, &MendSession::enter);
}

void MendSession::open(const QUrl& file) {
    if (file.isLocalFile())
        open_file(file.toLocalFile());
    else
        tell(tr("Only a photograph that is a file on this computer can be opened."));
}

void MendSession::open_file(const QString& file) {
    if (!file_.save())
        return;
    photo_.look();
    tell(tr("Looking for faces…"));
    loader_.ask([this, file](const std::stop_token& stop) -> LatestTask::Answer {
        auto photo = std::make_shared<MendPhoto>(read_for_mending(file, extractor_, stop));
        return [this, photo] { show(std::move(*photo)); };
    });
}

void MendSession::show(MendPhoto photo) {
    // Of a photograph that was shown while another was not saved.
    if (const QString refused = file_.write(); !refused.isEmpty())
        return tell(refused);
    photo_.show(std::move(photo));
    selection_.fitIntoView();
    enter();
}

void MendSession::enter() {
    switch (photo_.state()) {
    case MendedPhoto::State::Empty:
        return tell(tr("This page mends the contours of a photograph. There is no photograph yet."));
    case MendedPhoto::State::Looking:
        return tell(tr("Looking for faces…"));
    case MendedPhoto::State::Problem:
        return tell(tr("%1: %2", "a photograph and what is wrong with it")
                        .arg(photo_.name(), in_persons_language(photo_.problem())));
    case MendedPhoto::State::Ready:
        break;
    }
    if (photo_.work().faces.empty())
        return tell(tr("No face was found in %1. You can add one of the usual shape and move it into place.")
                        .arg(photo_.name()));
    tell(tr("Contours of %1. Selected: %2. Tab goes from point to point, the arrow keys move it.")
             .arg(photo_.name(), selection_.featureName()));
}

void MendSession::leave() {
    drag_.cancel();
    if (photo_.state() == MendedPhoto::State::Looking)
        loader_.cancel();
    photo_.look_away();
    file_.save();
}

} // namespace tp
