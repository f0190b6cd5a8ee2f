// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/grouping/album_faces.hpp"
#include "app/album/looking/album_looks.hpp"
#include "app/album/open/open_album.hpp"
#include "app/capture/camera/camera.hpp"
#include "app/pages/browse/browse_session.hpp"
#include "app/pages/capture/capture_session.hpp"
#include "app/pages/care/care_session.hpp"
#include "app/pages/explore/explore_session.hpp"
#include "app/pages/lab/lab_session.hpp"
#include "app/pages/mend/mend_session.hpp"
#include "app/pages/print/print_session.hpp"
#include "app/pages/settings/settings_session.hpp"
#include "app/pages/start/first_questions.hpp"
#include "app/pages/start/start_session.hpp"
#include "app/pages/study/study_session.hpp"
#include "app/parts/controls/notification_announcer.hpp"
#include "app/parts/devices/touch_access.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "app/shell/languages.hpp"
#include "app/shell/shell.hpp"
#include "app/shell/voice_names.hpp"
#include "audio/guide/click_sound.hpp"
#include "audio/guide/sonified_guide.hpp"
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/recorder_worker.hpp"
#include "audio/sound/sound_output.hpp"

#include <QObject>
#include <QString>
#include <QVariantMap>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace tp {

/// What the program is made of that differs between a person's computer and a test.
struct ProgramParts {
    Voice& voice;
    std::function<std::unique_ptr<SoundOutput>()>
        make_loudspeaker; ///< each thing that sounds has one to itself
    MakeInput make_microphone;
    std::filesystem::path preferences; ///< file
    std::filesystem::path cache;       ///< folder
    std::filesystem::path documents;   ///< folder of what is made to be used outside: sheets, tables
    ExploreSettings explore;
    FirstQuestions::FindDevices find_devices;
    std::optional<Narrator::By> by = {};                       ///< who speaks, whatever was chosen
    std::function<std::unique_ptr<Camera>()> make_camera = {}; ///< empty: this machine's own
    /// Outputs under a bare finger; who listens lets the drawn one's ticks be heard. Empty: there are none.
    std::function<TouchAccess(std::shared_ptr<TickListener>)> make_touch = {};
};

/// All pages and what they share. A page's session is made when the page is opened first.
class Program final : public QObject {
    Q_OBJECT
    Q_PROPERTY(int scheme READ scheme NOTIFY appearanceChanged)
    Q_PROPERTY(double textScale READ textScale NOTIFY appearanceChanged)
    Q_PROPERTY(bool motion READ motion NOTIFY appearanceChanged)
public:
    explicit Program(ProgramParts parts);
    ~Program() override;

    /// The session of a page that the shell knows.
    Q_INVOKABLE QObject* session(const QString& page);
    /// Each page's QML file.
    static QVariantMap page_files();

    Shell& shell() { return shell_; }
    NotificationAnnouncer& announcer() { return announcer_; }
    Preferences& preferences() { return preferences_; }
    StartSession& start() { return start_; }
    OpenAlbum& album();
    BrowseSession& browse();
    ExploreSession& explore();
    CareSession& care();
    CaptureSession& capture();
    MendSession& mend();
    PrintSession& print();
    LabSession& lab();
    StudySession& study();
    SettingsSession& settings();

    /// The sound of the start, at once, and then the page: Start; with a photograph Explore; with a .touchphoto bundle
    /// Care, which imports it.
    void begin(const QString& file);

    /// Before the end: the open page ends what it is doing, and this waits until all that a person recorded, typed or took is
    /// on the disk. Meanwhile keys and clicks are not heeded; a sentence says so where it takes more than a second.
    void keep_all();

    /// Opens a page of this name; one that is about a photograph, on the one that one was at last.
    void open_page(const QString& page);
    /// The keyboard has come to something; a screen reader says so itself.
    void tell_focus(const QString& words);

    int scheme() const { return static_cast<int>(preferences_.choices().theme); }
    double textScale() const { return preferences_.choices().text_scale; }
    bool motion() const { return preferences_.choices().motion; }

signals:
    void appearanceChanged();
    /// `keeping` may have changed.
    void kept();
    /// All texts are to be asked for anew.
    void language_changed();

private:
    struct Playing;
    struct Browsing;
    struct Caring;
    struct Capturing;

    TouchAccess touch();
    AlbumFaces& album_faces();
    std::filesystem::path folder_for_photographs();
    void add_pages();
    void enter_start();
    void enter_explore();
    QString beside(const QString& file, bool forward);
    void remember_felt();
    void know_people_before_camera();
    void feel(const QString& photo);
    void care_for(const QString& photo);
    void follow_choices();
    void look_as_chosen();
    void show_looked(const std::filesystem::path& photo);
    void know_news();
    void news_told();
    bool keeping() const;

    ProgramParts parts_;
    Preferences preferences_;
    Languages languages_; ///< before anything that has words
    NotificationAnnouncer announcer_;
    Narrator narrator_;
    VoiceNames voice_names_;
    std::unique_ptr<SoundOutput> earcon_output_;
    EarconPlayer earcons_;
    std::unique_ptr<SoundOutput> guide_output_;
    SonifiedGuide guide_;
    std::unique_ptr<SoundOutput> click_output_; ///< made when a page wants outputs under a bare finger
    std::unique_ptr<ClickSound> clicks_;
    Shell shell_;
    QString last_at_explore_;    ///< Choices::last_photo as Explore knew it last
    bool discard_index_ = false; ///< when nobody has it open any more
    std::unique_ptr<OpenAlbum> album_;
    std::unique_ptr<AlbumLooks> looks_;
    std::unique_ptr<AlbumFaces> album_faces_;
    StartSession start_;
    std::unique_ptr<Browsing> browsing_;
    std::unique_ptr<ExploreSession> explore_;
    std::unique_ptr<Caring> caring_;
    std::unique_ptr<Capturing> capturing_;
    std::unique_ptr<MendSession> mend_;
    std::unique_ptr<PrintSession> print_;
    std::unique_ptr<LabSession> lab_;
    std::unique_ptr<StudySession> study_;
    std::unique_ptr<SettingsSession> settings_;
};

} // namespace tp
