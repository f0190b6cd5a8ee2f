// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/tag_playback.hpp"

#include "app/album/keeper/photo_files.hpp"
#include "app/pages/browse/photo_words.hpp"

#include <utility>

namespace tp {

TagPlayback::TagPlayback(Player& player, Narrator& narrator, Preferences& preferences, QObject* parent)
    : QObject(parent), player_(player), narrator_(narrator), preferences_(preferences) {
    connect(&player_, &Player::state_changed, this, &TagPlayback::changed);
    connect(&player_, &Player::began, this, &TagPlayback::changed);
    connect(&player_, &Player::position_changed, this, &TagPlayback::progress);
    connect(&player_, &Player::sounding_changed, this,
            [this](bool sounding) { narrator_.set_recording_plays(sounding); });
    connect(&player_, &Player::gap, this, &TagPlayback::tell_next);
    connect(&player_, &Player::said, this,
            [this](const QString& sentence) { narrator_.tell(sentence, Priority::message); });
    connect(&player_, &Player::left, this, [this](std::size_t index, double position_s) {
        if (index < player_.list().size())
            left_[player_.list()[index].file] = position_s;
    });
    connect(&player_, &Player::list_end, this, &TagPlayback::ended);
    connect(&preferences_, &Preferences::changed, this, &TagPlayback::follow_speed);
    follow_speed();
}

TagPlayback::~TagPlayback() {
    disconnect(&player_, nullptr, this, nullptr);
    stop();
    narrator_.set_recording_plays(false);
}

void TagPlayback::follow_speed() { player_.set_speed(preferences_.choices().playback_speed); }

void TagPlayback::set_tags(const std::filesystem::path& photo, std::vector<Tag> tags) {
    if (photo == photo_ && tags == tags_)
        return;
    stop();
    photo_ = photo;
    tags_ = std::move(tags);
    player_.set_list({});
    emit changed();
}

bool TagPlayback::playing() const {
    return telling_ || player_.state() == Player::State::playing || player_.state() == Player::State::waiting;
}

std::optional<std::size_t> TagPlayback::current() const {
    if (!playing() && !paused())
        return std::nullopt;
    return only_ ? only_ : player_.current();
}

double TagPlayback::duration_s() const {
    const std::optional<std::size_t> now = current();
    if (player_.duration_s() > 0.0 || !now || *now >= tags_.size())
        return player_.duration_s();
    return tags_[*now].duration_s;
}

bool TagPlayback::toggle(std::optional<std::size_t> only) {
    if (tags_.empty() || (only && *only >= tags_.size()))
        return false;
    const bool this_one = only ? current() == only : !only_;
    if (playing() && (!only || this_one))
        pause();
    else if (paused() && this_one)
        player_.play();
    else
        start(only);
    return true;
}

void TagPlayback::start(std::optional<std::size_t> only) {
    stop();
    only_ = only;
    std::vector<PlayItem> items;
    for (std::size_t i = 0; i < tags_.size(); ++i)
        if (!only || *only == i) {
            const std::filesystem::path file = tags_folder(photo_) / tags_[i].file;
            const auto left = left_.find(file);
            items.push_back(
                {file, tags_[i].label.kind, {}, tags_[i].gain_db, left == left_.end() ? 0.0 : left->second});
        }
    narrator_.stop();
    player_.set_list(std::move(items));
    player_.play();
}

void TagPlayback::pause() {
    if (std::exchange(telling_, false)) {
        narrator_.stop();
        emit changed();
    }
    player_.pause();
}

bool TagPlayback::stop() {
    const bool was = playing() || paused();
    if (std::exchange(telling_, false))
        narrator_.stop();
    player_.stop();
    return was;
}

void TagPlayback::tell_next(std::size_t next) {
    if (only_ || next >= tags_.size())
        return;
    telling_ = true;
    player_.pause();
    narrator_.tell_then(tr("Next: %1.").arg(PhotoWords().recording(tags_[next])), [this] {
        if (std::exchange(telling_, false))
            player_.play();
    });
}

} // namespace tp
