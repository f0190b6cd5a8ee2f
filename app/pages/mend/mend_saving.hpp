// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_history.hpp"
#include "app/pages/mend/mend_selection.hpp"
#include "app/pages/mend/mended_photo.hpp"
#include "app/parts/narration/narrator.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <string>

namespace tp {

/// Whether the contours lie on the disk as they are, and how they get there.
class MendSaving final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(bool unsaved READ unsaved NOTIFY changed)
    Q_PROPERTY(bool canDiscard READ canDiscard NOTIFY changed)
public:
    /// All must outlive it.
    MendSaving(MendedPhoto& photo, MendSelection& selection, MendHistory& history, Narrator& narrator);
    /// What is not saved yet is saved.
    ~MendSaving() override;

    bool unsaved() const { return unsaved_; }
    bool canDiscard() const { return opened_text_ != text_; }

    /// Brings the contours to the disk and says so; false where that is refused.
    Q_INVOKABLE bool save();
    /// As they were when the photograph was opened; can be undone.
    Q_INVOKABLE void discard();
    /// Brings them to the disk without a word; the sentence that says why not, empty where they are there.
    QString write();

signals:
    void changed();

private:
    void begin_anew();
    void follow();

    MendedPhoto& photo_;
    MendSelection& selection_;
    MendHistory& history_;
    Narrator& narrator_;
    MendWork opened_;
    std::string opened_text_, text_; ///< of the sheet: as it was opened, and now
    bool unsaved_ = false;
};

} // namespace tp
