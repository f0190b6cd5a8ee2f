// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/importer.hpp"
#include "app/album/open/open_album.hpp"
#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/import_pace.hpp"
#include "app/parts/preferences/preferences.hpp"

#include <QElapsedTimer>
#include <QList>
#include <QStringList>
#include <QThreadPool>
#include <QUrl>
#include <QtQml/qqmlregistration.h>

#include <atomic>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace tp {

/// Bringing photographs into a folder of the album, on a thread of its own: begun, stopped, gone on with, and what became
/// of it. Without a folder one is asked for first.
class ImportCare final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(bool running READ running NOTIFY changed)
    Q_PROPERTY(double fraction READ fraction NOTIFY progressed)     ///< 0–1, by bytes
    Q_PROPERTY(QString progressText READ progressText NOTIFY progressed)
    Q_PROPERTY(QString report READ report NOTIFY changed)           ///< of the last import
    Q_PROPERTY(QStringList problems READ problems NOTIFY changed)   ///< what did not come, or not wholly, one by one
    Q_PROPERTY(bool unfinished READ unfinished NOTIFY changed)      ///< an import can go on
    Q_PROPERTY(
        QString unfinishedText READ unfinishedText NOTIFY changed) ///< from where to where it would go on
    Q_PROPERTY(QStringList folders READ folders NOTIFY foldersChanged)
    Q_PROPERTY(int folder READ folder WRITE setFolder NOTIFY foldersChanged) ///< that an import goes to
public:
    /// All must outlive it.
    ImportCare(OpenAlbum& album, Preferences& preferences, CareTeller& teller);
    /// Stops an import that is under way; it can go on another time.
    ~ImportCare() override;

    bool running() const { return running_; }
    double fraction() const;
    QString progressText() const;
    const QString& report() const { return report_; }
    const QStringList& problems() const { return problems_; }
    bool unfinished() const { return !running_ && !unfinished_.empty(); }
    const QString& unfinishedText() const { return unfinished_text_; }
    QStringList folders() const;
    int folder() const { return folder_; }
    void setFolder(int folder);

    /// Imports these files and folders; without a folder of the album `folderWanted` is told, and the import begins
    /// when one was chosen.
    Q_INVOKABLE void import(const QList<QUrl>& sources);
    /// A folder becomes the album's first one, or another one of it.
    Q_INVOKABLE void chooseFolder(const QUrl& folder);
    /// No folder was chosen after all.
    Q_INVOKABLE void dropWish() { wish_.clear(); }
    /// After the photograph that is being copied.
    Q_INVOKABLE void stop();
    /// Says first what it takes from where.
    Q_INVOKABLE void goOn();
    /// The unfinished import is not gone on with; what it brought stays.
    Q_INVOKABLE void giveUp();
    /// Looks for imports that were not finished.
    void look();

signals:
    void changed();
    void progressed();
    void foldersChanged();
    /// A page is to let a person choose a folder and hand it to chooseFolder().
    void folderWanted();

private:
    using Work = std::function<Result<ImportReport>(const ImportTools&)>;
    void follow_folders();
    void run(const QString& told, Work work);
    void show(const ImportProgress& progress);
    void finish(const Result<ImportReport>& report);

    OpenAlbum& album_;
    Preferences& preferences_;
    CareTeller& teller_;
    int folder_ = 0;
    std::filesystem::path into_; ///< the folder of that number; empty: none
    bool running_ = false;
    ImportProgress progress_;
    QString report_;
    QStringList problems_;
    std::vector<std::string> unfinished_;
    QString unfinished_text_; ///< of the first
    QList<QUrl> wish_; ///< waits for a folder
    ImportPace pace_;
    QElapsedTimer clock_;
    std::stop_source stop_;
    QThreadPool pool_; ///< last: it ends before what its work is for
};

} // namespace tp
