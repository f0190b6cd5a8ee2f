// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/browse_session.hpp"

#include "audio/sentences/sentences.hpp"
#include "core/files/file_words.hpp"

#include <QFile>
#include <QLocale>
#include <QRandomGenerator>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr double slowest = 0.5, fastest = 2.0, speed_step = 0.25;

QString name_of_path(const fs::path& path) {
    return QFile::decodeName(QByteArray::fromStdString(path.string()));
}
fs::path path_named(const QString& name) { return QFile::encodeName(name).toStdString(); }

} // namespace

BrowseSession::BrowseSession(OpenAlbum& album, Narrator& narrator, EarconPlayer& earcons, Player& player,
                             Preferences& preferences, QSize screen)
    : album_(album), narrator_(narrator), earcons_(earcons), preferences_(preferences),
      playback_(player, narrator, preferences), pictures_(screen) {
    levels_.push_back(
        {View::Photos, tr("All photographs"), PhotoTrail(album_.index(), AllByTime{}), {}, {}, -1});
    connect(&album_, &OpenAlbum::album_changed, this, &BrowseSession::look_at_album);
    connect(&album_, &OpenAlbum::folders_changed, this, &BrowseSession::look_at_album);
    connect(&album_, &OpenAlbum::scanning_changed, this, [this] {
        if (!begun_)
            look_at_album();
        set_state();
        emit scanChanged();
    });
    connect(&album_, &OpenAlbum::progress_changed, this, &BrowseSession::scanChanged);
    connect(&playback_, &TagPlayback::changed, this, [this] {
        emit playbackChanged();
        emit progressChanged();
    });
    connect(&playback_, &TagPlayback::progress, this, &BrowseSession::progressChanged);
    connect(&playback_, &TagPlayback::ended, this, [this] { earcons_.play(Earcon::list_end); });
    connect(&player, &Player::said, this, &BrowseSession::set_notice);
    connect(&pictures_, &PictureAhead::ready, this,
            [this](const std::shared_ptr<const ShownPicture>& picture) {
                if (picture->photo != shown_)
                    return;
                picture_ = picture->image;
                picture_problem_ = in_persons_language(picture->problem);
                emit pictureChanged();
            });
    connect(&preferences_, &Preferences::changed, this, &BrowseSession::speedChanged);
    look_at_album();
}

BrowseSession::~BrowseSession() = default;

// --- where one is ---

const PhotoTrail& BrowseSession::trail() const {
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level)
        if (level->trail)
            return *level->trail;
    return *levels_.front().trail; // the first always has one
}

PhotoTrail& BrowseSession::trail() { return const_cast<PhotoTrail&>(std::as_const(*this).trail()); }

bool BrowseSession::checked(const Result<bool>& moved) {
    if (!moved)
        refuse(in_persons_language(moved.error()));
    return moved && *moved;
}

/// Something in the album is otherwise than it was: stays with the photograph that is shown, or goes on from
/// there.
void BrowseSession::look_at_album() {
    if (!begun_ || !trail().here()) {
        begin();
        return;
    }
    const QString before = QString::fromStdString(readable(shown_.filename().string()));
    bool lost = false;
    for (Level& one : levels_)
        if (one.trail) {
            const Result<bool> same =
                one.trail->look_again(&*one.trail == &trail() ? sha256_ : std::string());
            if (!same)
                return refuse(in_persons_language(same.error()));
            lost = &*one.trail == &trail() ? !*same : lost;
        }
    bool level_gone = false;
    while (levels_.size() > 1 && level().view == View::Photos &&
           !level().trail->here()) { // nobody is left in it
        levels_.pop_back();
        level_gone = true;
    }
    if (level_gone)
        emit levelChanged();
    if (view() != View::Photos)
        list_rows();
    show_here();
    if (lost && active_ && state_ == State::Ready)
        narrator_.tell(tr("%1 is gone from this list. Now: %2").arg(before, summary_), Priority::message);
}

