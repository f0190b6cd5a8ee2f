// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_touch.hpp"

#include "app/pages/explore/feature_labels.hpp"
#include "audio/sentences/sentences.hpp"

#include <algorithm>
#include <utility>

namespace tp {

ExploreTouch::ExploreTouch(FingerServo& servo, ExploreView& view, ExploreTour& tour, ExploreEar& ear,
                           ExploreChoices& choices, ExploreWords& words, ExploreDevice& device,
                           const ExploreSettings& settings)
    : servo_(servo), view_(view), tour_(tour), ear_(ear), choices_(choices), words_(words), device_(device),
      surface_(settings.surface.width_mm, settings.surface.height_mm), connector_(settings.touch) {
    connect(&view_, &ExploreView::fresh, this, &ExploreTouch::look);
    connect(&choices_, &ExploreChoices::changed, this, &ExploreTouch::follow_choices);
    connect(&device_, &ExploreDevice::in_use_changed, this, &ExploreTouch::follow_wish);
    connect(&device_, &ExploreDevice::engage_asked, this, [this] {
        refused_.clear(); // where one was refused, it is asked again
        look();
    });
    connect(&connector_, &TouchConnector::looked, this, &ExploreTouch::look);
    connect(&connector_, &TouchConnector::opened, this,
            [this](const std::shared_ptr<OpenTouch>& open) { use(*open); });
    connect(&connector_, &TouchConnector::refused, this, &ExploreTouch::refuse);
}

void ExploreTouch::enter() {
    here_ = true;
    follow_wish();
}

void ExploreTouch::leave() {
    here_ = false;
    follow_wish();
}

/// Whether one is wanted may be otherwise now.
void ExploreTouch::follow_wish() {
    const bool wanted = here_ && choices_.ticks() && !device_.in_use();
    if (wanted && state_ == State::Away)
        want();
    else if (!wanted && state_ != State::Away)
        give_back();
}

void ExploreTouch::want() {
    refused_.clear();
    gone_.clear();
    state_ = State::Expected;
    connector_.watch(true);
}

void ExploreTouch::give_back() {
    connector_.watch(false);
    connector_.cancel();
    gone_.clear();
    if (std::exchange(state_, State::Away) != State::InUse)
        return;
    const bool on = servo_.engaged();
    if (tour_.touring())
        tour_.end();
    connector_.release(servo_.feel_by(nullptr));
    view_.reach({});
    ear_.lift();
    if (on)
        servo_.engage();
    emit changed();
}

/// Opens the one that the person wants as soon as there is something to feel.
void ExploreTouch::look() {
    if (!view_.ready() || state_ == State::Away || connector_.opening() || !connector_.knows())
        return;
    const std::vector<ListedTouchOutput>& there = connector_.there();
    if (std::none_of(there.begin(), there.end(), [this](const auto& one) { return one.name == refused_; }))
        refused_.clear(); // unplugged since; plugged in again it is asked again
    const ListedTouchOutput* output = touch_for(there, choices_.touch());
    if (state_ == State::InUse && (output == nullptr || output->name == used_.name))
        return;
    if (output != nullptr && output->name != refused_)
        return connector_.open(*output);
    if (!gone_.isEmpty())
        return tell_gone();
    if (output == nullptr && std::exchange(state_, State::Awaited) == State::Expected)
        words_.tell(tr("There is nothing here that ticks under a finger. Beeps and words guide."),
                    Priority::message);
}

void ExploreTouch::use(OpenTouch& open) {
    const bool on = servo_.engaged();
    if (tour_.touring())
        tour_.end_told();
    if (state_ == State::InUse)
        connector_.release(servo_.feel_by(nullptr));
    const bool in_place_of_another = !gone_.isEmpty() && open.listed.name != used_.name;
    about_ = in_persons_language(open.listed.about);
    key_ = choices_.touch();
    used_ = open.listed;
    connector_.watch(used_.name == drawn_touch_name); // which only stands in for another
    auto drive = std::make_unique<TouchDrive>(std::move(open.output), open.can, surface_,
                                              choices_.touch_settings(used_));
    view_.reach(drive->reach());
    connector_.release(servo_.feel_by(std::move(drive)));
    state_ = State::InUse;
    ear_.lift();
    if (on)
        servo_.engage();
    emit changed();
    if (in_place_of_another)
        return tell_gone();
    gone_.clear();
    words_.tell(on ? tr("Ticks: %1.").arg(about_)
                   : tr("Ticks: %1. They are off. Press Enter to switch them on.").arg(about_),
                Priority::message);
}

void ExploreTouch::refuse(const QString& sentence) {
    if (state_ != State::InUse)
        state_ = State::Awaited;
    if (const ListedTouchOutput* output = touch_for(connector_.there(), choices_.touch()))
        refused_ = output->name;
    if (!gone_.isEmpty())
        return tell_gone();
    words_.tell(Earcon::fault, tr("%1 Until then beeps and words guide.").arg(sentence), Priority::fault);
}

void ExploreTouch::watch() {
    if (state_ == State::InUse && servo_.touch()->loop().snapshot().lost)
        lose();
}

/// It was unplugged; sound goes on, and it is used again when it comes back. What ticks meanwhile is told with it, once that is
/// known.
void ExploreTouch::lose() {
    const QString gone = about_;
    give_back();
    gone_ = gone;
    state_ = State::Awaited;
    connector_.watch(true);
}

void ExploreTouch::tell_gone() {
    const QString gone = at_the_start(std::exchange(gone_, {}));
    words_.tell(Earcon::fault,
                state_ == State::InUse
                    ? tr("%1 is gone. Until it is there again, ticks come from: %2.").arg(gone, about_)
                    : tr("%1 is gone. Beeps and words guide until it is there again.").arg(gone),
                Priority::fault);
}

void ExploreTouch::follow_choices() {
    follow_wish();
    if (state_ != State::InUse)
        return;
    const TouchSettings chosen = choices_.touch_settings(used_);
    servo_.touch()->loop().choose(chosen.choices);
    servo_.touch()->loop().set_latency(chosen.latency_s);
    if (choices_.touch() == key_)
        return;
    give_back();
    want();
}

} // namespace tp
