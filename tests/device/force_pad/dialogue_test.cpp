// SPDX-License-Identifier: Apache-2.0
// What is asked of a force pad, how often, and what is made of its answers: each frame written by hand.
#include "device/force_pad/force_pad.hpp"
#include "device/force_pad/pad_frames.hpp"
#include "pad_bench.hpp"
#include "safe_force.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dialogue_test {

using namespace tp;
using tp::testing::lend;
using tp::testing::safe;

namespace {

/// Answers as a test has it, keeps what was written, and says what a test puts there.
struct Script final : ReportTransport {
    std::uint8_t corners = 4;
    std::uint8_t corners_a_page = 3; ///< 0: it says nothing of its outline
    bool homes = true;
    int deaf_for = 0; ///< frames to it that it does not hear
    std::deque<pad::Frame> to_say;
    std::optional<pad::Frame> before_each_page; ///< that comes in between
    std::vector<pad::Frame> written;
    int reads = 0;
    int waited_ms = 0;
    bool gone = false;

    Got read(pad::Frame& frame, int wait_ms) noexcept override {
        ++reads;
        waited_ms += wait_ms;
        if (gone)
            return Got::lost;
        if (to_say.empty())
            return Got::nothing;
        frame = to_say.front();
        to_say.pop_front();
        return Got::report;
    }
    bool write(const pad::Frame& frame) noexcept override {
        written.push_back(frame);
        pad::AskFrame asked;
        pad::CalibrateFrame calibrate;
        if (deaf_for > 0)
            --deaf_for;
        else if (pad::decode(frame, asked))
            answer(asked);
        else if (pad::decode(frame, calibrate))
            to_say.push_back(pad::encode(pad::CalibrationFrame{0, homes, {1000, 1000, 1000, 1000}}));
        return !gone;
    }
    void say(std::uint16_t sequence, int x_um = 0, int y_um = 0, std::uint8_t buttons = 0,
             std::uint16_t status = pad::status::armed) {
        pad::StateFrame state;
        state.sequence = sequence;
        state.time_us = 1000u * sequence;
        state.x_um = x_um;
        state.y_um = y_um;
        state.buttons = buttons;
        state.status = status;
        to_say.push_back(pad::encode(state));
    }
    pad::ForceFrame last_force() const {
        pad::ForceFrame force;
        for (const pad::Frame& frame : written)
            pad::decode(frame, force);
        return force;
    }

private:
    void answer(const pad::AskFrame& asked) {
        if (asked.what == pad::FrameType::identity) {
            pad::IdentityFrame identity;
            identity.serial[0] = 'X';
            to_say.push_back(pad::encode(identity));
        } else if (asked.what == pad::FrameType::capabilities) {
            pad::CapabilitiesFrame can;
            can.corners = corners;
            can.max_force_mn = 1200;
            can.continuous_force_mn = 900;
            can.resolution_um = 8;
            can.rate_hz = 1000;
            can.delay_us = 2000;
            can.watchdog_ms = 30;
            to_say.push_back(pad::encode(can));
        } else if (asked.what == pad::FrameType::outline) {
            if (before_each_page)
                to_say.push_back(*before_each_page);
            to_say.push_back(pad::encode(page(asked.page)));
        }
    }
    pad::OutlineFrame page(std::uint8_t number) const {
        static constexpr int places[][2] = {{-100, -75}, {100, -75}, {100, 75}, {-100, 75}};
        pad::OutlineFrame outline;
        outline.page = number;
        for (std::size_t i = 3u * number; i < corners && outline.corners < corners_a_page;
             ++i, ++outline.corners) {
            outline.x_um[outline.corners] = 1000 * places[i][0];
            outline.y_um[outline.corners] = 1000 * places[i][1];
        }
        return outline;
    }
};

struct Bench {
    Script script;
    ForcePad device{lend(script), LatestWriter::Thread::caller};
    Result<Capabilities> can = Error{"not open"};

