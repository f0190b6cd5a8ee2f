// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_history.hpp"
#include "app/pages/mend/mend_selection.hpp"
#include "app/pages/mend/mend_view.hpp"
#include "app/pages/mend/mended_photo.hpp"
#include "app/parts/narration/narrator.hpp"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// A mouse or a finger that takes hold of a point, or of a whole feature, and moves it. Places are window pixels of the drawing
/// surface.
///
/// |        | grab: something is there | dragTo: another place | drop           | cancel, turning back, leaving  |
/// |--------|--------------------------|-----------------------|----------------|--------------------------------|
/// | Free   | Held                     |                       |                |                                |
/// | Held   | Held                     | Moving                | Free           | Free                           |
/// | Moving | Held                     | Moving                | Free: it stays | Free: as if never moved        |
class MendDrag final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")
public:
    enum class State {
        Free,   ///< nothing is held
        Held,   ///< something is, where it was
        Moving, ///< it was moved
    };

    /// All must outlive it.
    MendDrag(const MendedPhoto& photo, const MendView& view, MendSelection& selection, MendHistory& history,
             Narrator& narrator);

    State state() const { return state_; }

    /// Takes the point there, within `reach`, by hand; false where there is none.
    Q_INVOKABLE bool grab(double x, double y, double reach);
    Q_INVOKABLE void dragTo(double x, double y);
    Q_INVOKABLE void drop();
    /// Puts what is dragged back; false where nothing is.
    Q_INVOKABLE bool cancel();

private:
    const MendedPhoto& photo_;
    const MendView& view_;
    MendSelection& selection_;
    MendHistory& history_;
    Narrator& narrator_;
    State state_ = State::Free;
    Vec2 last_{0.0};   ///< where the hand was, px of the photograph
    Vec2 offset_{0.0}; ///< from the hand to the point it holds
};

} // namespace tp
