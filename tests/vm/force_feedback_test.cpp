// SPDX-License-Identifier: Apache-2.0
// In the virtual machine: ticks through the kernel's own force feedback, to a motor that a program is (uinput) and to a game pad
// whose driver leaves the time of an effect to the kernel (ff-memless).
#include "device/touch_output/touch_registry.hpp"
#include "ticking_program.hpp"
#include "touch_bench.hpp"
#include "uinput_motor.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <memory>
#include <sys/ioctl.h>
#include <utility>

using namespace tp;
using namespace tp::vm;
using Happening = UinputMotor::Happening;

namespace {

constexpr const char* strip = "Haptic strip";
constexpr double at_once = 0.02;     ///< s, in which the kernel and a program here answer each other, at most
constexpr double of_a_timer = 0.008; ///< s, by which the kernel's timers are late, at most
constexpr double slow = 0.2;         ///< s

/// A motor that plays waves, and its name in the registry.
struct Strip {
    explicit Strip(unsigned places = 16) : motor(strip, {FF_PERIODIC, FF_SINE, FF_RUMBLE}, places) {
        comes_true([this] { return !(name = find()).empty(); }, 10.0);
    }
    static std::string find() {
        for (const ListedTouchOutput& listed : list_touch_outputs())
            if (listed.about == strip && listed.means == TouchMeans::ticks)
                return listed.name;
        return {};
    }
    std::unique_ptr<TouchOutput> output() const {
        auto made = touch_output_named(name);
        return made.ok() ? std::move(made).value() : nullptr;
    }
    std::string node() const { return name.substr(name.find('/')); }
    bool comes(Happening what, int times) const {
        return comes_true([&] { return motor.count(what) >= times; }, 10.0);
    }

    UinputMotor motor;
    std::string name;
};

/// A node as another program has it open.
class OtherProgram {
public:
    explicit OtherProgram(const std::string& node) : file_(::open(node.c_str(), O_RDWR | O_CLOEXEC)) {}
    ~OtherProgram() { ::close(file_); }
    OtherProgram(const OtherProgram&) = delete;
    OtherProgram& operator=(const OtherProgram&) = delete;
    bool grab() const { return ::ioctl(file_, EVIOCGRAB, 1UL) == 0; }
    bool take_a_place() const {
        ff_effect effect{};
        effect.type = FF_PERIODIC;
        effect.id = -1;
        effect.u.periodic.waveform = FF_SINE;
        return ::ioctl(file_, EVIOCSFF, &effect) == 0;
    }

private:
    int file_;
};

/// The game pad, and what its motors did.
class GamePad {
public:
    GamePad() : log((folder_.path() + "/log").toStdString()) {
        pad_.setProcessChannelMode(QProcess::ForwardedChannels);
        pad_.start(QCoreApplication::applicationDirPath() + "/vm_virtual_game_pad",
                   {folder_.path() + "/log"});
        tell('p');
    }
    ~GamePad() {
        pad_.closeWriteChannel();
        pad_.waitForFinished(-1);
    }
    GamePad(const GamePad&) = delete;
    GamePad& operator=(const GamePad&) = delete;

    static constexpr const char* name = "motor:GP-0001";

    /// A letter to it, as serve() has them.
    void tell(char letter) {
        pad_.write(&letter, 1);
        pad_.waitForBytesWritten(-1);
    }
    bool shakes() const { return log.size() > 0 && length(log[log.size() - 1].force) > 0.0; }
    bool begins_to_shake() const {
        return comes_true([this] { return shakes(); }, 30.0);
    }
    std::unique_ptr<TouchOutput> output() const {
        std::unique_ptr<TouchOutput> found;
        comes_true(
            [&found] {
                auto made = touch_output_named(name);
                if (made.ok())
                    found = std::move(made).value();
                return found != nullptr;
            },
            10.0);
        return found;
    }

private:
    QTemporaryDir folder_; // before the log, which lies in it

public:
    SharedLog<DeviceSample> log;

private:
    QProcess pad_;
};

} // namespace

