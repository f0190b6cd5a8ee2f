// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/open/open_album.hpp"
#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/cared_photo.hpp"
#include "app/pages/care/keeper_steps.hpp"
#include "app/pages/care/recording_wait.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <filesystem>

namespace tp {

/// Steps taken back and done again, and the one that only they bring back: a photograph deleted. One that goes with a step
/// is closed; one that comes back is opened.
class CareHistory final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(QString undoText READ undoText NOTIFY changed) ///< empty: nothing to undo
    Q_PROPERTY(QString redoText READ redoText NOTIFY changed)
public:
    /// All must outlive it.
    CareHistory(KeeperSteps& steps, CaredPhoto& photo, OpenAlbum& album, RecordingWait& recording,
                CareTeller& teller);

    QString undoText() const { return steps_.next_undo(); }
    QString redoText() const { return steps_.next_redo(); }
    Q_INVOKABLE void undo();
    Q_INVOKABLE void redo();

    /// To the trash, with everything that is its own, once what is being recorded is kept. Opened again where that fails.
    void delete_photo(const PhotoPlace& place);

signals:
    void changed();

private:
    enum class Way { back, forth };
    void stepped(Way way, const QString& what, const QString& problem);
    void follow_photo();

    KeeperSteps& steps_;
    CaredPhoto& photo_;
    OpenAlbum& album_;
    RecordingWait& recording_;
    CareTeller& teller_;
    std::filesystem::path gone_; ///< the photograph that went last; empty where it has come back
};

} // namespace tp
