// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_touch.hpp"

#include "audio/sentences/sentences.hpp"

#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr double pulse_s = 0.025; ///< a motor that starts slowly makes it longer

TouchAccess without_drawn(TouchAccess access) {
    if (access.list)
        access.list = [all = std::move(access.list)] {
            std::vector<ListedTouchOutput> real = all();
            std::erase_if(real, [](const ListedTouchOutput& one) { return one.name == drawn_touch_name; });
            return real;
        };
    return access;
}

} // namespace

CaptureTouch::CaptureTouch(CaptureChoices& choices, CaptureTeller& teller, TouchAccess access)
    : choices_(choices), teller_(teller), connector_(without_drawn(std::move(access))) {
    connect(&choices_, &CaptureChoices::changed, this, [this] {
        if ((in_use() || connector_.opening()) && choices_.touch() != key_)
            give_back();
        follow_wish();
    });
    connect(&connector_, &TouchConnector::looked, this, &CaptureTouch::look);
    connect(&connector_, &TouchConnector::opened, this,
            [this](const std::shared_ptr<OpenTouch>& open) { use(*open); });
    connect(&connector_, &TouchConnector::refused, this, &CaptureTouch::refuse);
}

CaptureTouch::~CaptureTouch() { give_back(); }

void CaptureTouch::enter() {
    here_ = true;
    follow_wish();
}

void CaptureTouch::leave() {
    here_ = false;
    follow_wish();
}

/// Whether one is wanted may be otherwise now.
void CaptureTouch::follow_wish() {
    const bool wanted = here_ && choices_.ticks();
    if (wanted && state_ == State::Away)
        want();
    else if (!wanted && state_ != State::Away)
        give_back();
}

void CaptureTouch::want() {
    refused_.clear();
    was_lost_ = false;
    state_ = State::Expected;
    connector_.watch(true);
}

void CaptureTouch::give_back() {
    connector_.watch(false);
    connector_.cancel();
    state_ = State::Away;
    if (!output_)
        return;
    still();
    connector_.release(std::move(output_));
}

/// Opens the one that the person wants.
void CaptureTouch::look() {
    if ((state_ != State::Expected && state_ != State::Awaited) || connector_.opening())
        return;
    const ListedTouchOutput* output = touch_for(connector_.there(), choices_.touch());
    if (output != nullptr && output->name != refused_) {
        asked_ = output->name;
        key_ = choices_.touch();
        return connector_.open(*output);
    }
    if (output == nullptr && std::exchange(state_, State::Awaited) == State::Expected &&
        !std::exchange(none_told_, true))
        teller_.tell(tr("There is no motor here that could tick. The tone and words lead you."));
}

void CaptureTouch::use(OpenTouch& open) {
    output_ = std::move(open.output);
    about_ = in_persons_language(open.listed.about);
    state_ = State::InUse;
    pulsed_ = false;
    connector_.watch(false);
    if (std::exchange(was_lost_, false))
        teller_.tell(tr("Ticks again: %1.").arg(about_));
}

void CaptureTouch::refuse(const QString& sentence) {
    state_ = State::Awaited;
    refused_ = asked_;
    teller_.problem(tr("%1 Until then the tone and words lead you.").arg(sentence));
}

void CaptureTouch::watch() {
    if (!in_use())
        return;
    output_->read(clock_.now()); // a pad is told by being read that it is used, and found to be gone
    if (output_->lost())
        lose();
}

/// It was unplugged; the tone goes on, and it is used again when it comes back.
void CaptureTouch::lose() {
    give_back();
    state_ = State::Awaited;
    was_lost_ = true;
    connector_.watch(true);
    teller_.problem(
        tr("No more ticks from %1: until it is there again the tone and words lead you.").arg(about_));
}

void CaptureTouch::pulse(double strength) {
    if (!in_use())
        return;
    const TickChoices how = choices_.tick_choices();
    output_->tick({strength * how.strength, how.sharpness, pulse_s});
    pulsed_ = true;
}

void CaptureTouch::still() {
    if (std::exchange(pulsed_, false))
        output_->halt();
}

} // namespace tp
