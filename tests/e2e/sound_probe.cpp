// SPDX-License-Identifier: Apache-2.0
// The real recorder and player for the script beside it.
//   sound_probe record FOLDER       until a line comes in; then the file's name, its seconds and its gain
//   sound_probe play SPEED FILE…    until the list has ended
// Each change of state and each sentence is one line.
#include "audio/sound/player.hpp"
#include "audio/sound/recorder.hpp"
#include "audio/sound/system_loudspeaker.hpp"
#include "audio/sound/threaded_filler.hpp"

#include <QCoreApplication>
#include <QMetaEnum>
#include <QSocketNotifier>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <unistd.h>

using namespace tp;

namespace {

void print(const QString& line) {
    std::puts(qPrintable(line));
    std::fflush(stdout);
}

int record(const char* folder) {
    Recorder recorder(system_microphone);
    QObject::connect(&recorder, &Recorder::state_changed,
                     [&recorder] { print(QString("state %1").arg(static_cast<int>(recorder.state()))); });
    QObject::connect(&recorder, &Recorder::said, [](const QString& sentence) { print("said " + sentence); });
    QObject::connect(&recorder, &Recorder::failed, [](const QString& sentence) {
        print("failed " + sentence);
        QCoreApplication::exit(1);
    });
    QObject::connect(&recorder, &Recorder::done, [](const FinishedRecording& recording) {
        print(QString("done %1 %2 %3")
                  .arg(recording.duration_s)
                  .arg(recording.gain_db)
                  .arg(QString::fromStdString(recording.file.string())));
        QCoreApplication::exit(0);
    });
    QSocketNotifier line(STDIN_FILENO, QSocketNotifier::Read);
    QObject::connect(&line, &QSocketNotifier::activated, [&] {
        line.setEnabled(false);
        recorder.finish();
    });
    RecordingPlan plan;
    plan.folder = folder;
    recorder.start(plan);
    return QCoreApplication::exec();
}

int play(double speed, char** files) {
    SystemLoudspeaker loudspeaker;
    ThreadedFiller filler;
    Player player(loudspeaker, filler);
    QObject::connect(&player, &Player::state_changed, [&player] {
        print(QString("state %1")
                  .arg(QMetaEnum::fromType<Player::State>().valueToKey(static_cast<int>(player.state()))));
    });
    QObject::connect(&player, &Player::said, [](const QString& sentence) { print("said " + sentence); });
    QObject::connect(&player, &Player::began,
                     [](std::size_t index) { print(QString("began %1").arg(index)); });
    QObject::connect(&player, &Player::ended,
                     [](std::size_t index) { print(QString("ended %1").arg(index)); });
    QObject::connect(&player, &Player::list_end, [] { QCoreApplication::exit(0); });
    std::vector<PlayItem> list;
    for (; *files != nullptr; ++files)
        list.emplace_back().file = *files;
    player.set_list(std::move(list));
    player.set_speed(speed);
    player.play();
    return QCoreApplication::exec();
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    const std::string verb = argc > 2 ? argv[1] : "";
    if (verb != "record" && (verb != "play" || argc < 4)) {
        std::fputs("sound_probe record FOLDER | play SPEED FILE…\n", stderr);
        return 2;
    }
    const int status = verb == "record" ? record(argv[2]) : play(std::stod(argv[2]), argv + 3);
    // Qt 6.4 takes down its connection to PulseAudio, after main(), without the lock that libpulse wants,
    // which aborts where a message arrives meanwhile.
    std::_Exit(status);
}
