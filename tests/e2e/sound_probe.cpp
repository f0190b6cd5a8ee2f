// SPDX-License-Identifier: Apache-2.0
// The real recorder and player for the script beside it.
//   sound_probe record FOLDER       until a line comes in; then the file's name, its seconds and its gain
//   sound_probe play SPEED FILE…    until the list has ended
//   sound_probe hurry ROUNDS        sounds that are begun in the moment in which another one ends
// Each change of state and each sentence is one line.
#include "audio/sound/player.hpp"
#include "audio/sound/recorder.hpp"
#include "audio/sound/sound_format.hpp"
#include "audio/sound/sound_source.hpp"
#include "audio/sound/system_loudspeaker.hpp"
#include "audio/sound/threaded_filler.hpp"

#include <QCoreApplication>
#include <QMetaEnum>
#include <QSocketNotifier>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <semaphore>
#include <span>
#include <string>
#include <thread>
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

/// Silence. One that ends holds its output there, in `heard` of its last frame, until `go_on`.
class Silence final : public SoundSource {
public:
    explicit Silence(std::size_t samples = std::numeric_limits<std::size_t>::max()) : left_(samples) {}

    std::size_t pull(std::span<float> samples) override {
        const std::size_t got = std::min(left_, samples.size());
        std::fill_n(samples.begin(), got, 0.0F);
        left_ -= got;
        pulled_ += got;
        return got;
    }
    void heard(std::int64_t frames) override {
        if (left_ > 0 || frames < static_cast<std::int64_t>(pulled_ / played_channels))
            return;
        at_its_end.release();
        go_on.acquire();
    }
    std::size_t pulled() const { return pulled_; }

    std::counting_semaphore<> at_its_end{0}, go_on{0};

private:
    std::size_t left_; ///< only the output's thread
    std::atomic<std::size_t> pulled_ = 0;
};

constexpr std::chrono::seconds patience(60); // on a busy machine

template <typename Condition>
bool comes_true(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!condition() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return condition();
}

bool plays_on(const Silence& sound) {
    constexpr std::size_t some = sound_rate / 5 * played_channels;
    return comes_true([&, before = sound.pulled()] { return sound.pulled() >= before + some; });
}

int hurry(int rounds) {
    std::shared_ptr<Silence> ending, next;
    const auto is_let_go = [](const std::shared_ptr<Silence>& sound) {
        return comes_true([&] { return sound.use_count() == 1; });
    };
    {
        SystemLoudspeaker loudspeaker;
        quint64 run = 0;
        for (int round = 1; round <= rounds; ++round) {
            ending = std::make_shared<Silence>(sound_rate / 10 * played_channels);
            next = std::make_shared<Silence>();
            loudspeaker.start(++run, ending);
            if (!ending->at_its_end.try_acquire_for(patience))
                return print(QString("round %1: a sound does not end").arg(round)), 1;
            loudspeaker.start(++run, next);
            ending->go_on.release(2); // it may be told its last frame twice
            if (!plays_on(*next))
                return print(QString("round %1: the next sound does not play on").arg(round)), 1;
            if (!is_let_go(ending))
                return print(QString("round %1: a sound that ended is kept").arg(round)), 1;
        }
    }
    if (!is_let_go(next))
        return print("a sound outlives its loudspeaker"), 1;
    print(QString("rounds %1").arg(rounds));
    return 0;
}

int result_of(const std::string& verb, char** words) {
    if (verb == "record")
        return record(words[0]);
    if (verb == "play")
        return play(std::stod(words[0]), words + 1);
    return hurry(std::stoi(words[0]));
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    const std::string verb = argc > 2 ? argv[1] : "";
    if (verb != "record" && verb != "hurry" && (verb != "play" || argc < 4)) {
        std::fputs("sound_probe record FOLDER | play SPEED FILE… | hurry ROUNDS\n", stderr);
        return 2;
    }
    const int status = result_of(verb, argv + 2);
    // Qt 6.4 takes down its connection to PulseAudio, after main(), without the lock that libpulse wants,
    // which aborts where a message arrives meanwhile.
    std::_Exit(status);
}
