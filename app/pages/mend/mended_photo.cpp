// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mended_photo.hpp"

#include <QFileInfo>

#include <utility>

namespace tp {

QString MendedPhoto::name() const { return QFileInfo(photo_.file).fileName(); }

void MendedPhoto::become(State state) {
    state_ = state;
    emit stateChanged();
}

void MendedPhoto::look() { become(State::Looking); }

void MendedPhoto::look_away() {
    if (state_ == State::Looking)
        become(photo_.usable ? State::Ready : State::Empty);
}

void MendedPhoto::show(MendPhoto photo) {
    photo_ = std::move(photo);
    state_ = photo_.usable ? State::Ready : State::Problem;
    emit replaced();
    emit changed();
    emit stateChanged(); // once every part has taken it in
}

void MendedPhoto::change(const std::function<void(MendWork&)>& change) {
    change(photo_.work);
    emit changed();
}

} // namespace tp