class ForceFeedbackVmTest : public QObject {
    Q_OBJECT
private slots:
    void a_tick_is_kept_played_and_ended() {
        const Strip bed;
        QVERIFY(bed.motor.good());
        const auto output = bed.output();
        QVERIFY(output);
        const auto can = output->open();
        QVERIFY2(can.ok(), can.ok() ? "" : can.error().c_str());
        QVERIFY(bed.comes(Happening::kept, 1));
        QCOMPARE(bed.motor.count(Happening::began), 0);
        const double told = now();
        QVERIFY(output->tick(Tick(0.5, 1.0, 0.03)));
        QVERIFY(bed.comes(Happening::began, 1));
        const auto kept = bed.motor.last(Happening::kept);
        const auto began = bed.motor.last(Happening::began);
        say("from a tick to the motor", 1e3 * (began->time - told));
        QVERIFY(began->time - told < at_once);
        QCOMPARE(began->id, kept->id);
        QCOMPARE(int(kept->effect.type), FF_PERIODIC);
        QCOMPARE(int(kept->effect.u.periodic.waveform), FF_SINE);
        QCOMPARE(int(kept->effect.u.periodic.magnitude), 16384);
        QCOMPARE(int(kept->effect.u.periodic.period), 4);
        QCOMPARE(int(kept->effect.replay.length), 30);
        output->halt();
        QVERIFY(bed.comes(Happening::ended, 1));
        output->stop();
        QVERIFY(bed.comes(Happening::forgotten, 1));
        QCOMPARE(bed.motor.last(Happening::forgotten)->id, kept->id);
    }

    void of_a_program_that_is_killed_the_kernel_ends_and_forgets_it() {
        const Strip bed;
        TickingProgram program(strip);
        QVERIFY(program.ticks());
        QVERIFY(bed.comes(Happening::began, 5));
        const double killed = now();
        program.kill();
        QVERIFY(bed.comes(Happening::forgotten, 1));
        const auto ended = bed.motor.last(Happening::ended);
        QVERIFY(ended);
        say("ended after", 1e3 * (ended->time - killed));
        QVERIFY(ended->time >= killed && ended->time - killed < at_once);
        QVERIFY(bed.motor.last(Happening::began)->time < ended->time);
    }

    void unplugged_in_mid_touch_is_said() {
        Strip bed;
        TickingProgram program(strip);
        QVERIFY(program.ticks());
        QVERIFY(bed.comes(Happening::began, 5));
        bed.motor.unplug();
        QCOMPARE(program.ended(), 3);
        QCOMPARE(program.said(), QString("The Haptic strip was unplugged. Plug it in again.\n"));
        QVERIFY(Strip::find().empty());
    }

    void a_motor_that_takes_its_time_holds_up_nobody() {
        Strip bed;
        const auto output = bed.output();
        QVERIFY(output && output->open().ok());
        bed.motor.be_slow(slow);
        for (int i = 0; i < 10; ++i) {
            const double told = now();
            QVERIFY(output->tick(Tick(0.1 * (i + 1), 0.5, 0.01)));
            QVERIFY(now() - told < 2.0 * tick);
            pass(0.05);
        }
        QVERIFY(bed.comes(Happening::kept, 3));
        pass(2.0 * slow);
        QCOMPARE(bed.motor.count(Happening::began), 0); // each would have come too late
        QVERIFY(output->complaint().find("too slowly") != std::string::npos);
        const double halted = now();
        output->halt();
        QVERIFY(now() - halted < 2.0 * tick);
    }

    void what_another_program_has_to_itself_is_said() {
        const Strip bed;
        const auto output = bed.output();
        QVERIFY(output);
        {
            const OtherProgram other(bed.node());
            QVERIFY(other.grab());
            const auto can = output->open();
            QVERIFY(!can.ok());
            QCOMPARE(can.error(),
                     std::string("Another program uses the Haptic strip. Close that program and try again."));
        }
        QVERIFY(output->open().ok());
    }

    void a_table_that_another_program_has_filled_is_said() {
        const Strip bed(1);
        const auto output = bed.output();
        QVERIFY(output);
        {
            const OtherProgram other(bed.node());
            QVERIFY(other.take_a_place());
            const auto can = output->open();
            QVERIFY(!can.ok());
            QCOMPARE(can.error(),
                     std::string("Other programs use all that the Haptic strip can play. Close them "
                                 "and try again."));
        }
        QVERIFY(output->open().ok());
    }

