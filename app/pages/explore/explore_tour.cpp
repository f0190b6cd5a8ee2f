// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_tour.hpp"

#include "app/pages/explore/face_tour.hpp"
#include "app/pages/explore/feature_labels.hpp"

namespace tp {

namespace {
constexpr double grab_mm = 5.0;  ///< a hand that moves farther during a tour wants to lead itself
constexpr double breath_s = 0.3; ///< between a feature's name and its tour
} // namespace

ExploreTour::ExploreTour(FingerServo& servo, ExploreView& view, ExploreFinger& finger, ExploreWords& words,
                         const PageClock& now)
    : servo_(servo), view_(view), finger_(finger), words_(words), now_(now) {
    connect(&view_, &ExploreView::replacing, this, [this] {
        if (touring())
            end();
    });
}

/// Whether there can be a tour; where not, says why.
bool ExploreTour::may_begin() {
    if (!view_.ready())
        words_.tell(view_.where_one_is(), Priority::touch);
    else if (!servo_.engaged())
        words_.tell(servo_.by_touch() ? tr("Ticks are off. Press Enter to switch them on.")
                                      : tr("The force is off. Press Enter to switch it on."),
                    Priority::touch);
    return view_.ready() && servo_.engaged();
}

void ExploreTour::toggle() {
    if (touring())
        return end_told();
    if (!may_begin())
        return;
    const int feature = finger_.meant_feature();
    grab_from_ = finger_.hand_place();
    words_.tell(servo_.by_touch() ? tr("Tour round the %1. Follow the ticks: they grow toward the line.")
                                        .arg(view_.label_of(feature))
                                  : tr("Tour round the %1.").arg(view_.label_of(feature)),
                Priority::touch);
    lead(feature);
    emit changed();
}

void ExploreTour::toggleFace() {
    if (touring())
        return end_told();
    if (!may_begin())
        return;
    const std::size_t face = view_.feature(finger_.meant_feature()).face;
    const std::vector<int> order = tour_order(view_.features(), face);
    left_.assign(order.begin(), order.end());
    grab_from_ = finger_.hand_place();
    goes_on_at_ =
        breath_s + words_.tell(tr("Tour of %1: %n feature(s). %2.", nullptr, static_cast<int>(order.size()))
                                   .arg(view_.name_of_face(face),
                                        at_the_start(feature_word(view_.feature(order.front()).name))),
                               Priority::message);
    state_ = State::Naming;
    emit changed();
}

void ExploreTour::lead(int feature) {
    finger_.set_last_feature(feature);
    servo_.lead_along(static_cast<std::size_t>(feature));
    state_ = State::Leading;
    if (!servo_.leads())
        end();
}

void ExploreTour::follow(double progress, double now) {
    set_progress(state_ == State::Leading ? progress : 0.0);
    if (state_ == State::Leading && servo_.has_led()) {
        if (left_.empty())
            return end(tr("Tour finished."));
        servo_.let_go();
        state_ = State::Naming;
        goes_on_at_ =
            breath_s +
            words_.tell(tr("%1.").arg(at_the_start(feature_word(view_.feature(left_.front()).name))),
                        Priority::message);
    } else if (state_ == State::Naming && now >= goes_on_at_) {
        const int next = left_.front();
        left_.pop_front();
        lead(next);
    }
}

void ExploreTour::end(const QString& sentence) {
    servo_.let_go();
    state_ = State::None;
    left_.clear();
    grab_from_.reset();
    set_progress(0.0);
    emit changed();
    if (!sentence.isEmpty())
        words_.tell(sentence, Priority::message);
}

bool ExploreTour::yields_to(Vec2 hand) {
    if (!touring() || servo_.by_touch()) // ticks lead a hand that moves by itself
        return true;
    if (!grab_from_)
        grab_from_ = hand;
    if (length(hand - *grab_from_) <= grab_mm)
        return false;
    end_told();
    return true;
}

void ExploreTour::set_progress(double progress) {
    if (progress == progress_)
        return;
    progress_ = progress;
    emit progressed();
}

} // namespace tp
