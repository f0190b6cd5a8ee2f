// SPDX-License-Identifier: Apache-2.0
// What is sent to a 2diy's board and when, and which of its answers are believed: each byte written by hand.
#include "device/guard/simulated_guard.hpp"
#include "device/haply_2diy/found_boards.hpp"
#include "device/haply_2diy/haply_2diy.hpp"
#include "device/haply_2diy/protocol/board_frames.hpp"
#include "safe_force.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

using namespace tp;
using tp::testing::safe;

namespace {

/// A board that answers as a test has it, and keeps what it was sent.
struct Script final : SerialLine {
    const Pantograph arms{HaplyGeneration::third};
    haply::Reply here = arms.reply_of(arms.reference_deg());
    bool answers = true;
    bool reads_fail = false;
    bool writes_fail = false;
    std::size_t at_once = 1000;  ///< bytes
    std::size_t junk_before = 0; ///< bytes before each answer
    std::deque<std::uint8_t> to_say;
    std::vector<std::vector<std::uint8_t>> sent;
    int reads = 0;

    void say(const haply::Reply& reply) {
        for (const std::uint8_t byte : haply::encode(reply))
            to_say.push_back(byte);
    }
    int read(std::span<std::uint8_t> into, int) noexcept override {
        ++reads;
        if (reads_fail)
            return -1;
        const std::size_t count = std::min({into.size(), to_say.size(), at_once});
        std::copy_n(to_say.begin(), count, into.begin());
        to_say.erase(to_say.begin(), to_say.begin() + static_cast<std::ptrdiff_t>(count));
        return static_cast<int>(count);
    }
    bool write(std::span<const std::uint8_t> bytes) noexcept override {
        if (writes_fail)
            return false;
        sent.emplace_back(bytes.begin(), bytes.end());
        if (answers) {
            to_say.insert(to_say.end(), junk_before, 0xEE);
            say(here);
        }
        return true;
    }
    std::optional<haply::Command> last_command() const {
        if (sent.empty() || sent.back().size() != haply::command_size)
            return std::nullopt;
        return haply::decode_command(std::span(sent.back()).first<haply::command_size>());
    }
};

struct Lent final : SerialLine {
    explicit Lent(Script& lent) : script(lent) {}
    int read(std::span<std::uint8_t> into, int wait_ms) noexcept override {
        return script.read(into, wait_ms);
    }
    bool write(std::span<const std::uint8_t> bytes) noexcept override { return script.write(bytes); }
    Script& script;
};

struct Bench {
    Script script;
    GuardDiary guard;
    Haply2diy device{HaplyGeneration::third,
                     [this]() -> Result<Haply2diy::Board> {
                         return Haply2diy::Board{std::make_unique<Lent>(script),
                                                 std::make_unique<SimulatedGuard>(guard),
                                                 {},
                                                 "X"};
                     },
                     LatestWriter::Thread::caller};
    double now = 0.0;
    Result<Capabilities> can = Error{"not open"};

    /// Homed; from here on a test says what comes.
    bool open() {
        can = device.open();
        const bool homed = can.ok() && device.home().ok();
        script.answers = false;
        script.to_say.clear();
        script.sent.clear();
        return homed;
    }
    /// Until its encoders are not believed any more.
    bool falls_out_of_step() {
        for (int i = 0; i < 25; ++i)
            tick({0.5, 0.5});
        return device.complaint().find("lost count") != std::string::npos;
    }
    std::optional<DeviceState> tick(Vec2 newtons, double dt = 0.001) {
        const std::optional<DeviceState> state = device.read(now += dt);
        device.write(safe(newtons));
        device.deliver();
        return state;
    }
    /// The reference pose, its first arm turned on by so much.
    haply::Reply turned(double degrees) const {
        std::array<double, 2> angles = script.arms.reference_deg();
        angles[0] += degrees;
        return script.arms.reply_of(angles);
    }
};

} // namespace