    bool open() {
        can = device.open();
        return can.ok();
    }
};

} // namespace

class PadDialogueTest : public QObject {
    Q_OBJECT
private slots:
    void its_motors_go_off_before_it_is_asked_anything() {
        Bench bench;
        QVERIFY(bench.open());
        pad::ForceFrame first;
        first.motors = true;
        QVERIFY(pad::decode(bench.script.written.at(0), first));
        QVERIFY(!first.motors && first.x_mn == 0 && first.y_mn == 0);
        QCOMPARE(bench.script.written.size(), std::size_t(5)); // identity, capabilities, two pages
        for (const std::size_t question : {1u, 2u, 3u, 4u}) {
            pad::AskFrame asked;
            asked.page = 9;
            QVERIFY(pad::decode(bench.script.written[question], asked));
            QCOMPARE(int(asked.page), question == 4 ? 1 : 0);
        }
        QCOMPARE(bench.can->continuous_force, 0.9);
        QCOMPARE(bench.can->delay, 0.002);
        QVERIFY(bench.can->calibrated);
        QVERIFY(bench.can->workspace == (std::vector<Vec2>{{-100, -75}, {100, -75}, {100, 75}, {-100, 75}}));
    }

    /// Two seconds for each thing that is asked, of which a state each millisecond takes a part.
    void what_does_not_answer_is_asked_twenty_times() {
        Bench bench;
        bench.script.deaf_for = 1000;
        QVERIFY(!bench.open());
        QCOMPARE(bench.script.written.size(), std::size_t(1 + 20));
        QCOMPARE(bench.script.reads, 400);
        QCOMPARE(bench.script.waited_ms, 2000);
        Bench late;
        late.script.deaf_for = 20; // the frame that switches off, and nineteen questions
        QVERIFY(late.open());
        Bench busy;
        for (std::uint16_t i = 1; i <= 19; ++i)
            busy.script.say(i);
        QVERIFY(busy.open());
        QCOMPARE(busy.script.written.size(), std::size_t(5)); // nothing was asked twice
    }

    /// As one that comes late over a bad line.
    void a_page_of_the_outline_that_was_not_asked_for_is_passed_over() {
        Bench bench;
        pad::OutlineFrame other;
        other.page = 7;
        other.corners = 3;
        bench.script.before_each_page = pad::encode(other);
        QVERIFY(bench.open());
        QCOMPARE(bench.can->workspace.size(), std::size_t(4));
        QVERIFY(bench.can->workspace[3] == Vec2(-100, 75));
    }

    void a_pad_that_does_not_say_where_it_reaches_is_refused() {
        Bench bench;
        bench.script.corners_a_page = 0;
        QVERIFY(!bench.open());
        QVERIFY2(bench.can.error().find("which places it reaches") != std::string::npos,
                 bench.can.error().c_str());
        QVERIFY(!bench.device.write(SafeForce{}));
    }

    void a_pad_that_goes_while_it_is_asked_is_not_waited_for() {
        Bench bench;
        bench.script.gone = true;
        QVERIFY(!bench.open());
        QCOMPARE(bench.script.reads, 0);
    }

    void homing_is_believed_where_the_pad_says_so() {
        Bench bench;
        QVERIFY(!bench.device.home().ok()); // not open
        QVERIFY(bench.open());
        const Result<bool> homed = bench.device.home();
        QVERIFY(homed.ok() && *homed);
        bench.script.homes = false;
        QVERIFY(bench.device.home().error().find("could not be homed") != std::string::npos);
    }

