// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/camera/stand_in_camera.hpp"
#include "app/parts/devices/device_access.hpp"
#include "app/shell/program_window.hpp"
#include "audio/speech/recording_voice.hpp"
#include "fake_loudspeaker.hpp"
#include "fake_microphone.hpp"
#include "page_window.hpp"
#include "places.hpp"

#include <QDir>
#include <QFile>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>
#include <QtGlobal>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// The program with everything but the machine: its voice is remembered, its loudspeakers and its microphone
/// are the test's, its camera looks into a photograph, its album is a folder of sample portraits; of somebody who has not been asked yet it has
/// none. Its home lies in its own folder, so that nothing is found, read or written in that of whoever runs
/// the test.
class WholeProgram {
public:
    explicit WholeProgram(const tp::Choices& choices = asked(), tp::DeviceAccess devices = {}) {
        qputenv("HOME", QFile::encodeName(folder.filePath("Home")));
        for (const char* elsewhere :
             {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_PICTURES_DIR"})
            qunsetenv(elsewhere);
        for (const char* made : {"Family", "Home"})
            QDir().mkpath(folder.filePath(made));
        for (const char* name : photographs)
            QFile::copy(QString(tp::test::in_source("resources/samples/")) + name,
                        folder.filePath(QString("Family/") + name));
        tp::Choices with_album = choices;
        if (choices.asked)
            with_album.folders = {folder.filePath("Family")};
        {
            tp::Preferences kept(file("preferences.json"));
            kept.set(with_album);
        }
        tp::ProgramParts parts{voice,
                               [this] {
                                   auto made = std::make_unique<tp::testing::FakeLoudspeaker>();
                                   loudspeakers.push_back(made.get());
                                   return made;
                               },
                               [this] {
                                   auto made = std::make_unique<tp::testing::FakeMicrophone>();
                                   made->there = microphone_there;
                                   microphone = made.get();
                                   return made;
                               },
                               file("preferences.json"),
                               file("cache"),
                               file("Documents"),
                               {},
                               [] { return std::vector<tp::FoundDevice>(); }};
        parts.explore.devices = std::move(devices);
        parts.make_camera = [photo = file("Family/anna_smiling.jpg")] {
            return std::make_unique<tp::StandInCamera>(tp::StandInCamera::Of::photo, photo);
        };
        program = std::make_unique<tp::Program>(std::move(parts));
        program->begin({});
        window = std::make_unique<tp::ProgramWindow>(*program);
    }
    ~WholeProgram() {
        window.reset();
        program.reset();
    }

    static tp::Choices asked() {
        tp::Choices choices;
        choices.asked = true;
        choices.language = "en";
        return choices;
    }
    /// Its window is in sight and has the keyboard.
    bool shown() {
        window->show();
        window->requestActivate();
        return QTest::qWaitForWindowExposed(window.get());
    }
    /// Its album is read, no photograph is searched for faces any more, and all of the page is made.
    bool complete() const {
        return !program->album().scanning() &&
               program->explore().view()->state() != tp::ExploreView::State::Looking &&
               PageWindow::complete(*window->contentItem());
    }
    /// Whether a photograph of the album was there from the beginning.
    static bool came_with(const std::string& name) { return std::ranges::count(photographs, name) > 0; }
    std::filesystem::path file(const char* name) const { return folder.filePath(name).toStdString(); }
    /// Nobody chose a folder outside of what is made here.
    bool keeps_to_its_folder() const {
        const QStringList& folders = program->preferences().choices().folders;
        return std::all_of(folders.begin(), folders.end(), [this](const QString& one) {
            return (one + '/').startsWith(folder.path() + '/');
        });
    }
    tp::Shell& shell() { return program->shell(); }

    QTemporaryDir folder;
    bool microphone_there = true; ///< for what is recorded first
    tp::RecordingVoice voice;
    std::vector<tp::testing::FakeLoudspeaker*> loudspeakers; ///< in the order in which they were asked for
    std::atomic<tp::testing::FakeMicrophone*> microphone{nullptr}; ///< on the recorder's thread
    std::unique_ptr<tp::Program> program;
    std::unique_ptr<tp::ProgramWindow> window;

private:
    static constexpr std::array photographs{"anna_smiling.jpg", "ben_and_clara.jpg", "ben_smiling.jpg"};
};