/// Goes to where one was when the program ended, as soon as the index knows it.
void BrowseSession::begin() {
    AlbumQueries queries = album_.queries();
    PhotoTrail& all = *levels_.front().trail;
    std::optional<PhotoEntry> at;
    if (const QString last = preferences_.choices().last_photo; !last.isEmpty())
        if (auto found = queries.find(path_named(last)); found && *found)
            at = std::move(**found);
    const Result<bool> there = at ? all.to(*at) : all.to_first();
    if (!there)
        return refuse(in_persons_language(there.error()));
    // while the first scan goes on, where one was may still come
    begun_ = all.here() && (at || preferences_.choices().last_photo.isEmpty() || !album_.scanning());
    show_here();
}

void BrowseSession::show_here(bool backwards) {
    const std::optional<PhotoEntry>& photo = trail().here();
    const bool another = !photo || photo->path != shown_;
    if (!photo) {
        forget_photo();
    } else {
        shown_ = photo->path;
        read_record();
        if (another) {
            detail_ = -1;
            notice_.clear();
            picture_ = {};
            picture_problem_.clear();
            pictures_.show(shown_, trail().ahead(backwards));
            if (begun_ && preferences_.choices().last_photo != name_of_path(shown_))
                preferences_.change([this](Choices& choices) { choices.last_photo = name_of_path(shown_); });
            emit pictureChanged();
            emit noticeChanged();
        } else {
            detail_ = std::min(detail_, static_cast<int>(details_.size()) - 1);
            pictures_.show(shown_, trail().ahead(backwards)); // its bytes may be others now
        }
    }
    set_state();
    emit photoChanged();
    emit detailChanged();
}

void BrowseSession::forget_photo() {
    shown_.clear();
    sha256_.clear();
    record_ = {};
    summary_.clear();
    details_.clear();
    detail_ = -1;
    picture_ = {};
    picture_problem_.clear();
    playback_.set_tags({}, {});
    emit pictureChanged();
}

void BrowseSession::read_record() {
    const auto known = album_.queries().summary(trail().here()->id);
    record_ = known && *known ? (*known)->record : PhotoRecord{};
    sha256_ = known && *known ? (*known)->sha256 : std::string();
    const PhotoWords words;
    summary_ = words.summary(shown_, record_);
    details_ = words.details(shown_, record_);
    playback_.set_tags(shown_, in_playing_order(record_.tags));
}

void BrowseSession::set_state() {
    const State now = trail().here()          ? State::Ready
                      : !album_.has_folders() ? State::NoFolders
                      : album_.scanning()     ? State::Looking
                                              : State::Empty;
    const State before = std::exchange(state_, now);
    if (before == now)
        return;
    emit stateChanged();
    if (!active_)
        return;
    if (now == State::Ready)
        tell_here(Priority::message);
    else
        narrator_.tell(emptyText(), Priority::message);
}

QString BrowseSession::emptyText() const {
    switch (state_) {
    case State::NoFolders:
        return tr(
            "There is no album yet. Choose the folders of your photographs on the settings page, or import "
            "photographs.");
    case State::Looking:
        return tr("Looking for photographs in your folders.");
    case State::Empty:
        return tr("There is no photograph in your folders yet. Import some, or choose other folders on the "
                  "settings page.");
    case State::Ready:
        break;
    }
    return {};
}

QString BrowseSession::scanText() const {
    if (!album_.scanning())
        return {};
    if (album_.total() == 0)
        return tr("Looking for what is new in your folders");
    const QString done = tr("Reading new photographs, %1 of %2").arg(album_.done()).arg(album_.total());
    if (album_.seconds_left() < 0)
        return done;
    return tr("%1, about %2 left", "progress, and a time")
        .arg(done, PhotoWords().duration(album_.seconds_left()));
}

double BrowseSession::scanValue() const {
    return album_.total() == 0 ? -1.0 : static_cast<double>(album_.done()) / album_.total();
}

QString BrowseSession::photo() const { return name_of_path(shown_); }

QString BrowseSession::placeText() const {
    return position() == 0 ? QString() : tr("%1 of %2", "a place in a list").arg(position()).arg(count());
}

// --- the page ---

