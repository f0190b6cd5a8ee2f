// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/name_languages.hpp"
#include "app/album/open/open_album.hpp"
#include "app/pages/care/care_folders.hpp"
#include "app/pages/care/care_history.hpp"
#include "app/pages/care/care_people.hpp"
#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/cared_photo.hpp"
#include "app/pages/care/description_care.hpp"
#include "app/pages/care/description_draft.hpp"
#include "app/pages/care/face_care.hpp"
#include "app/pages/care/face_finder.hpp"
#include "app/pages/care/group_care.hpp"
#include "app/pages/care/import_care.hpp"
#include "app/pages/care/keeper_steps.hpp"
#include "app/pages/care/listening.hpp"
#include "app/pages/care/photo_rows.hpp"
#include "app/pages/care/recording_list.hpp"
#include "app/pages/care/recording_wait.hpp"
#include "app/pages/care/take.hpp"
#include "app/pages/care/thumbnails.hpp"
#include "app/pages/care/trimming.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/player.hpp"
#include "audio/sound/recorder.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <vector>

namespace tp {

/// The care page: the parts that each do one thing, which photograph is cared for, and what concerns several parts. A
/// part knows those before it. The page only binds and draws.
class CareSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::PhotoRows* photos READ photos CONSTANT)
    Q_PROPERTY(tp::ImportCare* importing READ importing CONSTANT)
    Q_PROPERTY(tp::CareFolders* folders READ folders CONSTANT)
    Q_PROPERTY(tp::CarePeople* people READ people CONSTANT)
    Q_PROPERTY(tp::FaceCare* faces READ faces CONSTANT)
    Q_PROPERTY(tp::GroupCare* groups READ groups CONSTANT)
    Q_PROPERTY(tp::RecordingList* recordings READ recordings CONSTANT)
    Q_PROPERTY(tp::Take* take READ take CONSTANT)
    Q_PROPERTY(tp::Trimming* trimming READ trimming CONSTANT)
    Q_PROPERTY(tp::DescriptionCare* descriptions READ descriptions CONSTANT)
    Q_PROPERTY(tp::DescriptionDraft* draft READ draft CONSTANT)
    Q_PROPERTY(tp::CareHistory* history READ history CONSTANT)
    Q_PROPERTY(bool photoOpen READ photoOpen NOTIFY photoChanged)
    Q_PROPERTY(QString photoName READ photoName NOTIFY photoChanged)
    Q_PROPERTY(int photoRow READ photoRow NOTIFY photoChanged) ///< in `photos`; −1: none
public:
    /// All must outlive it.
    CareSession(OpenAlbum& album, AlbumFaces& groups, Narrator& narrator, EarconPlayer& earcons,
                Recorder& recorder, Player& player, Preferences& preferences);
    /// What a person typed or recorded is kept first.
    ~CareSession() override;

    PhotoRows* photos() { return &photos_; }
    ImportCare* importing() { return &import_; }
    CareFolders* folders() { return &folders_; }
    CarePeople* people() { return &people_; }
    FaceCare* faces() { return &faces_; }
    GroupCare* groups() { return &groups_; }
    RecordingList* recordings() { return &recordings_; }
    Take* take() { return &take_; }
    Trimming* trimming() { return &trimming_; }
    DescriptionCare* descriptions() { return &descriptions_; }
    DescriptionDraft* draft() { return &draft_; }
    CareHistory* history() { return &history_; }

    bool photoOpen() const { return photo_.is_open(); }
    QString photoName() const;
    const std::filesystem::path& photo() const { return photo_.place().photo; }
    int photoRow() const { return photos_.row_of(photo_.place().photo); }
    /// A step is on its way to the disk.
    bool busy() const { return steps_.busy(); }
    /// Something that a person recorded, typed or chose is not on the disk yet.
    bool keeping() const { return busy() || take_.running(); }

    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();
    /// Ends the choice of a folder; else stops what sounds, where a recording that is being made is ended and kept; else
    /// goes back from people to photographs. False: there was nothing.
    Q_INVOKABLE bool stop();

    /// A row of `photos` is to be cared for.
    Q_INVOKABLE void openRow(int row);
    void open_photo(const std::filesystem::path& photo);
    /// Back to the list.
    Q_INVOKABLE void closePhoto();
    /// To the trash, with everything that is its own.
    Q_INVOKABLE void deletePhoto();
    Q_INVOKABLE void mend();
    Q_INVOKABLE void print();
    /// Something went wrong on the page itself.
    Q_INVOKABLE void tellProblem(const QString& sentence) { teller_.problem(sentence); }

signals:
    void photoChanged();
    void keepingChanged();
    /// As CaredPhoto's.
    void nameLanguagesRead(const std::filesystem::path& album, const std::vector<tp::NameLanguage>& names);
    /// Contours of this photograph are to be mended by hand.
    void mendAsked(const QString& photo);
    /// A tactile sheet of this photograph is to be made.
    void printAsked(const QString& photo);

private:
    OpenAlbum& album_;
    CareTeller teller_;
    KeeperSteps steps_;
    FaceFinder finder_;
    Thumbnails thumbnails_;
    CaredPhoto photo_;
    PhotoRows photos_;
    ImportCare import_;
    CareFolders folders_;
    CarePeople people_;
    FaceCare faces_;
    GroupCare groups_;
    RecordingList recordings_;
    Listening listening_;
    Take take_;
    Trimming trimming_;
    DescriptionCare descriptions_;
    DescriptionDraft draft_;
    RecordingWait recording_;
    CareHistory history_;
};

} // namespace tp