    void place_and_buttons_are_those_of_the_newest_state() {
        Bench bench;
        QVERIFY(bench.open());
        QVERIFY(!bench.device.motors_off()); // nothing is known yet
        bench.script.say(1, 5000, 5000);
        bench.script.say(2, -12345, 67890, 5);
        const std::optional<DeviceState> state = bench.device.read(3.5);
        QVERIFY(state);
        QVERIFY(length(state->position - Vec2(-12.345, 67.890)) < 1e-12);
        QCOMPARE(state->buttons, 5u);
        QCOMPARE(state->time, 0.002); // of the pad's own clock
        QVERIFY(!bench.device.read(3.6));
        bench.script.say(3, 0, 0, 0, pad::status::hot);
        QVERIFY(bench.device.read(3.7));
        QVERIFY(bench.device.motors_off());
        QVERIFY(bench.device.complaint().find("too hot") != std::string::npos);
    }

    void a_late_answer_is_no_bad_frame_and_what_only_a_computer_says_is_one() {
        Bench bench;
        QVERIFY(bench.open());
        pad::IdentityFrame identity;
        for (const pad::Frame& answer :
             {pad::encode(identity), pad::encode(pad::CapabilitiesFrame{}), pad::encode(pad::OutlineFrame{}),
              pad::encode(pad::CalibrationFrame{})})
            bench.script.to_say.push_back(answer);
        QVERIFY(!bench.device.read(0.0));
        QCOMPARE(bench.device.bad_frames(), std::uint64_t(0));
        for (const pad::Frame& other :
             {pad::encode(pad::ForceFrame{}), pad::encode(pad::AskFrame{}), pad::Frame{}})
            bench.script.to_say.push_back(other);
        QVERIFY(!bench.device.read(0.0));
        QCOMPARE(bench.device.bad_frames(), std::uint64_t(3));
    }

    /// However much has gathered: a read ends, and the next goes on where it did.
    void one_read_takes_64_reports() {
        Bench bench;
        QVERIFY(bench.open());
        for (int i = 1; i <= 70; ++i)
            bench.script.say(static_cast<std::uint16_t>(i), 1000 * i);
        QCOMPARE(bench.device.read(0.0)->position.x, 64.0);
        QCOMPARE(bench.device.read(0.0)->position.x, 70.0);
    }

    void a_force_reaches_the_pad_with_its_direction_and_a_number() {
        Bench bench;
        QVERIFY(bench.open());
        std::uint16_t number = 0;
        for (const Vec2 force : {Vec2(0.3, -0.7), Vec2(-0.3, 0.7), Vec2(-0.002, -0.9), Vec2(0.0, 0.0)}) {
            QVERIFY(bench.device.write(safe(force)));
            bench.device.deliver();
            const pad::ForceFrame sent = bench.script.last_force();
            QVERIFY(std::abs(sent.x_mn - 1000.0 * force.x) < 1.001 &&
                    std::abs(sent.y_mn - 1000.0 * force.y) < 1.001);
            QVERIFY(sent.motors);
            QCOMPARE(sent.sequence, ++number);
        }
        bench.device.halt();
        bench.device.deliver();
        QVERIFY(!bench.script.last_force().motors);
        QVERIFY(bench.script.last_force().x_mn == 0 && bench.script.last_force().y_mn == 0);
    }

    void one_that_is_gone_takes_no_force_and_says_no_place() {
        Bench bench;
        QVERIFY(bench.open());
        QVERIFY(!bench.device.lost());
        bench.script.say(5000, 0, 0, 0, pad::status::hot);
        bench.script.say(1);
        QVERIFY(bench.device.read(0.0));
        QCOMPARE(bench.device.bad_frames(), std::uint64_t(1));
        QVERIFY(bench.device.motors_off());
        bench.script.gone = true;
        QVERIFY(!bench.device.read(0.0));
        QVERIFY(bench.device.lost());
        QVERIFY(!bench.device.write(SafeForce{}));
        const int before = bench.script.reads;
        QVERIFY(!bench.device.read(0.1));
        QCOMPARE(bench.script.reads, before); // it is not asked any more
        bench.script.gone = false;
        bench.script.to_say.clear();
        QVERIFY(bench.open()); // plugged in again: nothing of before is believed
        QVERIFY(!bench.device.lost());
        QVERIFY(!bench.device.motors_off());
        QVERIFY(bench.device.complaint().find("too hot") == std::string::npos);
        bench.script.say(1, 1000);
        QVERIFY(bench.device.read(0.2));
        for (std::uint16_t i = 0; i < 7; ++i) // as states that come late over a bad line
            bench.script.say(static_cast<std::uint16_t>(0xFFF0 + i), 2000);
        QVERIFY(!bench.device.read(0.3));
        QCOMPARE(bench.device.bad_frames(), std::uint64_t(7));
        bench.script.say(0xFFF7, 2000); // the eighth: it began anew
        QVERIFY(bench.device.read(0.4));
        bench.device.stop();
        QVERIFY(bench.open());
        QCOMPARE(bench.device.bad_frames(), std::uint64_t(0));
    }