void BrowseSession::enter() {
    levels_.front().title = tr("All photographs"); // the language may be another one now
    if (trail().here())
        show_here();
    else
        look_at_album();
    if (view() != View::Photos)
        list_rows();
    emit levelChanged();
    active_ = true;
    if (state_ != State::Ready) {
        narrator_.tell(emptyText(), Priority::message);
    } else if (view() != View::Photos) {
        tell_list();
    } else if (narrator_.by() == Narrator::By::screen_reader) {
        narrator_.tell(tr("Your photographs."), Priority::message); // the photograph has the focus, and is read by itself
    } else {
        const QString can =
            hasRecordings() ? tr("Swipe or use the arrow keys to go on; double tap or press Return to hear.")
                            : tr("Swipe or use the arrow keys to go on.");
        narrator_.tell(tr("Your photographs, %1: %2 %3", "place, summary, what can be done")
                           .arg(placeText(), summary_, can),
                       Priority::message);
    }
}

void BrowseSession::leave() {
    active_ = false;
    playback_.stop();
    narrator_.stop();
}

void BrowseSession::refuse(const QString& sentence) {
    earcons_.play(Earcon::error);
    narrator_.tell(sentence, Priority::touch);
}

// --- from photograph to photograph ---

void BrowseSession::step(bool forward) {
    if (state_ != State::Ready)
        return refuse(emptyText());
    if (view() != View::Photos)
        return;
    begun_ = true;
    const Result<bool> moved = forward ? trail().next() : trail().previous();
    if (!moved)
        return refuse(in_persons_language(moved.error()));
    playback_.stop();
    if (!*moved) {
        earcons_.play(Earcon::list_end);
        narrator_.tell(forward ? tr("This is the last photograph.") : tr("This is the first photograph."),
                       Priority::touch);
        return;
    }
    earcons_.play(forward ? Earcon::next : Earcon::previous);
    show_here(!forward);
    tell_here(Priority::touch);
}

void BrowseSession::next() { step(true); }
void BrowseSession::previous() { step(false); }

void BrowseSession::jump(const Result<bool>& moved) {
    if (!moved)
        return refuse(in_persons_language(moved.error()));
    begun_ = true;
    playback_.stop();
    earcons_.play(Earcon::next);
    show_here();
    tell_here(Priority::touch);
}

void BrowseSession::first() {
    if (view() == View::Photos && state_ == State::Ready)
        jump(trail().to_first());
}

void BrowseSession::last() {
    if (view() == View::Photos && state_ == State::Ready)
        jump(trail().to_last());
}

void BrowseSession::surprise() {
    if (state_ != State::Ready)
        return refuse(emptyText());
    constexpr int attempts = 8; // another one than this
    std::optional<PhotoEntry> other;
    for (int i = 0; i < attempts && (!other || other->path == shown_); ++i) {
        auto any = album_.queries().surprise(QRandomGenerator::global()->generate64());
        if (!any)
            return refuse(in_persons_language(any.error()));
        other = std::move(*any);
    }
    levels_.resize(1);
    emit levelChanged();
    if (other)
        jump(trail().to(*other));
}

bool BrowseSession::show(const QString& photo) {
    const auto found = album_.queries().find(path_named(photo));
    if (!found || !*found)
        return false;
    levels_.resize(1);
    begun_ = true;
    if (!checked(trail().to(**found)))
        return false;
    playback_.stop();
    emit levelChanged();
    show_here();
    if (active_)
        tell_here(Priority::touch);
    return true;
}

void BrowseSession::tell_here(Priority priority) {
    if (trail().here())
        narrator_.tell(summary_, priority);
}

// --- details ---

QString BrowseSession::detail() const {
    return detail_ < 0 || detail_ >= static_cast<int>(details_.size())
               ? summary_
               : details_[static_cast<std::size_t>(detail_)].text;
}

std::optional<std::size_t> BrowseSession::chosen_recording() const {
    return detail_ < 0 ? std::nullopt : details_[static_cast<std::size_t>(detail_)].recording;
}

void BrowseSession::step_detail(int by) {
    if (state_ != State::Ready)
        return refuse(emptyText());
    if (view() != View::Photos)
        return;
    const int wanted = detail_ + by;
    if (wanted < -1 || wanted >= static_cast<int>(details_.size()))
        earcons_.play(Earcon::list_end);
    detail_ = std::clamp(wanted, -1, static_cast<int>(details_.size()) - 1);
    emit detailChanged();
    tellDetail();
}