    void two_programs_that_tell_ticks_do_not_touch_each_other() {
        const Strip bed;
        TickingProgram program(strip);
        QVERIFY(program.ticks());
        const auto output = bed.output();
        QVERIFY(output && output->open().ok());
        QVERIFY(bed.comes(Happening::kept, 3));
        const int mine = bed.motor.last(Happening::kept)->id;
        QVERIFY(output->tick(Tick(0.5, 0.0, 0.01)));
        pass(0.1);
        QCOMPARE(bed.motor.last(Happening::kept)->id, mine);
        output->stop();
        QVERIFY(bed.comes(Happening::forgotten, 1));
        QCOMPARE(bed.motor.last(Happening::forgotten)->id, mine);
        const int before = bed.motor.count(Happening::began);
        QVERIFY(bed.comes(Happening::began, before + 3));
        QCOMPARE(program.end(), 0);
    }

    void without_permission_a_person_is_told_what_to_do() {
        const Strip bed;
        const auto output = bed.output();
        QVERIFY(output);
        constexpr uid_t nobody = 65534;
        QCOMPARE(::seteuid(nobody), 0);
        const auto can = output->open();
        QCOMPARE(::seteuid(0), 0);
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("udev/rules.d") != std::string::npos, can.error().c_str());
    }

    void a_game_pad_shakes_for_as_long_as_told_and_stops_by_itself() {
        const GamePad pad;
        const auto output = pad.output();
        QVERIFY(output);
        const auto can = output->open();
        QVERIFY2(can.ok(), can.ok() ? "" : can.error().c_str());
        QCOMPARE(can->means, TouchMeans::rumble);
        QVERIFY(output->tick(Tick(1.0, 0.0, 0.05)));
        QVERIFY(pad.begins_to_shake());
        pass(0.2);
        double began = 0.0;
        double ended = 0.0;
        for (std::size_t i = 0; i < pad.log.size(); ++i) {
            if (pad.log[i].force.x > 0.0 && began == 0.0)
                began = pad.log[i].time;
            if (pad.log[i].force.x > 0.0)
                ended = pad.log[i].time;
            QVERIFY(pad.log[i].force.y == 0.0); // a soft tick is the slow motor's
        }
        say("shook for", 1e3 * (ended - began));
        QVERIFY(ended - began > 0.05 - of_a_timer && ended - began < 0.05 + of_a_timer);
    }

    void a_program_that_stands_still_or_is_killed_leaves_no_game_pad_shaking() {
        for (const bool killed : {false, true}) {
            const GamePad pad;
            TickingProgram program(GamePad::name);
            QVERIFY(program.ticks());
            QVERIFY(pad.begins_to_shake());
            pass(0.1);
            const double ended = now();
            killed ? program.kill() : program.hold();
            pass(0.3);
            const double still = last_pull(pad.log, ended, now()) - ended;
            say(killed ? "killed, still after" : "held, still after", 1e3 * still);
            QVERIFY(still <= (killed ? at_once : Tick::longest_s + of_a_timer));
            QVERIFY(!pad.shakes());
            if (!killed) {
                program.go_on();
                QVERIFY(pad.begins_to_shake());
            }
        }
    }

    void the_lab_lists_and_tries_it() {
        const GamePad pad;
        QVERIFY(pad.output());
        const QString listed = run_lab({"devices", "--json"}).printed;
        QVERIFY2(listed.contains("\"means\":\"rumble\",\"name\":\"motor:GP-0001\""), qPrintable(listed));
        const LabRun tried = run_lab({"devices", "tick", GamePad::name, "--count", "2", "--strength", "0.5"});
        QCOMPARE(tried.complaints, QString());
        QCOMPARE(tried.status, 0);
        Vec2 strongest{0.0};
        for (std::size_t i = 0; i < pad.log.size(); ++i)
            strongest = glm::max(strongest, pad.log[i].force);
        QVERIFY(strongest == Vec2(0.5)); // a soft tick by the slow motor, a sharp one by the fast
        QVERIFY(!pad.shakes());
    }

    void a_game_pad_is_found_lost_and_found_again() {
        GamePad pad;
        {
            TickingProgram program(GamePad::name);
            QVERIFY(program.ticks());
            QVERIFY(pad.begins_to_shake());
            pad.tell('u');
            QCOMPARE(program.ended(), 3);
            QCOMPARE(program.said(), QString("The Wireless game pad was unplugged. Plug it in again.\n"));
        }
        pad.tell('p');
        TickingProgram again(GamePad::name);
        QVERIFY(again.ticks());
        QVERIFY(pad.begins_to_shake());
        QCOMPARE(again.end(), 0);
    }
};

QTEST_GUILESS_MAIN(ForceFeedbackVmTest)
#include "force_feedback_test.moc"
