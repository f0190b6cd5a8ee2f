// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/browse_details.hpp"

#include "audio/sentences/sentences.hpp"

#include <algorithm>
#include <memory>

namespace tp {

BrowseDetails::BrowseDetails(BrowseAlbum& album, BrowseTrail& trail, BrowseTeller& teller, TagPlayback& tags,
                             QSize screen)
    : album_(album), trail_(trail), teller_(teller), tags_(tags), pictures_(screen) {
    connect(&trail_, &BrowseTrail::shown_anew, this, &BrowseDetails::take);
    connect(&trail_, &BrowseTrail::arrived, this,
            [this](Priority priority) { teller_.tell(summary_, priority); });
    connect(&trail_, &BrowseTrail::seen_now, this, &BrowseDetails::tell_seen);
    connect(&trail_, &BrowseTrail::lost, this, [this](const QString& name) {
        teller_.tell(tr("%1 is no longer in this list. Now: %2").arg(name, summary_), Priority::message);
    });
    connect(&pictures_, &PictureAhead::ready, this,
            [this](const std::shared_ptr<const ShownPicture>& picture) {
                if (picture->photo != trail_.shown())
                    return;
                picture_ = picture->image;
                picture_problem_ = in_persons_language(picture->problem);
                emit pictureChanged();
            });
}

void BrowseDetails::take(bool another, bool backwards) {
    const bool there = trail_.here().has_value();
    const PhotoWords words = trail_.words();
    const QString was_at = another || detail_ < 0 ? QString() : detail();
    summary_ = there ? words.summary(trail_.shown(), trail_.record(), trail_.seen()) : QString();
    details_ =
        there ? words.details(trail_.shown(), trail_.record(), trail_.seen()) : std::vector<PhotoDetail>();
    tags_.set_tags(trail_.shown(), in_playing_order(trail_.record().tags));
    detail_ = another ? -1 : std::min(detail_, static_cast<int>(details_.size()) - 1);
    if (!was_at.isEmpty()) // more may be known now that comes before it
        if (const auto same = std::find_if(details_.begin(), details_.end(),
                                           [&](const PhotoDetail& one) { return one.text == was_at; });
            same != details_.end())
            detail_ = static_cast<int>(same - details_.begin());
    if (another) {
        picture_ = {};
        picture_problem_.clear();
    }
    if (there)
        pictures_.show(trail_.shown(),
                       trail_.ahead(backwards)); // of the same one: its bytes may be others now
    if (another)
        emit pictureChanged();
    emit changed();
}

QString BrowseDetails::detail() const {
    return detail_ < 0 || detail_ >= static_cast<int>(details_.size())
               ? summary_
               : details_[static_cast<std::size_t>(detail_)].text;
}

std::optional<std::size_t> BrowseDetails::chosen_recording() const {
    return detail_ < 0 ? std::nullopt : details_[static_cast<std::size_t>(detail_)].recording;
}

void BrowseDetails::step(int by) {
    if (!trail_.ready_or_refuse() || trail_.view() != BrowseTrail::View::Photos)
        return;
    const int wanted = detail_ + by;
    const int last = static_cast<int>(details_.size()) - 1;
    if (wanted < -1 || wanted > last)
        teller_.sound(Earcon::list_end);
    detail_ = std::clamp(wanted, -1, last);
    emit changed();
    tell();
}

void BrowseDetails::tell() {
    if (!trail_.ready())
        return teller_.tell(album_.emptyText());
    tags_.pause(); // a recording is not talked over, and who asks wants an answer
    teller_.tell(detail());
}

/// To whoever waits at a photograph of which nothing more was known: what is seen, once. A screen reader reads the
/// summary, which is its name.
void BrowseDetails::tell_seen() {
    if (detail_ >= 0 || tags_.playing() || teller_.narrator().by() == Narrator::By::screen_reader)
        return;
    if (const QString seen = trail_.words().seen(trail_.record(), trail_.seen()); !seen.isEmpty())
        teller_.tell(seen, Priority::message);
}

void BrowseDetails::tap() {
    if (!tags_.playing())
        tell();
}

} // namespace tp
