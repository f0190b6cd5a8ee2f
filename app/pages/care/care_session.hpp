// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/name_languages.hpp"
#include "app/album/open/open_album.hpp"
#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/cared_photo.hpp"
#include "app/pages/care/description_care.hpp"
#include "app/pages/care/face_care.hpp"
#include "app/pages/care/face_finder.hpp"
#include "app/pages/care/import_care.hpp"
#include "app/pages/care/keeper_steps.hpp"
#include "app/pages/care/listening.hpp"
#include "app/pages/care/photo_rows.hpp"
#include "app/pages/care/recording_list.hpp"
#include "app/pages/care/take.hpp"
#include "app/pages/care/thumbnails.hpp"
#include "app/pages/care/trimming.hpp"
#include "app/parts/folders/folder_chooser.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/player.hpp"
#include "audio/sound/recorder.hpp"

#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>
#include <vector>

namespace tp {

/// Everything that the care page decides: which photograph is cared for, taking steps back, and the parts that each do
/// one thing. The page only binds and draws.
class CareSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::PhotoRows* photos READ photos CONSTANT)
    Q_PROPERTY(tp::ImportCare* importing READ importing CONSTANT)
    Q_PROPERTY(tp::FaceCare* faces READ faces CONSTANT)
    Q_PROPERTY(tp::RecordingList* recordings READ recordings CONSTANT)
    Q_PROPERTY(tp::Take* take READ take CONSTANT)
    Q_PROPERTY(tp::Trimming* trimming READ trimming CONSTANT)
    Q_PROPERTY(tp::DescriptionCare* descriptions READ descriptions CONSTANT)

    Q_PROPERTY(bool photoOpen READ photoOpen NOTIFY photoChanged)
    Q_PROPERTY(QString photoName READ photoName NOTIFY photoChanged)
    Q_PROPERTY(int photoRow READ photoRow NOTIFY photoChanged) ///< in `photos`; −1: none
    Q_PROPERTY(QString undoText READ undoText NOTIFY stepsChanged) ///< empty: nothing to undo
    Q_PROPERTY(QString redoText READ redoText NOTIFY stepsChanged)
    Q_PROPERTY(bool hasFolders READ hasFolders NOTIFY albumChanged)
    /// A folder is being chosen, to import from or for the album.
    Q_PROPERTY(bool choosing READ choosing NOTIFY choosingChanged)
    Q_PROPERTY(tp::FolderChooser* chooser READ chooser CONSTANT)
public:
    /// All must outlive it.
    CareSession(OpenAlbum& album, Narrator& narrator, EarconPlayer& earcons, Recorder& recorder, Player& player,
                Preferences& preferences);
    /// What a person typed or recorded is kept first.
    ~CareSession() override;

    PhotoRows* photos() { return &photos_; }
    ImportCare* importing() { return &import_; }
    FaceCare* faces() { return &faces_; }
    RecordingList* recordings() { return &recordings_; }
    Take* take() { return &take_; }
    Trimming* trimming() { return &trimming_; }
    DescriptionCare* descriptions() { return &descriptions_; }

    bool choosing() const { return choosing_ != Choosing::nothing; }
    FolderChooser* chooser() { return &chooser_; }
    bool photoOpen() const { return photo_.is_open(); }
    QString photoName() const;
    int photoRow() const { return photos_.row_of(photo_.place().photo); }
    QString undoText() const { return steps_.next_undo(); }
    QString redoText() const { return steps_.next_redo(); }
    /// A step is on its way to the disk.
    bool busy() const { return steps_.busy(); }
    bool hasFolders() const { return album_.has_folders(); }

    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();
    /// Stops what sounds; a recording that is being made is ended and kept. False: there was nothing.
    Q_INVOKABLE bool stop();

    /// Lets a person choose a folder, whose photographs are then imported.
    Q_INVOKABLE void importFolder();
    /// A row of `photos` is to be cared for.
    Q_INVOKABLE void openRow(int row);
    void open_photo(const std::filesystem::path& photo);
    /// Back to the list.
    Q_INVOKABLE void closePhoto();
    /// To the trash, with everything that is its own.
    Q_INVOKABLE void deletePhoto();
    Q_INVOKABLE void undo();
    Q_INVOKABLE void redo();
    Q_INVOKABLE void mend();
    Q_INVOKABLE void print();
    /// People whom the album knows, for what was typed; all of them, the commonest first, for nothing.
    Q_INVOKABLE QStringList people(const QString& typed) const;
    /// Where a dialog for photographs begins.
    Q_INVOKABLE QUrl picturesFolder() const;
    /// Something went wrong on the page itself.
    Q_INVOKABLE void tellProblem(const QString& sentence) { teller_.problem(sentence); }

signals:
    void photoChanged();
    void stepsChanged();
    void albumChanged();
    void choosingChanged();
    /// As CaredPhoto's.
    void nameLanguagesRead(const std::filesystem::path& album, const std::vector<tp::NameLanguage>& names);
    /// Contours of this photograph are to be mended by hand.
    void mendAsked(const QString& photo);
    /// A tactile sheet of this photograph is to be made.
    void printAsked(const QString& photo);

private:
    enum class Choosing { nothing, source, album };
    void choose(Choosing what);
    void folder_chosen(const QString& folder);
    QString language() const;
    /// Ends what sounds; once a recording that is being made lies on the disk, or at once.
    void when_recorded(std::function<void()> then);
    /// True, and said, while a recording is being made: what it belongs to must stay where it is.
    bool refused_while_recording();
    void step_taken_back(bool back, const QString& what, const QString& problem);

    OpenAlbum& album_;
    Preferences& preferences_;
    CareTeller teller_;
    FolderChooser chooser_;
    Choosing choosing_ = Choosing::nothing;
    KeeperSteps steps_;
    FaceFinder finder_;
    Thumbnails thumbnails_;
    CaredPhoto photo_;
    PhotoRows photos_;
    ImportCare import_;
    FaceCare faces_;
    RecordingList recordings_;
    Listening listening_;
    Take take_;
    Trimming trimming_;
    DescriptionCare descriptions_;
    std::vector<std::function<void()>> when_recorded_; ///< what waits, in order
    std::filesystem::path gone_; ///< the photograph that was deleted last, to be opened when it comes back
};

} // namespace tp
