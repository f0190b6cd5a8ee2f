// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_drag.hpp"
#include "app/pages/mend/mend_editing.hpp"
#include "app/pages/mend/mend_history.hpp"
#include "app/pages/mend/mend_photo.hpp"
#include "app/pages/mend/mend_preview.hpp"
#include "app/pages/mend/mend_saving.hpp"
#include "app/pages/mend/mend_selection.hpp"
#include "app/pages/mend/mend_view.hpp"
#include "app/pages/mend/mended_photo.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/work/latest_task.hpp"
#include "faces/extract/face_extractor.hpp"

#include <QObject>
#include <QString>
#include <QUrl>
#include <QtQml/qqmlregistration.h>

#include <memory>

namespace tp {

/// A photograph's contours while a person mends them: which photograph, and the parts that each do one thing.
class MendSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::MendedPhoto* photo READ photo CONSTANT)
    Q_PROPERTY(tp::MendView* view READ view CONSTANT)
    Q_PROPERTY(tp::MendSelection* selection READ selection CONSTANT)
    Q_PROPERTY(tp::MendHistory* history READ history CONSTANT)
    Q_PROPERTY(tp::MendDrag* drag READ drag CONSTANT)
    Q_PROPERTY(tp::MendEditing* editing READ editing CONSTANT)
    Q_PROPERTY(tp::MendPreview* preview READ preview CONSTANT)
    Q_PROPERTY(tp::MendSaving* file READ file CONSTANT)
public:
    /// The narrator must outlive the session.
    explicit MendSession(Narrator& narrator);

    MendedPhoto* photo() { return &photo_; }
    MendView* view() { return &view_; }
    MendSelection* selection() { return &selection_; }
    MendHistory* history() { return &history_; }
    MendDrag* drag() { return &drag_; }
    MendEditing* editing() { return &editing_; }
    MendPreview* preview() { return &preview_; }
    MendSaving* file() { return &file_; }

    /// The page comes into view, or goes: it tells where one is, or saves what is not saved.
    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();

    /// Reads a photograph and lays its contours out. What was not saved is saved first; where that is refused
    /// the photograph in hand stays.
    void open(const QUrl& file);
    void open_file(const QString& file);
    /// A photograph that is read already.
    void show(MendPhoto photo);

private:
    void tell(const QString& sentence) { narrator_.tell(sentence, Priority::message); }

    Narrator& narrator_;
    MendedPhoto photo_;
    MendView view_;
    MendSelection selection_;
    MendHistory history_;
    MendDrag drag_;
    MendEditing editing_;
    MendPreview preview_;
    MendSaving file_;
    std::unique_ptr<FaceExtractor> extractor_; ///< only the loader's thread
    LatestTask loader_;                        ///< last: its thread ends first
};

} // namespace tp
