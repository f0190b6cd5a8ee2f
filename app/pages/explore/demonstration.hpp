// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_session.hpp"

namespace tp {

/// Moves the hand along a short path to a place beside an eye and holds it there, for a picture of the page
/// in which pointer, finger and force can be seen.
class Demonstration final : public QObject {
    Q_OBJECT
public:
    explicit Demonstration(ExploreSession& session);

signals:
    /// The finger rests beside the eye, or the photograph has nothing to feel.
    void finished();

private:
    void step();

    ExploreSession& session_;
    QTimer timer_;
    int steps_ = 0;
};

} // namespace tp
