// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_drag.hpp"
#include "app/pages/mend/mend_history.hpp"
#include "app/pages/mend/mend_selection.hpp"
#include "app/pages/mend/mend_view.hpp"
#include "app/pages/mend/mended_photo.hpp"
#include "app/parts/narration/narrator.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <cstddef>
#include <functional>

namespace tp {

/// What is mended by keys, buttons and a screen reader: each a step that is told and can be taken back.
class MendEditing final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")
public:
    /// All must outlive it.
    MendEditing(const MendedPhoto& photo, MendView& view, MendSelection& selection, MendHistory& history,
                const MendDrag& drag, Narrator& narrator);

    /// Moves the point, or the whole feature, by pixels of the photograph.
    Q_INVOKABLE void nudge(double dx, double dy);
    /// The same for a point by its number, as a screen reader moves it.
    Q_INVOKABLE void nudgeHandle(int index, double dx, double dy);
    /// Behind the point in hand.
    Q_INVOKABLE void addPoint();
    /// On the line, nearest to a place of the window.
    Q_INVOKABLE void addPointAt(double x, double y);
    Q_INVOKABLE void deletePoint();
    /// Makes a smooth point a corner, or the other way round.
    Q_INVOKABLE void turnCorner();
    /// The feature as the program found it.
    Q_INVOKABLE void resetFeature();
    Q_INVOKABLE void addFeature();
    Q_INVOKABLE void removeFeature();
    /// One of usual shape in the middle of what is seen.
    Q_INVOKABLE void addFace();

private:
    void tell(const QString& sentence) { narrator_.tell(sentence, Priority::touch); }
    void mend(const QString& what, const std::function<void(MendContour&)>& change, const QString& run = {});
    void move_by(Vec2 by, const QString& run);
    void add_point(const std::function<std::size_t(MendContour&)>& add);

    const MendedPhoto& photo_;
    MendView& view_;
    MendSelection& selection_;
    MendHistory& history_;
    const MendDrag& drag_;
    Narrator& narrator_;
};

} // namespace tp