void BrowseSession::tellDetail() {
    if (state_ != State::Ready)
        return narrator_.tell(emptyText(), Priority::touch);
    playback_.pause(); // a recording is not talked over, and who asks wants an answer
    narrator_.tell(detail(), Priority::touch);
}

void BrowseSession::tap() {
    if (!playback_.playing())
        tellDetail();
}

void BrowseSession::twoFingerTap() {
    tap_stopped_ = playback_.playing();
    stop();
}

void BrowseSession::twoFingerDoubleTap() {
    if (!std::exchange(tap_stopped_, false))
        play();
}

void BrowseSession::whereAmI() {
    playback_.pause();
    if (state_ != State::Ready)
        return narrator_.tell(emptyText(), Priority::touch);
    if (view() != View::Photos)
        return tell_list();
    const QString where = tr("%1, %2: %3", "list, place in it, summary").arg(title(), placeText(), summary_);
    if (const auto now = playback_.current(); now && *now < playback_.tags().size())
        narrator_.tell(tr("%1 Paused: %2, at %3.", "where one is; the recording and the time in it")
                           .arg(where, PhotoWords().recording(playback_.tags()[*now]),
                                PhotoWords().duration(playback_.position_s())),
                       Priority::touch);
    else
        narrator_.tell(where, Priority::touch);
}

// --- recordings ---

void BrowseSession::play() {
    if (state_ != State::Ready)
        return refuse(emptyText());
    if (view() != View::Photos)
        return;
    set_notice({});
    if (!playback_.toggle(chosen_recording()))
        refuse(tr("This photograph has no recordings yet."));
}

bool BrowseSession::stop() {
    const bool spoke = narrator_.speaking();
    const bool sounded = playback_.stop();
    narrator_.stop();
    return spoke || sounded;
}

QString BrowseSession::heard() const {
    const std::optional<std::size_t> now = playback_.current();
    if (!now || *now >= playback_.tags().size())
        return {};
    return tr("%1, %2 of %3", "a recording, and times in it")
        .arg(PhotoWords().recording(playback_.tags()[*now]), PhotoWords::clock(playback_.position_s()),
             PhotoWords::clock(playback_.duration_s()));
}

double BrowseSession::heardValue() const {
    const double all = playback_.duration_s();
    return all > 0.0 ? std::clamp(playback_.position_s() / all, 0.0, 1.0) : 0.0;
}

QString BrowseSession::speedText() const {
    return tr("Speed %1", "of recordings").arg(QLocale().toString(speed(), 'g', 3));
}

void BrowseSession::change_speed(int by) {
    const double wanted = std::round(speed() / speed_step + by) * speed_step;
    if (wanted < slowest || wanted > fastest)
        earcons_.play(Earcon::list_end);
    preferences_.change(
        [&](Choices& choices) { choices.playback_speed = std::clamp(wanted, slowest, fastest); });
    if (!playback_.playing()) // there it is heard
        narrator_.tell(speedText(), Priority::touch);
}

void BrowseSession::set_notice(const QString& notice) {
    if (notice == notice_)
        return;
    notice_ = notice;
    emit noticeChanged();
}

// --- other pages ---

QString BrowseSession::keys() const {
    return tr(
        "Left and right: previous and next photograph. Up and down: what is known of it. Return: hear the "
        "recordings, or pause. Escape: stop. Plus and minus: faster and slower. Home and End: first and last "
        "photograph. S: search. P: people. Y: years. L: places. K: keywords. R: surprise me. A: all "
        "photographs. Backspace: back. E: feel the face. C: look after this photograph. W: where am I. H: "
        "these "
        "keys. A swipe goes the way of its arrow key, a double tap plays, two fingers stop, a Z of two "
        "fingers "
        "goes back, three fingers tell where you are.");
}

void BrowseSession::tellKeys() {
    playback_.pause();
    narrator_.tell(keys(), Priority::touch);
}

void BrowseSession::askExplore() {
    if (state_ != State::Ready)
        return refuse(emptyText());
    emit exploreAsked(photo());
}

void BrowseSession::askCare() {
    if (state_ != State::Ready)
        return refuse(emptyText());
    emit careAsked(photo());
}

} // namespace tp
