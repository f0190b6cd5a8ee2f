// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/demonstration.hpp"

#include "faces/base/face.hpp"

#include <algorithm>

namespace tp {

namespace {

constexpr int step_ms = 16;
constexpr int moving_steps = 60;
constexpr int resting_steps = 75; ///< until the force has faded in and the finger rests
constexpr double beside_mm = 7.0; ///< the hand; the finger is drawn to about 2.5 mm
constexpr double from_mm = 30.0;  ///< where the path begins, below the eye

/// The lowest place of an eye, or of the first line where there is none.
Vec2 below_an_eye(const FlatScene& scene) {
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < scene.names.size(); ++i)
        if (scene.names[i].ends_with(feature::left_eye)) {
            chosen = i;
            break;
        }
    const std::vector<Vec2>& points = scene.lines[chosen].points;
    return *std::min_element(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
}

} // namespace

Demonstration::Demonstration(ExploreSession& session) : session_(session) {
    connect(&timer_, &QTimer::timeout, this, &Demonstration::step);
    timer_.start(step_ms);
}

void Demonstration::step() {
    const ExploreView& view = *session_.view();
    if (view.state() == ExploreView::State::Looking)
        return;
    if (view.ready()) {
        const double share = std::min(1.0, steps_ / static_cast<double>(moving_steps));
        const double below = from_mm + share * (beside_mm - from_mm);
        const QPointF place = view.frame().from_surface(below_an_eye(view.felt()) - Vec2(0.0, below));
        if (steps_ == 0)
            session_.hand()->touchDown(place.x(), place.y());
        else
            session_.hand()->moveTo(place.x(), place.y());
    }
    if (++steps_ < moving_steps + resting_steps)
        return;
    timer_.stop();
    emit finished();
}

} // namespace tp
