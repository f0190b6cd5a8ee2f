// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/player.hpp"

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr double between_s = 0.7;       ///< silence between two recordings
constexpr double to_the_one_before = 3; ///< seconds after which "previous" means the beginning of this one
constexpr double almost_heard_s = 2.0;  ///< a recording left so shortly before its end begins anew next time

} // namespace

Player::Player(SoundOutput& output, StreamFiller& filler, QObject* parent)
    : QObject(parent), output_(output), filler_(filler) {
    connect(&filler_, &StreamFiller::ready, this, &Player::ready);
    connect(&filler_, &StreamFiller::unreadable, this, &Player::unreadable);
    connect(&output_, &SoundOutput::progress, this, &Player::progress);
    connect(&output_, &SoundOutput::drained, this, [this](quint64 run) {
        if (run == run_)
            end_current();
    });
    connect(&output_, &SoundOutput::gone, this, &Player::gone);
    connect(&output_, &SoundOutput::moved, this, &Player::moved);
    connect(&output_, &SoundOutput::came, this, &Player::came);
}

void Player::set_list(std::vector<PlayItem> list) {
    stop();
    list_ = std::move(list);
    current_ = 0;
    position_s_ = list_.empty() ? 0.0 : list_.front().resume_at_s;
    duration_s_ = 0.0;
}

double Player::position_s() const { return ready_ ? stream_->position_s() : position_s_; }

double Player::duration_s() const { return duration_s_; }

void Player::play() {
    if (list_.empty())
        emit list_end();
    else if (state_ != State::playing)
        begin(current_, position_s(), 0.0);
}

void Player::play_at(std::size_t index) {
    if (index >= list_.size())
        return;
    leave_current();
    begin(index, list_[index].resume_at_s, 0.0);
}

void Player::pause() {
    if (state_ != State::playing && state_ != State::waiting)
        return;
    leave_current();
    become(State::paused, false);
}

void Player::stop() {
    if (state_ == State::stopped)
        return;
    leave_current();
    become(State::stopped, false);
}

void Player::next() {
    if (current_ + 1 < list_.size())
        play_at(current_ + 1);
    else
        emit list_end();
}

void Player::previous() {
    if (list_.empty()) {
        emit list_end();
        return;
    }
    const bool to_beginning = position_s() > to_the_one_before;
    const std::size_t index = to_beginning || current_ == 0 ? current_ : current_ - 1;
    const bool nothing_before = !to_beginning && current_ == 0;
    leave_current();
    begin(index, 0.0, 0.0);
    if (nothing_before)
        emit list_end();
}

void Player::set_speed(double speed) {
    speed = std::clamp(speed, slowest_playing, fastest_playing);
    if (std::exchange(speed_, speed) != speed && state_ == State::playing)
        begin(current_, position_s(), begun_ ? 0.0 : silence_s_);
}

void Player::begin(std::size_t index, double position_s, double silence_s) {
    fall_silent();
    if (index != current_)
        duration_s_ = 0.0;
    current_ = index;
    position_s_ = position_s;
    silence_s_ = silence_s;
    stream_ = std::make_shared<PlaybackStream>(
        PlaybackStream::What{list_[index].file, position_s, speed_, list_[index].gain_db, silence_s});
    become(State::playing, false);
    filler_.begin(run_, stream_);
}

/// Of what was playing nothing is heard any more, and nothing that is still on its way counts.
void Player::fall_silent() {
    position_s_ = position_s();
    ++run_;
    ready_ = false;
    if (stream_ == nullptr)
        return;
    stream_.reset();
    output_.stop();
    filler_.leave();
}

void Player::leave_current() {
    if (list_.empty())
        return;
    const bool was_on = state_ != State::stopped;
    fall_silent();
    const bool almost_heard = duration_s_ > almost_heard_s && position_s_ > duration_s_ - almost_heard_s;
    list_[current_].resume_at_s = almost_heard ? 0.0 : position_s_;
    if (was_on)
        emit left(current_, list_[current_].resume_at_s);
}

void Player::end_current() {
    const std::size_t ended_one = current_;
    fall_silent();
    list_[ended_one].resume_at_s = 0.0;
    const bool more = ended_one + 1 < list_.size();
    if (more) {
        begin(ended_one + 1, list_[ended_one + 1].resume_at_s, between_s);
    } else {
        position_s_ = 0.0;
        become(State::stopped, false);
    }
    emit left(ended_one, 0.0);
    emit ended(ended_one);
    if (more)
        emit gap(ended_one + 1);
    else
        emit list_end();
}

void Player::become(State state, bool begun) {
    const bool was_sounding = sounding();
    const State before = std::exchange(state_, state);
    begun_ = begun;
    if (before != state)
        emit state_changed();
    if (was_sounding != sounding())
        emit sounding_changed(sounding());
}

void Player::ready(quint64 run) {
    if (run != run_)
        return;
    ready_ = true;
    duration_s_ = stream_->duration_s();
    output_.start(run, stream_);
}

void Player::progress(quint64 run) {
    if (run != run_)
        return;
    if (!begun_ && stream_->begun()) {
        told_ = false;
        become(State::playing, true);
        emit began(current_);
    }
    emit position_changed();
}

void Player::unreadable(quint64 run, const QString& sentence) {
    if (run != run_)
        return;
    fall_silent();
    if (current_ + 1 < list_.size()) {
        begin(current_ + 1, list_[current_ + 1].resume_at_s, between_s);
        emit said(sentence);
        return;
    }
    position_s_ = 0.0;
    become(State::stopped, false);
    emit said(sentence);
    emit list_end();
}

void Player::gone(quint64 run) {
    if (run != run_)
        return;
    const bool had_begun = begun_;
    fall_silent();
    become(State::waiting, false);
    if (std::exchange(told_, true))
        return;
    emit said(had_begun ? tr("The loudspeaker is gone. The recording goes on as soon as there is one again.")
                        : tr("There is no loudspeaker. The recording plays as soon as there is one."));
}

void Player::moved(quint64 run) {
    if (run == run_)
        begin(current_, position_s(), begun_ ? 0.0 : silence_s_);
}

void Player::came() {
    if (state_ == State::waiting)
        begin(current_, position_s_, 0.0);
}

} // namespace tp
