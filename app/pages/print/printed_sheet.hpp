// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/print/printed_photo.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/photo/tactile/tactile_sheet.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace tp {

/// The sheet of a photograph: which paper, which face, and what became of them. Each choice makes it anew and
/// is told.
class PrintedSheet final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// There is a sheet to be stored.
    Q_PROPERTY(bool ready READ ready NOTIFY sheetChanged)
    /// What was simplified or left out, or why there is no sheet.
    Q_PROPERTY(QStringList notes READ notes NOTIFY sheetChanged)
    Q_PROPERTY(QString size READ size NOTIFY sheetChanged)
    /// The sheet as a picture, a data URL.
    Q_PROPERTY(QString preview READ preview NOTIFY sheetChanged)
    Q_PROPERTY(QStringList papers READ papers_named NOTIFY optionsChanged)
    Q_PROPERTY(int paper READ paper NOTIFY optionsChanged)
    Q_PROPERTY(bool landscape READ landscape NOTIFY optionsChanged)
    Q_PROPERTY(int face READ face NOTIFY optionsChanged) ///< of the photograph's `faces`
    Q_PROPERTY(bool titled READ titled NOTIFY optionsChanged)
public:
    /// Both must outlive the sheet.
    PrintedSheet(const PrintedPhoto& photo, Narrator& narrator);

    bool ready() const { return sheet_.has_value(); }
    QStringList notes() const { return notes_; }
    QString size() const;
    QString preview() const { return preview_; }
    QStringList papers_named() const;
    int paper() const { return paper_; }
    bool landscape() const { return landscape_; }
    int face() const { return face_; }
    bool titled() const { return titled_; }
    const std::optional<TactileSheet>& sheet() const { return sheet_; }

    /// There is none, of all faces, until one is made.
    void clear();
    void make();

    Q_INVOKABLE void choosePaper(int index);
    Q_INVOKABLE void setLandscape(bool landscape);
    Q_INVOKABLE void chooseFace(int index);
    Q_INVOKABLE void setTitled(bool titled);

signals:
    void sheetChanged();
    void optionsChanged();

private:
    const PrintedPhoto& photo_;
    Narrator& narrator_;
    int paper_ = 0, face_ = 0;
    bool landscape_ = false, titled_ = false;
    std::optional<TactileSheet> sheet_;
    QStringList notes_;
    QString preview_;
};

} // namespace tp