    /// The first and the last of each that are believed, and their neighbours.
    void what_a_pad_may_say_of_itself_has_bounds() {
        pad::CapabilitiesFrame good;
        good.max_force_mn = 1200;
        good.rate_hz = 1000;
        good.watchdog_ms = 30;
        const std::vector<Vec2> outline{{-100, -75}, {100, -75}, {100, 75}, {-100, 75}};
        const auto believed = [&](auto change) {
            pad::CapabilitiesFrame can = good;
            std::vector<Vec2> corners = outline;
            change(can, corners);
            return capabilities_of(can, "X", corners).ok();
        };
        for (const auto& [value, may_be] : {std::pair{0, false}, {1, true}, {20000, true}, {20001, false}})
            QCOMPARE(
                believed([v = value](auto& can, auto&) { can.max_force_mn = static_cast<std::uint16_t>(v); }),
                may_be);
        for (const auto& [value, may_be] : {std::pair{49, false}, {50, true}, {8000, true}, {8001, false}})
            QCOMPARE(believed([v = value](auto& can, auto&) { can.rate_hz = static_cast<std::uint16_t>(v); }),
                     may_be);
        for (const auto& [value, may_be] : {std::pair{0, true}, {50000, true}, {50001, false}})
            QCOMPARE(
                believed([v = value](auto& can, auto&) { can.delay_us = static_cast<std::uint16_t>(v); }),
                may_be);
        for (const auto& [value, may_be] : {std::pair{19, false}, {20, true}, {50, true}, {51, false}})
            QCOMPARE(
                believed([v = value](auto& can, auto&) { can.watchdog_ms = static_cast<std::uint8_t>(v); }),
                may_be);
        for (const Vec2 corner : {Vec2(2000, -75), Vec2(-2000, -75), Vec2(-100, 2000), Vec2(-100, -2000)})
            QVERIFY(believed([c = corner](auto&, auto& corners) { corners[0] = c; }));
        for (const Vec2 corner :
             {Vec2(2000.1, -75), Vec2(-2000.1, -75), Vec2(-100, 2000.1), Vec2(-100, -2000.1)})
            QVERIFY(!believed([c = corner](auto&, auto& corners) { corners[0] = c; }));
        for (const double height : {9.9, 10.1, -9.9, -10.1}) // a square centimetre, whichever way round
            QCOMPARE(believed([&](auto&, auto& corners) {
                         corners = {{30, 7}, {50, 7}, {50, 7 + height}};
                     }),
                     std::abs(height) > 10.0);
        QVERIFY(!believed([](auto&, auto& corners) { corners = {{0, 0}, {1000, 1000}}; }));
    }

    void forces_beyond_a_frame_are_cut_to_what_it_holds() {
        QCOMPARE(force_frame(safe({-99.0, 99.0}, 200.0)).x_mn, std::int16_t(-32767));
        QCOMPARE(force_frame(safe({-99.0, 99.0}, 200.0)).y_mn, std::int16_t(32767));
    }
};

} // namespace dialogue_test

TP_TEST(dialogue_test, PadDialogueTest, nothing)
#include "dialogue_test.moc"