class HaplyDialogueTest : public QObject {
    Q_OBJECT
private slots:
    void it_says_what_it_can() {
        Bench bench;
        QVERIFY(bench.open());
        QCOMPARE(bench.can->continuous_force, 0.47 * bench.can->max_force);
        QCOMPARE(bench.can->delay, 0.002);
        QCOMPARE(bench.can->serial_number, std::string("X"));
        QCOMPARE(bench.can->workspace.size(), std::size_t(120));
        for (const Vec2 corner : bench.can->workspace)
            QVERIFY(corner.y >= 15.0);
    }

    void why_it_cannot_be_opened_is_passed_on() {
        Haply2diy device(
            HaplyGeneration::third, []() -> Result<Haply2diy::Board> { return Error{"It is gone."}; },
            LatestWriter::Thread::caller);
        QCOMPARE(device.open().error(), std::string("It is gone."));
        QVERIFY(!device.write(SafeForce{}));
    }

    void gone_without_a_stop_it_pulls_nothing() {
        Script script;
        GuardDiary guard;
        {
            Haply2diy device(
                HaplyGeneration::third,
                [&]() -> Result<Haply2diy::Board> {
                    return Haply2diy::Board{
                        std::make_unique<Lent>(script), std::make_unique<SimulatedGuard>(guard), {}, "X"};
                },
                LatestWriter::Thread::caller);
            QVERIFY(device.open().ok() && device.home().ok());
            device.read(0.001);
            device.write(safe({0.5, 0.5}));
            device.deliver();
            QVERIFY(script.last_command()->torque != (std::array<float, 2>{}));
        }
        QVERIFY(script.last_command()->torque == (std::array<float, 2>{}));
        QCOMPARE(guard.dismissals, 1);
        QCOMPARE(guard.ends, 1);
    }

    void a_line_on_which_nothing_has_come_is_asked_once_in_a_tick() {
        Bench bench;
        QVERIFY(bench.open());
        bench.script.reads = 0;
        bench.tick({0, 0});
        QCOMPARE(bench.script.reads, 1);
        bench.script.say(bench.turned(0.0));
        bench.tick({0, 0});
        QCOMPARE(bench.script.reads, 3);
    }

    /// Whose arms do not stand on their marks, it says: they are counted from another place.
    void homing_is_done_where_the_board_counts_from_the_marks() {
        for (const double off : {0.0, 0.9, 1.1, -0.9, -1.1})
            for (const std::size_t arm : {0u, 1u}) {
                Bench bench;
                QVERIFY(bench.open());
                std::array<double, 2> angles = bench.script.arms.reference_deg();
                angles[arm] += off;
                bench.script.here = bench.script.arms.reply_of(angles);
                bench.script.answers = true;
                QCOMPARE(bench.device.home().ok(), std::abs(off) < 1.0);
                QCOMPARE(bench.script.sent.size(),
                         std::abs(off) < 1.0 ? std::size_t(1) : std::size_t(5)); // tries
            }
    }

    /// At a port where another device is, whatever that says to each question.
    void what_answers_like_no_2diy_is_not_opened() {
        haply::Reply elsewhere = Script().here; // than it was just told that its arms are
        elsewhere.angle_deg[0] += 1.5f;
        haply::Reply other = Script().here;
        other.device_id = 4;
        haply::Reply nowhere = Script().here;
        nowhere.angle_deg[1] = 1e6f;
        for (const haply::Reply& answer : {elsewhere, other, nowhere}) {
            Bench bench;
            bench.script.here = answer;
            QVERIFY(!bench.open());
            QVERIFY2(bench.can.error().find("does not answer like") != std::string::npos,
                     bench.can.error().c_str());
            QVERIFY(!bench.device.write(SafeForce{}));
        }
    }

    /// A line gives what has come, and who used it before may have left something on it.
    void it_is_opened_where_its_answers_come_in_pieces_or_behind_other_bytes() {
        for (const std::size_t at_once : {1u, 4u, 1000u})
            for (const std::size_t junk : {0u, 5u, 256u}) {
                if (at_once * 50 < junk + haply::reply_size) // longer than it waits
                    continue;
                Bench bench;
                bench.script.at_once = at_once;
                bench.script.junk_before = junk;
                QVERIFY2(bench.open(), bench.can.error().c_str());
            }
    }

