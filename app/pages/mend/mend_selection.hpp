// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/handle_model.hpp"
#include "app/pages/mend/mend_view.hpp"
#include "app/pages/mend/mended_photo.hpp"
#include "app/parts/narration/narrator.hpp"

#include <QObject>
#include <QPointF>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <cstddef>
#include <optional>

namespace tp {

/// What is in hand: a feature of a face, and of its contour one point, none, or all of it.
///
/// Places that a page gives are window pixels of its drawing surface.
class MendSelection final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// Names of all features of all faces, there or not.
    Q_PROPERTY(QStringList features READ features NOTIFY featuresChanged)
    Q_PROPERTY(int feature READ feature NOTIFY changed) ///< −1: none
    Q_PROPERTY(QString featureName READ featureName NOTIFY changed)
    Q_PROPERTY(bool featureThere READ featureThere NOTIFY changed)
    Q_PROPERTY(bool featureMended READ featureMended NOTIFY changed)
    Q_PROPERTY(tp::HandleModel* handles READ handles CONSTANT)
    Q_PROPERTY(int handle READ handle NOTIFY changed) ///< −1: none
    Q_PROPERTY(QString handleName READ handleName NOTIFY changed)
    Q_PROPERTY(QString handlePlace READ handlePlace NOTIFY changed)
    Q_PROPERTY(bool handleTurns READ handleTurns NOTIFY changed) ///< a corner can be made of it, or undone
    Q_PROPERTY(bool handleIsCorner READ handleIsCorner NOTIFY changed)
    /// What moves is the whole feature, not one point.
    Q_PROPERTY(bool wholeFeature READ wholeFeature WRITE setWholeFeature NOTIFY changed)
public:
    /// All must outlive it.
    MendSelection(const MendedPhoto& photo, MendView& view, Narrator& narrator);

    const QStringList& features() const { return feature_names_; }
    int feature() const { return feature_; }
    QString featureName() const { return name_of(feature_); }
    bool featureThere() const { return line() != nullptr; }
    bool featureMended() const { return own() != nullptr && own()->mended; }
    HandleModel* handles() { return &handles_; }
    int handle() const { return handle_; }
    QString handleName() const;
    QString handlePlace() const;
    bool handleTurns() const;
    bool handleIsCorner() const;
    bool wholeFeature() const { return whole_; }
    void setWholeFeature(bool whole);

    Q_INVOKABLE void chooseFeature(int index);
    Q_INVOKABLE void stepFeature(int step);
    Q_INVOKABLE void chooseHandle(int index);
    /// To the next (+1) or previous (-1) point; false where there is none left, so that the keyboard's focus
    /// may leave the surface.
    Q_INVOKABLE bool stepHandle(int step);
    /// A short press: the point there is taken in hand, or the feature whose line passes within `reach`.
    Q_INVOKABLE void tap(double x, double y, double reach);
    Q_INVOKABLE void whereAmI();
    /// Larger or smaller; the point in hand stays where it is in the window, or its middle.
    Q_INVOKABLE void zoomBy(double factor);
    /// The feature with room round it; where it is not there, its face.
    Q_INVOKABLE void fitIntoView();

    /// The feature in hand, and its contour; null where there is none.
    const MendFeature* own() const;
    const MendContour* line() const;
    /// The feature in hand, which must be there, in `work`.
    MendFeature& own_in(MendWork& work) const;
    /// Its face; null where no feature is in hand.
    const MendFace* face() const;
    /// The point in hand; there must be one.
    std::size_t node() const { return static_cast<std::size_t>(handle_); }
    std::optional<int> handle_at(QPointF place, double reach) const;
    std::optional<int> line_at(QPointF place, double reach) const;

    /// Take something in hand without a word about it.
    void take_feature(int index);
    void take_handle(int index);
    /// Which point is in hand, and where; nothing where none is.
    void tell_handle();

signals:
    void featuresChanged();
    void changed();
    /// Before another feature is taken in hand.
    void leavingFeature();
    /// What a person did to the point in hand until now is done.
    void leavingPoint();
    /// A person asked for what is in hand, where no feature is.
    void nothingInHand();

private:
    struct Place {
        std::size_t face, feature;
    };
    std::optional<Place> place_of(int index) const;
    QString name_of(int index) const;
    void begin_anew();
    void follow();
    void show_handles();

    const MendedPhoto& photo_;
    MendView& view_;
    Narrator& narrator_;
    QStringList feature_names_;
    int feature_ = -1;
    HandleModel handles_;
    int handle_ = -1;
    bool whole_ = false;
};

} // namespace tp
