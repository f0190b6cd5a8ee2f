// SPDX-License-Identifier: Apache-2.0
#include "app/shell/program.hpp"

#include "app/capture/camera/system_camera.hpp"
#include "app/capture/seeing/aim_eye.hpp"
#include "app/capture/seeing/face_namer.hpp"
#include "app/shell/few_heaps.hpp"
#include "app/shell/heard_ticks.hpp"
#include "audio/sound/player.hpp"
#include "audio/sound/recorder.hpp"
#include "audio/sound/threaded_filler.hpp"
#include "core/files/file_name.hpp"
#include "core/servo/clock.hpp"

#include <QEventLoop>
#include <QFileInfo>
#include <QQmlEngine>
#include <QTimer>
#include <QUrl>

#include <chrono>
#include <utility>

namespace tp {

namespace {

constexpr std::chrono::seconds open_album_after{1}; ///< when the page is there
constexpr std::chrono::seconds told_of_keeping_after{1};
constexpr int names_wait_ms = 100; ///< for the languages of names, which a page's first sentence may have

Narrator::By by(Choices::Voice voice) {
    switch (voice) {
    case Choices::Voice::program:
        return Narrator::By::voice;
    case Choices::Voice::screen_reader:
        return Narrator::By::screen_reader;
    case Choices::Voice::off:
        return Narrator::By::nobody;
    }
    return Narrator::By::voice;
}

FrameLook look_with_an_eye(const std::shared_ptr<const KnownPeople>& people) {
    auto eye = std::make_shared<AimEye>();
    eye->name_by([namer = std::make_shared<FaceNamer>(people)](const cv::Mat& frame, const Face& face) {
        return namer->name(frame, face);
    });
    return [eye](const CameraFrame& frame) { return eye->see(frame); };
}

} // namespace

/// Recordings heard on a page.
struct Program::Playing {
    explicit Playing(const ProgramParts& parts) : output(parts.make_loudspeaker()) {}
    std::unique_ptr<SoundOutput> output;
    ThreadedFiller filler;
    Player player{*output, filler};
};

struct Program::Browsing {
    explicit Browsing(Program& program)
        : playing(program.parts_), session(program.album(), program.narrator_, program.earcons_,
                                           playing.player, program.preferences_) {}
    Playing playing;
    BrowseSession session;
};

struct Program::Caring {
    explicit Caring(Program& program)
        : playing(program.parts_), recorder(program.parts_.make_microphone),
          session(program.album(), program.album_faces(), program.narrator_, program.earcons_, recorder,
                  playing.player, program.preferences_) {}
    Playing playing;
    Recorder recorder;
    CareSession session;
};

struct Program::Capturing {
    explicit Capturing(Program& program)
        : recorder(program.parts_.make_microphone), moment(program.parts_.make_microphone),
          session(
              program.narrator_, program.earcons_, program.guide_, recorder, moment, program.preferences_,
              {program.parts_.make_camera ? program.parts_.make_camera() : std::make_unique<SystemCamera>(),
               [people = people] { return look_with_an_eye(people); },
               [&program] { return program.folder_for_photographs(); }, people, program.touch()}) {}
    std::shared_ptr<KnownPeople> people = std::make_shared<KnownPeople>();
    bool knows_people = false; ///< the album tells them
    Recorder recorder;
    MomentRecorder moment;
    CaptureSession session;
};

Program::Program(ProgramParts parts)
    : parts_(std::move(parts)), preferences_(parts_.preferences), narrator_(parts_.voice, announcer_),
      voice_names_(parts_.voice, preferences_), earcon_output_(parts_.make_loudspeaker()),
      earcons_(*earcon_output_), guide_output_(parts_.make_loudspeaker()), guide_(*guide_output_),
      shell_(narrator_), start_(narrator_, preferences_, parts_.find_devices) {
    keep_few_heaps();
    follow_choices();
    connect(&preferences_, &Preferences::changed, this, &Program::follow_choices);
    connect(&preferences_, &Preferences::not_kept, this,
            [this](const QString& sentence) { narrator_.tell(sentence, Priority::message); });
    connect(&voice_names_, &VoiceNames::said, this,
            [this](const QString& sentence) { narrator_.tell(sentence, Priority::message); });
    connect(&shell_, &Shell::voice_toggled, this, [this](bool on) {
        parts_.by.reset(); // the person has a wish of their own now
        preferences_.change([on](Choices& choices) {
            choices.voice = on ? Choices::Voice::program : Choices::Voice::screen_reader;
        });
    });
    add_pages();
}

Program::~Program() {
    keep_all();
    capturing_.reset();
    caring_.reset();
    browsing_.reset();
    looks_.reset();
    album_faces_.reset();
    album_.reset();
    if (discard_index_)
        AlbumIndex::discard(parts_.cache);
}

bool Program::keeping() const {
    return (caring_ && caring_->session.keeping()) || (capturing_ && capturing_->session.keeping());
}

void Program::keep_all() {
    shell_.leave();
    QEventLoop wait;
    // Queued: what ends may ask for the step that comes next.
    connect(this, &Program::kept, &wait, &QEventLoop::quit, Qt::QueuedConnection);
    QTimer::singleShot(told_of_keeping_after, &wait, [this] {
        narrator_.tell(tr("Still saving. TouchPhoto closes when everything is saved."), Priority::message);
    });
    while (keeping())
        wait.exec(QEventLoop::ExcludeUserInputEvents);
}

void Program::follow_choices() {
    const Choices& choices = preferences_.choices();
    const QString before = languages_.current();
    languages_.use(choices.language);
    narrator_.set_by(parts_.by.value_or(by(choices.voice)));
    parts_.voice.set_rate(speech_rate(choices.rate));
    earcons_.set_on(choices.earcons);
    if (before != languages_.current()) {
        parts_.voice.set_language(languages_.current());
        emit language_changed();
        shell_.retranslated();
    }
    look_as_chosen();
    emit appearanceChanged();
}

void Program::add_pages() {
    const auto open = [this](const QString& page) { shell_.open(page); };
    shell_.add(
        {"start", [] { return tr("TouchPhoto"); }, [this] { enter_start(); }, [this] { start_.leave(); }});
    shell_.add({"browse", [] { return tr("Listen to photographs"); },
                [this] {
                    browse().enter();
                    news_told();
                },
                [this] { browse().leave(); }});
    shell_.add({"explore", [] { return tr("Feel a face"); }, [this] { enter_explore(); },
                [this] { explore().leave(); }});
    shell_.add({"care", [] { return tr("Look after the album"); }, [this] { care().enter(); },
                [this] { care().leave(); }});
    shell_.add({"capture", [] { return tr("Take a photograph"); },
                [this] {
                    capture().enter();
                    QTimer::singleShot(album_ ? std::chrono::seconds{0} : open_album_after, this,
                                       &Program::know_people_before_camera);
                },
                [this] { capture().leave(); }});
    shell_.add(
        {"mend", [] { return tr("Mend contours"); }, [this] { mend().enter(); }, [this] { mend().leave(); }});
    shell_.add({"print", [] { return tr("Print a tactile sheet"); }, [this] { print().enter(); },
                [this] { print().leave(); }});
    shell_.add({"lab", [] { return tr("Lab"); }, [this] { lab().enter(); }, [this] { lab().leave(); }});
    shell_.add(
        {"study", [] { return tr("Studies"); }, [this] { study().enter(); }, [this] { study().leave(); }});
    shell_.add({"settings", [] { return tr("Settings"); }, [this] { settings().enter(); },
                [this] { settings().leave(); }});
    connect(&start_, &StartSession::pageAsked, this, open);
}

QVariantMap Program::page_files() {
    const auto file = [](const char* path) {
        return QString("qrc:/qt-project.org/imports/TouchPhoto/") + path;
    };
    return {{"start", file("Start/StartPage.qml")},       {"browse", file("Browse/BrowsePage.qml")},
            {"explore", file("Explore/ExplorePage.qml")}, {"care", file("Care/CarePage.qml")},
            {"capture", file("Capture/CapturePage.qml")}, {"mend", file("Mend/MendPage.qml")},
            {"print", file("Print/PrintPage.qml")},       {"lab", file("Lab/LabPage.qml")},
            {"study", file("Study/StudyPage.qml")},       {"settings", file("Settings/SettingsPage.qml")}};
}

QObject* Program::session(const QString& page) {
    QObject* session = &start_;
    if (page == "browse")
        session = &browse();
    else if (page == "explore")
        session = &explore();
    else if (page == "care")
        session = &care();
    else if (page == "capture")
        session = &capture();
    else if (page == "mend")
        session = &mend();
    else if (page == "print")
        session = &print();
    else if (page == "lab")
        session = &lab();
    else if (page == "study")
        session = &study();
    else if (page == "settings")
        session = &settings();
    QQmlEngine::setObjectOwnership(
        session, QQmlEngine::CppOwnership); // what an invokable returns is else the engine's
    return session;
}

void Program::show_looked(const std::filesystem::path& photo) {
    if (browsing_)
        browsing_->session.trail()->looked_at(photo);
    if (caring_)
        caring_->session.draft()->looked_at(photo);
}

BrowseSession& Program::browse() {
    if (!browsing_) {
        browsing_ = std::make_unique<Browsing>(*this);
        connect(browsing_->session.trail(), &BrowseTrail::shown_anew, this, [this] {
            const BrowseTrail& trail = *browsing_->session.trail();
            if (trail.here() && !trail.seen())
                looks_->want(trail.shown());
        });
        connect(&browsing_->session, &BrowseSession::exploreAsked, this, &Program::feel);
        connect(&browsing_->session, &BrowseSession::careAsked, this, &Program::care_for);
        connect(&browsing_->session, &BrowseSession::settingsAsked, this,
                [this] { shell_.open("settings"); });
        connect(&browsing_->session, &BrowseSession::importAsked, this, [this] { shell_.open("care"); });
    }
    return browsing_->session;
}

CareSession& Program::care() {
    if (!caring_) {
        caring_ = std::make_unique<Caring>(*this);
        connect(&caring_->session, &CareSession::photoChanged, this, [this] {
            if (!caring_->session.photo().empty())
                looks_->want(caring_->session.photo());
        });
        connect(&caring_->session, &CareSession::keepingChanged, this, &Program::kept);
        connect(&caring_->session, &CareSession::nameLanguagesRead, &voice_names_, &VoiceNames::know);
        connect(&caring_->session, &CareSession::mendAsked, this, [this](const QString& photo) {
            mend().open_file(photo);
            shell_.open("mend");
        });
        connect(&caring_->session, &CareSession::printAsked, this, [this](const QString& photo) {
            print().open_photo(path_named(photo.toStdString()));
            shell_.open("print");
        });
    }
    return caring_->session;
}

CaptureSession& Program::capture() {
    if (!capturing_) {
        capturing_ = std::make_unique<Capturing>(*this);
        connect(&capturing_->session, &CaptureSession::keepingChanged, this, &Program::kept);
        connect(&capturing_->session, &CaptureSession::importAsked, this, [this] { shell_.open("care"); });
        connect(&capturing_->session, &CaptureSession::touched, this,
                [this](const std::filesystem::path& photo) { album().touched(photo); });
    }
    return capturing_->session;
}

/// When the page is there: an album that is opened takes its time.
void Program::know_people_before_camera() {
    if (preferences_.choices().folders.isEmpty() || std::exchange(capturing_->knows_people, true))
        return;
    connect(&album_faces(), &AlbumFaces::named, this,
            [people = capturing_->people](const std::vector<NamedFaces>& named) { people->know(named); });
    album_faces().want_named();
}

MendSession& Program::mend() {
    if (!mend_)
        mend_ = std::make_unique<MendSession>(narrator_);
    return *mend_;
}

PrintSession& Program::print() {
    if (!print_)
        print_ = std::make_unique<PrintSession>(narrator_, earcons_, parts_.documents);
    return *print_;
}

void Program::feel(const QString& photo) {
    last_at_explore_ = preferences_.choices().last_photo;
    explore().open_file(photo);
    shell_.open("explore");
}

void Program::care_for(const QString& photo) {
    care().open_photo(path_named(photo.toStdString()));
    shell_.open("care");
}

/// The album is opened when the page is there: what is new in it is told.
void Program::enter_start() {
    start_.enter();
    if (!album_ && preferences_.choices().asked && !preferences_.choices().folders.isEmpty())
        QTimer::singleShot(open_album_after, this, [this] { album(); });
}

/// Where none is open, or one went on to another photograph meanwhile: the one that one was at last; where there is none,
/// the newest with a face.
void Program::enter_explore() {
    const bool none = explore().view()->state() == ExploreView::State::Empty;
    const QString last = preferences_.choices().last_photo;
    if ((none || std::exchange(last_at_explore_, last) != last) && QFileInfo::exists(last))
        explore().open_file(last);
    else if (none)
        explore().walk()->newest();
    explore().enter();
}

/// Where one is in the album is one place for all pages.
void Program::remember_felt() {
    if (!explore_->device()->here())
        return;
    const QString file = explore_->view()->file();
    const auto in_album = [&] {
        const auto known = album().queries().find(path_named(file.toStdString()));
        return known && *known;
    };
    if (!file.isEmpty() && file != preferences_.choices().last_photo &&
        !preferences_.choices().folders.isEmpty() && in_album())
        preferences_.change([&](Choices& choices) { choices.last_photo = file; });
    last_at_explore_ = preferences_.choices().last_photo;
}

TouchAccess Program::touch() {
    if (!parts_.make_touch)
        return {};
    if (!clicks_) {
        click_output_ = parts_.make_loudspeaker();
        clicks_ = std::make_unique<ClickSound>(*click_output_, [] { return SteadyClock().now(); });
    }
    return parts_.make_touch(std::make_shared<HeardTicks>(*clicks_));
}

ExploreSession& Program::explore() {
    if (!explore_) {
        ExploreSettings settings = parts_.explore;
        settings.touch = touch();
        settings.beside = [this](const QString& file, bool forward) { return beside(file, forward); };
        explore_ =
            std::make_unique<ExploreSession>(narrator_, earcons_, guide_, preferences_, std::move(settings));
        connect(explore_.get(), &ExploreSession::backAsked, &shell_, &Shell::back);
        connect(explore_->view(), &ExploreView::fresh, this, &Program::remember_felt);
    }
    return *explore_;
}

SettingsSession& Program::settings() {
    if (!settings_) {
        settings_ = std::make_unique<SettingsSession>(
            narrator_, preferences_,
            StorageSettings::Stored{parts_.preferences, parts_.cache, [this] { discard_index_ = true; }},
            DeviceSettings::Setup{parts_.explore.devices, parts_.explore.device_servo, {}},
            TickSettings::Setup{touch(), {}, TapTest::pause_before});
        connect(settings_.get(), &SettingsSession::pageAsked, &shell_, &Shell::open);
        connect(settings_.get(), &SettingsSession::questionsAsked, this, [this] {
            shell_.goHome();
            start_.askAgain();
        });
    }
    return *settings_;
}

void Program::open_page(const QString& page) {
    voice_names_.settle(names_wait_ms);
    const QString& last = preferences_.choices().last_photo;
    if (page == "care" && !last.isEmpty())
        return care_for(last);
    if (page == "mend" && !last.isEmpty())
        mend().open_file(last);
    if (page == "print" && !last.isEmpty())
        print().open_photo(path_named(last.toStdString()));
    shell_.open(page);
}

void Program::tell_focus(const QString& words) {
    if (narrator_.voice_on())
        narrator_.tell(words, Priority::touch);
}

void Program::begin(const QString& file) {
    earcons_.play(Earcon::program_start);
    if (file.isEmpty()) {
        shell_.goHome();
    } else if (file.endsWith(".touchphoto", Qt::CaseInsensitive)) {
        shell_.open("care");
        care().importing()->import({QUrl::fromLocalFile(QFileInfo(file).absoluteFilePath())});
    } else {
        feel(file);
    }
    if (!preferences_.notice().isEmpty())
        narrator_.tell(preferences_.notice(), Priority::message);
}

} // namespace tp
