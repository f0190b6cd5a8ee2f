// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "app/parts/work/newest_work.hpp"
#include "app/photo/tactile/tactile_sheet.hpp"
#include "audio/sound/earcon_player.hpp"
#include "core/base/result.hpp"
#include "faces/base/face.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// A photograph's faces on the way to paper: which paper, which face, a look at the sheet, and its files.
class PrintSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(QString photoName READ photoName NOTIFY photoChanged)
    Q_PROPERTY(bool looking READ looking NOTIFY photoChanged)
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
    /// All of them, then each.
    Q_PROPERTY(QStringList faces READ faces NOTIFY photoChanged)
    Q_PROPERTY(int face READ face NOTIFY optionsChanged)
    Q_PROPERTY(bool titled READ titled NOTIFY optionsChanged)
public:
    /// What is read of a photograph.
    struct Subject {
        Extraction extraction;
        std::vector<std::string> names; ///< of its faces, empty where nobody knows
    };
    using Read = std::function<Subject(const std::filesystem::path& photo)>;
    /// Faces with a person's corrections, and names from the metadata.
    static Subject read_subject(const std::filesystem::path& photo);

    /// `folder` is where sheets are stored; `read` is called on another thread. All must outlive the session.
    PrintSession(Narrator& narrator, EarconPlayer& earcons, Preferences& preferences, std::filesystem::path folder,
                 Read read = read_subject);
    /// TouchPhoto in the user's documents.
    static std::filesystem::path usual_folder();

    QString photoName() const { return QString::fromStdU16String(photo_.filename().u16string()); }
    bool looking() const { return looking_; }
    bool ready() const { return sheet_.has_value(); }
    QStringList notes() const { return notes_; }
    QString size() const;
    QString preview() const { return preview_; }
    QStringList papers_named() const;
    int paper() const { return paper_; }
    bool landscape() const { return landscape_; }
    QStringList faces() const;
    int face() const { return face_; }
    bool titled() const { return titled_; }
    const std::optional<TactileSheet>& sheet() const { return sheet_; }

    void open_photo(const std::filesystem::path& photo);
    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();
    Q_INVOKABLE void choosePaper(int index);
    Q_INVOKABLE void setLandscape(bool landscape);
    Q_INVOKABLE void chooseFace(int index);
    Q_INVOKABLE void setTitled(bool titled);
    /// Writes the sheet; `ending` is "pdf" or "svg". A file that is there already stays.
    Q_INVOKABLE void store(const QString& ending);

signals:
    void photoChanged();
    void sheetChanged();
    void optionsChanged();

private:
    void take(const Subject& subject);
    void make();
    void draw();

    Narrator& narrator_;
    EarconPlayer& earcons_;
    Preferences& preferences_;
    std::filesystem::path folder_;
    Read read_;
    std::filesystem::path photo_;
    bool looking_ = false;
    Subject subject_;
    int paper_ = 0, face_ = 0;
    bool landscape_ = false, titled_ = false;
    std::optional<TactileSheet> sheet_;
    QStringList notes_;
    QString preview_;
    NewestWork reading_; ///< last: it ends before what its work is for
};

} // namespace tp
