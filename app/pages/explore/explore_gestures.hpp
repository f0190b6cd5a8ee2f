// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_device.hpp"
#include "app/pages/explore/explore_finger.hpp"
#include "app/pages/explore/explore_tour.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_walk.hpp"
#include "app/pages/explore/explore_zoom.hpp"
#include "app/pages/explore/touch_gestures.hpp"

#include <QObject>

namespace tp {

/// What taps and swipes do, once it is known which they were.
class ExploreGestures final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this.
    ExploreGestures(ExploreView& view, ExploreWalk& walk, ExploreFinger& finger, ExploreTour& tour,
                    ExploreZoom& zoom, ExploreDevice& device);

    void perform(TouchGestures::Gesture gesture);

signals:
    /// What sounds or moves is to end; where nothing does, the force is to come back.
    void stop_or_start_asked();

private:
    ExploreView& view_;
    ExploreWalk& walk_;
    ExploreFinger& finger_;
    ExploreTour& tour_;
    ExploreZoom& zoom_;
    ExploreDevice& device_;
    bool toured_before_tap_ = false; ///< what the first of two taps has stopped
};

} // namespace tp
