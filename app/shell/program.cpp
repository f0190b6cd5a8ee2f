// SPDX-License-Identifier: Apache-2.0
#include "app/shell/program.hpp"

#include <QQmlEngine>

#include <utility>

namespace tp {

namespace {

Narrator::By by(Choices::Voice voice) {
    switch (voice) {
    case Choices::Voice::program: return Narrator::By::voice;
    case Choices::Voice::screen_reader: return Narrator::By::screen_reader;
    case Choices::Voice::off: return Narrator::By::nobody;
    }
    return Narrator::By::voice;
}

} // namespace

Program::Program(ProgramParts parts)
    : parts_(std::move(parts)), preferences_(parts_.preferences), narrator_(parts_.voice, announcer_),
      earcons_(parts_.earcon_output), guide_(parts_.guide_output, vibration_), shell_(narrator_), start_(narrator_, preferences_, parts_.find_devices) {
    follow_choices();
    connect(&preferences_, &Preferences::changed, this, &Program::follow_choices);
    connect(&preferences_, &Preferences::not_kept, this,
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
    album_.reset();
    if (discard_index_)
        AlbumIndex::discard(parts_.cache);
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
    emit appearanceChanged();
}

void Program::add_pages() {
    const auto open = [this](const QString& page) { shell_.open(page); };
    shell_.add({"start", [] { return tr("TouchPhoto"); }, [this] { start_.enter(); }, [this] { start_.leave(); }});
    shell_.add({"explore", [] { return tr("Feel a face"); }, [this] { explore().enter(); }, [this] { explore().leave(); }});
    shell_.add({"settings", [] { return tr("Settings"); }, [this] { settings().enter(); }, [this] { settings().leave(); }});
    connect(&start_, &StartSession::pageAsked, this, open);
}

QVariantMap Program::page_files() {
    const auto file = [](const char* path) { return QString("qrc:/qt-project.org/imports/TouchPhoto/") + path; };
    return {{"start", file("Start/StartPage.qml")},
            {"explore", file("Explore/ExplorePage.qml")},
            {"settings", file("Settings/SettingsPage.qml")}};
}

QObject* Program::session(const QString& page) {
    QObject* session = &start_;
    if (page == "explore")
        session = &explore();
    else if (page == "settings")
        session = &settings();
    QQmlEngine::setObjectOwnership(session, QQmlEngine::CppOwnership); // what an invokable returns is else the engine's
    return session;
}

OpenAlbum& Program::album() {
    if (!album_) {
        album_ = std::make_unique<OpenAlbum>(parts_.cache, preferences_);
        connect(album_.get(), &OpenAlbum::said, this,
                [this](const QString& sentence) { narrator_.tell(sentence, Priority::message); });
    }
    return *album_;
}

ExploreSession& Program::explore() {
    if (!explore_) {
        explore_ = std::make_unique<ExploreSession>(narrator_, earcons_, guide_, preferences_, parts_.explore);
        connect(explore_.get(), &ExploreSession::backAsked, &shell_, &Shell::back);
    }
    return *explore_;
}

SettingsSession& Program::settings() {
    if (!settings_) {
        settings_ = std::make_unique<SettingsSession>(
            narrator_, preferences_,
            SettingsSession::Stored{parts_.preferences, parts_.cache, [this] { discard_index_ = true; }});
        connect(settings_.get(), &SettingsSession::pageAsked, &shell_, &Shell::open);
        connect(settings_.get(), &SettingsSession::questionsAsked, this, [this] {
            shell_.goHome();
            start_.askAgain();
        });
    }
    return *settings_;
}

void Program::begin(const QString& photo) {
    earcons_.play(Earcon::program_start);
    if (photo.isEmpty()) {
        shell_.goHome();
    } else {
        explore().open_file(photo);
        shell_.open("explore");
    }
    if (!preferences_.notice().isEmpty())
        narrator_.tell(preferences_.notice(), Priority::message);
}

} // namespace tp