    void another_board_s_answer_is_none() {
        Bench bench;
        QVERIFY(bench.open());
        haply::Reply other = bench.turned(0.0);
        other.device_id = 4;
        bench.script.say(other);
        QVERIFY(!bench.tick({0, 0}));
        QVERIFY(bench.device.bad_answers() > 0);
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0, 0}));
    }

    void an_answer_that_comes_in_two_pieces_is_one() {
        Bench bench;
        QVERIFY(bench.open());
        const auto bytes = haply::encode(bench.turned(0.0));
        bench.script.to_say.assign(bytes.begin(), bytes.begin() + 4);
        QVERIFY(!bench.tick({0, 0}));
        bench.script.to_say.assign(bytes.begin() + 4, bytes.end());
        QVERIFY(bench.tick({0, 0}));
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
    }

    /// Bytes between two answers count once, however many they are.
    void garbage_is_one_bad_answer() {
        Bench bench;
        QVERIFY(bench.open());
        bench.script.to_say.assign(7, 0xEE);
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0, 0}));
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(1));
        bench.script.to_say.assign(3, 0xEE);
        bench.script.say(bench.turned(0.1));
        QVERIFY(bench.tick({0, 0}));
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(2));
    }

    /// One that is lost: the next two go out, then none for 5 ms, and none of the waiting ones is sent late.
    void commands_wait_for_answers_5_ms() {
        Bench bench;
        QVERIFY(bench.open());
        for (int i = 1; i <= 6; ++i) {
            bench.tick({0.5, 0.1 * i});
            QVERIFY(bench.script.sent.size() <= 2);
        }
        QCOMPARE(bench.script.sent.size(), std::size_t(2));
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
        for (int i = 1; i <= 3; ++i)
            bench.tick({0.5, 0.1 * i});
        QVERIFY(bench.script.sent.size() > 2);
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(1));
    }

    /// Letting go waits for nothing.
    void no_force_goes_out_whatever_is_under_way() {
        Bench bench;
        QVERIFY(bench.open());
        bench.tick({0.5, 0.5});
        bench.tick({0.4, 0.5});
        bench.tick({0.3, 0.5});
        QCOMPARE(bench.script.sent.size(), std::size_t(2));
        bench.tick({0, 0});
        QCOMPARE(bench.script.sent.size(), std::size_t(3));
        QVERIFY(bench.script.last_command()->torque == (std::array<float, 2>{}));
        QVERIFY(!bench.guard.pulls);
        bench.tick({0, 0}); // once is enough
        QCOMPARE(bench.script.sent.size(), std::size_t(3));
    }

    /// After 20 ms its encoders are not believed any more; its motors pull nothing from then on.
    void a_board_that_is_silent_for_20_ms_is_brought_into_step() {
        Bench bench;
        QVERIFY(bench.open());
        int ticks = 0;
        const auto brought_back = [&] {
            return std::any_of(bench.script.sent.begin(), bench.script.sent.end(),
                               [](const auto& bytes) { return bytes.size() > 500; });
        };
        while (!brought_back() && ticks < 100) {
            ++ticks;
            bench.tick({0.5, 0.5});
        }
        QVERIFY2(ticks >= 21 && ticks <= 24, qPrintable(QString::number(ticks)));
        QVERIFY(bench.device.motors_off());
        QVERIFY(bench.device.complaint().find("lost count") != std::string::npos);
        const std::size_t before = bench.script.sent.size();
        bench.tick({0.5, 0.5});
        QCOMPARE(bench.script.sent.size(), before); // nothing else until it answers
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        bench.tick({0.5, 0.5});
        QVERIFY(bench.script.last_command() &&
                bench.script.last_command()->torque == (std::array<float, 2>{}));
    }

    /// What came, what waited and where it was belong to what was before.
    void opened_again_it_begins_as_new() {
        Bench bench;
        QVERIFY(bench.open());
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        QVERIFY(bench.falls_out_of_step());
        bench.guard.word = ForceGuard::Word::stepped_in;
        const auto bytes = haply::encode(bench.turned(0.0));
        bench.script.to_say.assign(bytes.begin(), bytes.begin() + 4); // the rest of it never comes
        bench.tick({0.5, 0.5});
        bench.guard.word = ForceGuard::Word::here;
        bench.script.answers = true;
        QVERIFY(bench.device.open().ok());
        bench.script.answers = false;
        bench.script.to_say.clear();
        bench.script.sent.clear();
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
        QVERIFY2(bench.device.complaint().find("does not know where its arms are") != std::string::npos,
                 bench.device.complaint().c_str());
        bench.now += 1.0;
        QVERIFY(!bench.tick({0.5, 0.5}));
        QCOMPARE(bench.script.sent.size(), std::size_t(1)); // not homed: no torque
        QVERIFY(bench.script.last_command()->torque == (std::array<float, 2>{}));
        bench.script.say(bench.turned(-30.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        QCOMPARE(bench.device.bad_answers(), std::uint64_t(0));
    }

    void homed_again_it_pulls_and_believes_at_once() {
        Bench bench;
        QVERIFY(bench.open());
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        QVERIFY(bench.falls_out_of_step());
        bench.script.answers = true;
        const Result<bool> homed = bench.device.home();
        QVERIFY(homed.ok() && *homed);
        bench.script.answers = false;
        bench.script.sent.clear();
        QCOMPARE(bench.device.complaint(), std::string());
        QVERIFY(!bench.device.motors_off());
        bench.script.say(bench.turned(-20.0));
        QVERIFY(bench.tick({0.5, 0.5}));
        bench.tick({0.5, 0.5});
        QVERIFY(!bench.script.sent.empty());
        QVERIFY(bench.script.last_command()->torque != (std::array<float, 2>{}));
    }

    /// A second long, each time with another number of bytes; then it is taken for gone.
    void a_board_that_stays_silent_is_brought_back_fifty_times() {
        Bench bench;
        QVERIFY(bench.open());
        std::vector<std::size_t> sizes;
        int ticks = 0;
        for (; !bench.device.lost() && ticks < 3000; ++ticks) {
            bench.tick({0.5, 0.5});
            for (const auto& bytes : bench.script.sent)
                if (bytes.size() > 500)
                    sizes.push_back(bytes.size());
            bench.script.sent.clear();
        }
        QCOMPARE(sizes.size(), std::size_t(50));
        QVERIFY2(ticks > 1000 && ticks < 1150, qPrintable(QString::number(ticks)));
        for (std::size_t i = 1; i < sizes.size(); ++i)
            QCOMPARE(sizes[i], sizes[0] + (i % 2 == 0 ? 0 : sizes[1] - sizes[0]));
        QVERIFY(sizes[1] != sizes[0]);
    }

    void one_that_is_gone_is_said_so() {
        for (const bool by_reading : {true, false}) {
            Bench bench;
            bench.device.halt(); // of nothing
            bench.script.reads_fail = by_reading;
            bench.script.writes_fail = !by_reading;
            QVERIFY(!bench.open());
            QVERIFY(!bench.device.lost());
            QCOMPARE(bench.device.complaint(), std::string());
            bench.script.reads_fail = bench.script.writes_fail = false;
            bench.script.answers = true;
            QVERIFY(bench.open());
            bench.script.reads_fail = by_reading;
            bench.script.writes_fail = !by_reading;
            bench.tick({0.5, 0.5});
            QVERIFY(bench.device.lost());
            QVERIFY(!bench.device.write(SafeForce{}));
            QVERIFY(!bench.device.read(bench.now));
            bench.device.stop();
            QCOMPARE(bench.guard.dismissals, 0); // nobody knows what it pulls
            QCOMPARE(bench.guard.ends, 2);
        }
    }

    void halted_it_lets_go() {
        Bench bench;
        QVERIFY(bench.open());
        bench.tick({0.5, 0.5});
        QVERIFY(bench.script.last_command()->torque != (std::array<float, 2>{}));
        bench.device.halt();
        bench.device.deliver();
        QVERIFY(bench.script.last_command()->torque == (std::array<float, 2>{}));
        bench.device.stop();
        QCOMPARE(bench.guard.dismissals, 1);
        QCOMPARE(bench.guard.ends, 1);
    }

    void places_go_on_as_fast_as_arms_turn_and_no_faster() {
        Bench bench;
        QVERIFY(bench.open());
        bench.script.say(bench.turned(0.0));
        QVERIFY(bench.tick({0, 0}));
        bench.script.say(bench.turned(-2.0));
        const std::optional<DeviceState> moved = bench.tick({0, 0});
        QVERIFY(moved);
        QVERIFY(length(moved->position - bench.script.arms.pose_at({95.23, 82.77})->place) < 1e-3);
        QCOMPARE(moved->time, bench.now);
        bench.script.say(bench.turned(-5.0));
        QVERIFY(!bench.tick({0, 0}));
    }

    void a_board_that_is_set_up_may_have_motors_and_encoders_at_any_port() {
        haply::SetUp set_up;
        for (std::size_t port = 0; port < haply::port_count; ++port) {
            set_up.motors[port] = haply::Turn::clockwise;
            set_up.encoders[port] = haply::EncoderSetUp{haply::Turn::counter_clockwise, 1.0f, 4096.0f};
        }
        const haply::SetUpBytes all = haply::encode(set_up);
        QCOMPARE(all.size, std::size_t(46));
        QCOMPARE(haply::set_up_length(all.view().first(13)),
                 std::optional<std::size_t>()); // not known before
        QCOMPARE(haply::set_up_length(all.view().first(14)), std::optional<std::size_t>(46));
        const std::vector<std::uint8_t> pins{1, 5, 0, 0, 3, 0, 0, 0, 2, 0, 0};
        QCOMPARE(haply::set_up_length(pins), std::optional<std::size_t>(11));
        QVERIFY(!haply::decode_set_up(pins)); // a 2diy has none
    }

    void the_way_back_into_step_grows_by_a_byte_in_each_second_round() {
        const Pantograph arms(HaplyGeneration::third);
        const haply::SetUp set_up = arms.set_up(arms.reference_deg());
        const std::size_t rest = 1 + haply::encode(set_up).size + haply::command_size;
        for (unsigned round = 0; round < 4; ++round) {
            const haply::ResynchronisationBytes bytes = haply::resynchronisation(set_up, round);
            QCOMPARE(bytes.size, 556 + round % 2 + rest);
            for (std::size_t i = 0; i < 556 + round % 2; ++i)
                QCOMPARE(bytes.bytes[i], std::uint8_t(0));
            QCOMPARE(bytes.bytes[556 + round % 2], std::uint8_t(3));
        }
    }

    void a_note_is_kept_for_each_board_of_a_name() {
        const QTemporaryDir folder;
        const QByteArray before = qgetenv("XDG_RUNTIME_DIR");
        qputenv("XDG_RUNTIME_DIR", folder.path().toUtf8());
        const HomedNote note = HomedNote::of_board("A/1", HaplyGeneration::third);
        QVERIFY(!note.holds());
        note.put();
        QVERIFY(note.holds());
        QVERIFY(std::filesystem::exists(folder.filePath("touchphoto-2diy-A_1").toStdString()));
        QVERIFY(!HomedNote::of_board("A/2", HaplyGeneration::third).holds());
        QVERIFY(!HomedNote::of_board("A/1", HaplyGeneration::first).holds());
        const HomedNote nameless = HomedNote::of_board("", HaplyGeneration::third);
        nameless.put();
        QVERIFY(!nameless.holds());
        note.forget();
        QVERIFY(!note.holds());
        qunsetenv("XDG_RUNTIME_DIR");
        QVERIFY(!HomedNote::of_board("A/1", HaplyGeneration::third).holds());
        if (!before.isNull())
            qputenv("XDG_RUNTIME_DIR", before);
    }

    void vendors_are_known_in_capitals_or_not() {
        for (const char* vendor : {"2341", "2A03", "2a03"})
            QVERIFY2(is_arduino(vendor), vendor);
        for (const char* vendor : {"", "234", "23411", "2342", "2z03", "2B03", "1a03"})
            QVERIFY2(!is_arduino(vendor), vendor);
    }
};

QTEST_APPLESS_MAIN(HaplyDialogueTest)
#include "dialogue_test.moc"
