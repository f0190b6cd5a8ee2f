// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/browse_trail.hpp"

#include "audio/sentences/sentences.hpp"
#include "core/files/file_name.hpp"
#include "core/files/file_words.hpp"

#include <QRandomGenerator>

#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

QString name_of_path(const fs::path& path) { return QString::fromStdString(name_in_utf8(path)); }
fs::path path_in(const QString& name) { return path_named(name.toStdString()); }

} // namespace

BrowseTrail::BrowseTrail(BrowseAlbum& album, BrowseTeller& teller, TagPlayback& tags,
                         Preferences& preferences)
    : album_(album), teller_(teller), tags_(tags), preferences_(preferences) {
    levels_.push_back(
        {View::Photos, tr("All photographs"), PhotoTrail(album_.open().index(), AllByTime{}), {}, {}, -1});
    connect(&album_.open(), &OpenAlbum::album_changed, this, &BrowseTrail::look_at_album);
    connect(&album_.open(), &OpenAlbum::folders_changed, this, &BrowseTrail::look_at_album);
    connect(&album_.open(), &OpenAlbum::scanning_changed, this, [this] {
        if (!begun_)
            look_at_album();
        set_state();
    });
}

// --- where one is ---

const PhotoTrail& BrowseTrail::trail() const {
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level)
        if (level->trail)
            return *level->trail;
    return *levels_.front().trail; // the first always has one
}

PhotoTrail& BrowseTrail::trail() { return const_cast<PhotoTrail&>(std::as_const(*this).trail()); }

QString BrowseTrail::photo() const { return name_of_path(shown_); }

QString BrowseTrail::placeText() const {
    return position() == 0 ? QString() : tr("%1 of %2", "a place in a list").arg(position()).arg(count());
}

bool BrowseTrail::ready_or_refuse() {
    if (!ready())
        teller_.refuse(album_.emptyText());
    return ready();
}

/// Something in the album is otherwise than it was: stays with the photograph that is shown, or goes on from
/// there.
void BrowseTrail::look_at_album() {
    if (!begun_ || !here()) {
        begin();
        return;
    }
    const QString before = QString::fromStdString(readable(shown_.filename().string()));
    bool gone = false;
    for (Level& one : levels_)
        if (one.trail) {
            const bool shows = &*one.trail == &trail();
            const Result<bool> same = one.trail->look_again(shows ? sha256_ : std::string());
            if (!same)
                return teller_.refuse(in_persons_language(same.error()));
            gone = shows ? !*same : gone;
        }
    bool level_gone = false;
    while (levels_.size() > 1 && view() == View::Photos && !level().trail->here()) { // nobody is left in it
        levels_.pop_back();
        level_gone = true;
    }
    if (level_gone)
        emit levelChanged();
    emit album_changed();
    show_here();
    if (gone && active_ && ready())
        emit lost(before);
}

/// Goes to where one was when the program ended, as soon as the index knows it.
void BrowseTrail::begin() {
    AlbumQueries queries = album_.open().queries();
    PhotoTrail& all = *levels_.front().trail;
    std::optional<PhotoEntry> at;
    if (const QString last = preferences_.choices().last_photo; !last.isEmpty())
        if (auto found = queries.find(path_in(last)); found && *found)
            at = std::move(**found);
    const Result<bool> there = at ? all.to(*at) : all.to_first();
    if (!there)
        return teller_.refuse(in_persons_language(there.error()));
    // while the first scan goes on, where one was may still come
    begun_ = all.here() && (at || preferences_.choices().last_photo.isEmpty() || !album_.scanning());
    show_here();
}

void BrowseTrail::enter() {
    levels_.front().title = tr("All photographs");
    const QString last = preferences_.choices().last_photo; // another page may have gone on from here
    if (here() && (!begun_ || last == photo() || !show(last)))
        show_here();
    else if (!here())
        look_at_album();
    active_ = true;
}

