// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_walk.hpp"

#include <utility>

namespace tp {

namespace {

constexpr int told_after = 10; ///< photographs without a face, one looks into in some seconds

bool has_a_name(const LoadedPhoto& photo) {
    for (const QString& name : photo.names)
        if (!name.isEmpty())
            return true;
    return false;
}

} // namespace

ExploreWalk::ExploreWalk(const ExploreSettings& settings, ExploreView& view, ExploreWords& words)
    : beside_(settings.beside), view_(view), words_(words) {
    connect(&view_, &ExploreView::looked_into, this, &ExploreWalk::judge);
}

QString ExploreWalk::beside(const QString& file) const {
    return beside_ ? beside_(file, way_ == Way::forward) : QString();
}

void ExploreWalk::newest() { set_out(Way::newest); }

void ExploreWalk::album_changed() {
    if (waiting_ && view_.state() == ExploreView::State::Empty)
        newest();
}

void ExploreWalk::set_out(Way way) {
    if (view_.looking_into() && way == way_)
        return; // it is on its way there
    if (view_.looking_into())
        view_.turn_back();
    way_ = way;
    passed_.clear();
    const QString open = way == Way::newest ? QString() : view_.file();
    const QString first = beside(open);
    waiting_ = first.isEmpty() && view_.state() == ExploreView::State::Empty;
    if (waiting_)
        return void(words_.tell(view_.where_one_is(), Priority::touch));
    if (first.isEmpty())
        return end_of_album();
    emit setting_out();
    look_into(first);
}

void ExploreWalk::look_into(const QString& file) {
    at_ = file;
    view_.look_into(file);
}

void ExploreWalk::judge(const std::shared_ptr<const LoadedPhoto>& photo) {
    if (view_.can_be_felt(*photo)) {
        QStringList before;
        if (way_ == Way::newest)
            before << tr("Your newest photograph with a face.");
        else if (!passed_.isEmpty())
            before << tr("Skipped %n photograph(s) without a face.", nullptr, passed());
        if (!has_a_name(*photo))
            before << tr("%1.", "a photograph's name").arg(photo->name);
        return view_.show(photo, before.join(' '));
    }
    passed_.insert(at_);
    if (const QString further = beside(at_); !further.isEmpty() && !passed_.contains(further)) {
        if (passed() % told_after == 0)
            words_.tell(tr("Still looking: %n photograph(s) without a face so far.", nullptr, passed()),
                        Priority::message);
        return look_into(further);
    }
    view_.turn_back();
    end_of_album();
}

void ExploreWalk::end_of_album() {
    const bool any = view_.state() != ExploreView::State::Empty;
    words_.tell(Earcon::list_end,
                !any                   ? tr("There is no face on any photograph in the album.")
                : way_ == Way::forward ? tr("No photograph with a face comes after this one.")
                                       : tr("No photograph with a face comes before this one."),
                Priority::touch);
}

} // namespace tp
