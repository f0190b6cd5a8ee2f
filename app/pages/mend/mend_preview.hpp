// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/felt_change.hpp"
#include "app/pages/mend/mend_words.hpp"
#include "app/pages/mend/mended_photo.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/work/latest_task.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// The force of the contours as they are, computed beside the page:
///
///              | the contours change | it is there | another photograph
///     Current  | Asked               | Current     | Current, of nothing
///     Asked    | Outdated            | Current     | Current, of nothing
///     Outdated | Outdated            | Asked       | Current, of nothing
class MendPreview final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(bool forceShown READ forceShown WRITE setForceShown NOTIFY shownChanged)
    Q_PROPERTY(QString change READ change NOTIFY changed) ///< how much what is felt changed
public:
    enum class State {
        Current,  ///< `felt` is that of the contours
        Asked,    ///< it is being computed
        Outdated, ///< so is one of contours that are others now
    };

    /// Both must outlive it.
    MendPreview(const MendedPhoto& photo, Narrator& narrator);

    State state() const { return state_; }
    bool forceShown() const { return shown_; }
    void setForceShown(bool shown);
    QString change() const { return change_words(felt_.difference); }
    const FeltChange& felt() const { return felt_; }

signals:
    void shownChanged();
    void changed();

private:
    void begin_anew();
    void follow();
    void take(const FeltChange& felt);

    const MendedPhoto& photo_;
    Narrator& narrator_;
    State state_ = State::Current;
    bool shown_ = false;
    FeltChange felt_;
    LatestTask work_; ///< last: its thread ends first
};

} // namespace tp