// --- what is shown ---

void BrowseTrail::show_here(bool backwards) {
    const bool another = !here() || here()->path != shown_;
    read_record();
    if (here() && another && begun_ && preferences_.choices().last_photo != photo())
        preferences_.change([this](Choices& choices) { choices.last_photo = photo(); });
    emit shown_anew(another, backwards);
    set_state();
    emit photoChanged();
}

void BrowseTrail::read_record() {
    shown_ = here() ? here()->path : fs::path();
    record_ = {};
    seen_.reset();
    sha256_.clear();
    if (!here())
        return;
    if (const auto known = album_.open().queries().summary(here()->id); known && *known) {
        record_ = (*known)->record;
        seen_ = (*known)->seen;
        sha256_ = (*known)->sha256;
    }
}

PhotoWords BrowseTrail::words() const {
    const Choices& choices = preferences_.choices();
    return PhotoWords(PhotoWords::Style{choices.descriptions, choices.place_first});
}

void BrowseTrail::looked_at(const fs::path& photo) {
    if (photo != shown_ || !here())
        return;
    const auto known = [this] {
        return seen_ && seen_->width > 0;
    }; // a look that goes on is kept without a size
    const bool news = !known();
    show_here();
    if (news && known() && active_ && view() == View::Photos)
        emit seen_now();
}

void BrowseTrail::set_state() {
    if (!album_.look(here().has_value()) || !active_)
        return;
    if (ready())
        emit arrived(Priority::message);
    else
        teller_.tell(album_.emptyText(), Priority::message);
}

// --- from photograph to photograph ---

void BrowseTrail::step(bool forward) {
    if (!ready_or_refuse() || view() != View::Photos)
        return;
    begun_ = true;
    const Result<bool> moved = forward ? trail().next() : trail().previous();
    if (!moved)
        return teller_.refuse(in_persons_language(moved.error()));
    tags_.stop();
    if (!*moved)
        return teller_.tell(Earcon::list_end, forward ? tr("This is the last photograph.")
                                                      : tr("This is the first photograph."));
    teller_.sound(forward ? Earcon::next : Earcon::previous);
    show_here(!forward);
    emit arrived(Priority::touch);
}

void BrowseTrail::jump(const Result<bool>& moved) {
    if (!moved)
        return teller_.refuse(in_persons_language(moved.error()));
    begun_ = true;
    tags_.stop();
    teller_.sound(Earcon::next);
    show_here();
    emit arrived(Priority::touch);
}

void BrowseTrail::first() {
    if (view() == View::Photos && ready())
        jump(trail().to_first());
}

void BrowseTrail::last() {
    if (view() == View::Photos && ready())
        jump(trail().to_last());
}

void BrowseTrail::surprise() {
    if (!ready_or_refuse())
        return;
    constexpr int attempts = 8; // another one than this
    std::optional<PhotoEntry> other;
    for (int i = 0; i < attempts && (!other || other->path == shown_); ++i) {
        auto any = album_.open().queries().surprise(QRandomGenerator::global()->generate64());
        if (!any)
            return teller_.refuse(in_persons_language(any.error()));
        other = std::move(*any);
    }
    to_the_top();
    emit levelChanged();
    if (other)
        jump(trail().to(*other));
}

bool BrowseTrail::go_to(const PhotoEntry& photo) {
    const Result<bool> moved = trail().to(photo);
    if (!moved)
        teller_.refuse(in_persons_language(moved.error()));
    return moved && *moved;
}

bool BrowseTrail::show(const QString& photo) {
    const auto found = album_.open().queries().find(path_in(photo));
    if (!found || !*found)
        return false;
    to_the_top();
    begun_ = true;
    if (!go_to(**found))
        return false;
    tags_.stop();
    emit levelChanged();
    show_here();
    if (active_)
        emit arrived(Priority::touch);
    return true;
}

} // namespace tp
