// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/browse_playback.hpp"

#include "app/pages/browse/photo_words.hpp"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tp {

namespace {
constexpr double slowest = 0.5, fastest = 2.0, speed_step = 0.25;
}

BrowsePlayback::BrowsePlayback(BrowseTrail& trail, BrowseDetails& details, BrowseTeller& teller,
                               TagPlayback& tags, Player& player, Preferences& preferences)
    : trail_(trail), details_(details), teller_(teller), tags_(tags), preferences_(preferences) {
    connect(&tags_, &TagPlayback::changed, this, [this] {
        emit changed();
        emit progressed();
    });
    connect(&tags_, &TagPlayback::progress, this, &BrowsePlayback::progressed);
    connect(&tags_, &TagPlayback::ended, this, [this] { teller_.sound(Earcon::list_end); });
    connect(&player, &Player::said, this, &BrowsePlayback::set_notice);
    connect(&preferences_, &Preferences::changed, this, &BrowsePlayback::speedChanged);
    connect(&trail_, &BrowseTrail::shown_anew, this, [this](bool another) {
        if (another)
            set_notice({});
    });
}

void BrowsePlayback::play() {
    if (!trail_.ready_or_refuse() || trail_.view() != BrowseTrail::View::Photos)
        return;
    set_notice({});
    if (!tags_.toggle(details_.chosen_recording()))
        teller_.refuse(tr("This photograph has no recordings yet."));
}

const Tag* BrowsePlayback::current() const {
    const std::optional<std::size_t> now = tags_.current();
    return now && *now < tags_.tags().size() ? &tags_.tags()[*now] : nullptr;
}

QString BrowsePlayback::heard() const {
    const Tag* tag = current();
    if (tag == nullptr)
        return {};
    return tr("%1, %2 of %3", "a recording, and times in it")
        .arg(PhotoWords().recording(*tag), PhotoWords::clock(tags_.position_s()),
             PhotoWords::clock(tags_.duration_s()));
}

std::optional<BrowsePlayback::Place> BrowsePlayback::place() const {
    const Tag* tag = current();
    if (tag == nullptr)
        return std::nullopt;
    return Place{PhotoWords().recording(*tag), PhotoWords().duration(tags_.position_s())};
}

double BrowsePlayback::heardValue() const {
    const double all = tags_.duration_s();
    return all > 0.0 ? std::clamp(tags_.position_s() / all, 0.0, 1.0) : 0.0;
}

QString BrowsePlayback::speedText() const {
    return tr("Speed %1", "of recordings")
        .arg(QLocale().toString(preferences_.choices().playback_speed, 'g', 3));
}

void BrowsePlayback::change_speed(int by) {
    const double wanted = std::round(preferences_.choices().playback_speed / speed_step + by) * speed_step;
    if (wanted < slowest || wanted > fastest)
        teller_.sound(Earcon::list_end);
    preferences_.change(
        [&](Choices& choices) { choices.playback_speed = std::clamp(wanted, slowest, fastest); });
    if (!tags_.playing()) // there it is heard
        teller_.tell(speedText());
}

void BrowsePlayback::set_notice(const QString& notice) {
    if (notice == notice_)
        return;
    notice_ = notice;
    emit noticeChanged();
}

} // namespace tp
