// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_preview.hpp"

#include <stop_token>
#include <utility>

namespace tp {

MendPreview::MendPreview(const MendedPhoto& photo, Narrator& narrator) : photo_(photo), narrator_(narrator) {
    connect(&photo, &MendedPhoto::replaced, this, &MendPreview::begin_anew);
    connect(&photo, &MendedPhoto::changed, this, &MendPreview::follow);
}

void MendPreview::begin_anew() {
    work_.cancel();
    state_ = State::Current;
    felt_ = {};
    emit changed();
}

void MendPreview::follow() {
    if (!photo_.ready())
        return;
    if (work_.busy()) { // the contours as they are by its end are next
        state_ = State::Outdated;
        return;
    }
    state_ = State::Asked;
    work_.ask([this, work = photo_.work()](const std::stop_token&) -> LatestTask::Answer {
        return [this, felt = felt_change(found_faces(work), faces_of(work))] { take(felt); };
    });
}

void MendPreview::take(const FeltChange& felt) {
    felt_ = felt;
    const State was = std::exchange(state_, State::Current);
    emit changed();
    if (was == State::Outdated)
        follow();
}

void MendPreview::setForceShown(bool shown) {
    if (shown == shown_)
        return;
    shown_ = shown;
    emit shownChanged();
    narrator_.tell(shown ? tr("The force is shown.") : tr("The force is hidden."), Priority::touch);
}

} // namespace tp
