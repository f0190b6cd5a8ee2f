// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/listening.hpp"

#include <utility>

namespace tp {

Listening::Listening(Player& player, CareTeller& teller) : player_(player), teller_(teller) {
    connect(&player_, &Player::position_changed, this, [this] {
        if (!playing_)
            return;
        emit moved();
        if (player_.position_s() >= to_s_)
            stop();
    });
    connect(&player_, &Player::list_end, this, [this] {
        if (playing_)
            end();
    });
    connect(&player_, &Player::said, this, [this](const QString& sentence) {
        if (playing_)
            teller_.tell(sentence);
    });
}

void Listening::play(const std::filesystem::path& file, const Tag& tag, double from_s, double to_s) {
    teller_.silence();
    to_s_ = to_s;
    const bool was_playing = std::exchange(playing_, true);
    player_.set_list({{file, tag.label.kind, std::nullopt, tag.gain_db, from_s}});
    player_.play_at(0);
    if (playing_ != was_playing)
        emit changed();
    emit moved();
}

void Listening::stop() {
    if (!playing_)
        return;
    end();
    player_.stop();
}

void Listening::end() {
    playing_ = false;
    emit changed();
    emit moved();
}

} // namespace tp
