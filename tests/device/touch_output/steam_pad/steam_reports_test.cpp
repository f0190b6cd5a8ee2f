// SPDX-License-Identifier: Apache-2.0
#include "corpus.hpp"
#include "device/touch_output/steam_pad/model_steam_pad.hpp"
#include "device/touch_output/steam_pad/steam_reports.hpp"
#include "places.hpp"
#include "report_check.hpp"

#include <QTest>

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

using namespace tp;

Q_DECLARE_METATYPE(tp::Tick)
Q_DECLARE_METATYPE(tp::steam::Pulses)

namespace {

std::vector<std::uint8_t> report_of(ModelSteamPad& model) {
    std::vector<std::uint8_t> bytes;
    while (!model.report(bytes))
        model.step();
    return bytes;
}

/// The first 24 bytes of its next report, as "01 00 3c".
std::string told(ModelSteamPad& model) {
    std::string hex;
    const std::vector<std::uint8_t> report = report_of(model);
    for (const std::uint8_t byte : std::span(report).first(24))
        hex += QString::asprintf(hex.empty() ? "%02x" : " %02x", unsigned{byte}).toStdString();
    return hex;
}

QString hex(const steam::Feature& report, int bytes) {
    return QByteArray(reinterpret_cast<const char*>(report.data()), bytes).toHex(' ');
}

void every_controller() {
    QTest::addColumn<int>("kind");
    QTest::newRow("deck") << static_cast<int>(steam::Kind::deck);
    QTest::newRow("controller") << static_cast<int>(steam::Kind::controller);
    QTest::newRow("receiver") << static_cast<int>(steam::Kind::receiver);
}

} // namespace

class SteamReportsTest : public QObject {
    Q_OBJECT
private slots:
    void each_product_is_one_kind() {
        QCOMPARE(steam::kind_of(0x1205), std::optional(steam::Kind::deck));
        QCOMPARE(steam::kind_of(0x1102), std::optional(steam::Kind::controller));
        QCOMPARE(steam::kind_of(0x1142), std::optional(steam::Kind::receiver));
        for (const std::uint16_t other : {std::uint16_t(0), std::uint16_t(0x1304), std::uint16_t(0xFFFF)})
            QVERIFY(!steam::kind_of(other));
    }

    void a_thumb_is_where_it_lies_data() { every_controller(); }
    void a_thumb_is_where_it_lies() {
        QFETCH(int, kind);
        for (const Vec2 place : {Vec2(0.0), Vec2(10.0, 3.0), Vec2(-7.0, 9.5), Vec2(0.0, -14.0)}) {
            ModelSteamPad model{static_cast<steam::Kind>(kind)};
            model.touch(steam::Side::left, place, true);
            model.touch(steam::Side::right, -place);
            const steam::News news = steam::news_of(report_of(model));
            QVERIFY(news.pads_told);
            const steam::Pad& left = news.pads[0];
            const steam::Pad& right = news.pads[1];
            QVERIFY(left.touched && left.pressed && left.place && right.touched && !right.pressed &&
                    right.place);
            QVERIFY(distance(*left.place, place) < 0.002);
            QVERIFY(distance(*right.place, -place) < 0.002);
        }
    }

    void a_pad_that_nobody_touches_says_so_data() { every_controller(); }
    void a_pad_that_nobody_touches_says_so() {
        QFETCH(int, kind);
        ModelSteamPad model{static_cast<steam::Kind>(kind)};
        const steam::News news = steam::news_of(report_of(model));
        QVERIFY(news.pads_told);
        QVERIFY(!news.pads[0].touched && !news.pads[1].touched);
    }

    /// The firmware tells of both by turns, in the same bytes.
    void the_stick_is_not_taken_for_the_left_pad() {
        ModelSteamPad model(steam::Kind::controller);
        model.push_stick({1.0, 1.0});
        QVERIFY(!steam::news_of(report_of(model)).pads[0].touched);
        model.touch(steam::Side::left, {3.0, 4.0});
        int told = 0;
        for (int i = 0; i < 4; ++i) {
            const steam::Pad left = steam::news_of(report_of(model)).pads[0];
            QVERIFY(left.touched);
            if (left.place) {
                ++told;
                QVERIFY(distance(*left.place, Vec2(3.0, 4.0)) < 0.002);
            }
        }
        QCOMPARE(told, 2);
    }

    void a_controller_that_comes_and_goes_is_told() {
        ModelSteamPad model(steam::Kind::receiver);
        model.switch_on(false);
        QCOMPARE(steam::news_of(report_of(model)).connected, std::optional(false));
        model.switch_on(true);
        QCOMPARE(steam::news_of(report_of(model)).connected, std::optional(true));
    }

    /// hid-steam.c: 8F 08 pad duration interval count gain, the sides swapped.
    void pulses_are_the_bytes_that_the_kernel_sends() {
        const steam::Pulses pulses{0x1234, 0x0567, 3, -24};
        QCOMPARE(hex(steam::play(steam::Side::left, pulses), 12),
                 QString("00 8f 08 01 34 12 67 05 03 00 e8 00"));
        QCOMPARE(hex(steam::play(steam::Side::right, pulses), 5), QString("00 8f 08 00 34"));
        QCOMPARE(hex(steam::play_nothing(), 12), QString("00 8f 08 02 00 00 00 00 00 00 00 00"));
    }

    /// A push of half a period, or of less where the gain does nothing; a tick of 2 to 8 ms for each pulse.
    void pulses_are_as_long_and_as_strong_as_their_tick_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<Tick>("tick");
        QTest::addColumn<steam::Pulses>("pulses");
        const auto row = [](const char* name, steam::Kind kind, const Tick& tick,
                            const steam::Pulses& pulses) {
            QTest::newRow(name) << static_cast<int>(kind) << tick << pulses;
        };
        constexpr steam::Kind deck = steam::Kind::deck;
        row("sharp", deck, Tick(1.0, 1.0, 0.01), {1000, 1000, 5, 6});
        row("between", deck, Tick(0.5, 0.5, 0.02), {2500, 2500, 4, 0});
        row("soft_and_long", deck, Tick(0.25, 0.0, 0.05), {4000, 4000, 6, -6});
        row("faint", deck, Tick(0.001, 1.0, 0.01), {1000, 1000, 5, -24});
        row("shorter_than_a_pulse", deck, Tick(1.0, 0.0, 0.002), {4000, 4000, 1, 6});
        row("nothing", deck, Tick(), {0, 0, 0, 0});
        for (const steam::Kind kind : {steam::Kind::controller, steam::Kind::receiver}) {
            const bool radio = kind == steam::Kind::receiver;
            row(radio ? "by_radio" : "by_cable", kind, Tick(0.5, 1.0, 0.01), {500, 1500, 5, 0});
            row(radio ? "faint_by_radio" : "faint_by_cable", kind, Tick(0.001, 1.0, 0.01), {20, 1980, 5, 0});
        }
    }
    void pulses_are_as_long_and_as_strong_as_their_tick() {
        QFETCH(int, kind);
        QFETCH(Tick, tick);
        QFETCH(steam::Pulses, pulses);
        const steam::Pulses made = steam::pulses_of(tick, static_cast<steam::Kind>(kind));
        QCOMPARE(made.on_us, pulses.on_us);
        QCOMPARE(made.off_us, pulses.off_us);
        QCOMPARE(made.count, pulses.count);
        QCOMPARE(made.gain_db, pulses.gain_db);
    }

    /// hid-steam.c: 81, then 87 with three bytes for each setting.
    void what_keeps_the_mouse_off_is_the_bytes_that_the_kernel_sends() {
        const std::array<steam::Feature, 2> deck = steam::imitate_nothing(steam::Kind::deck);
        QCOMPARE(hex(deck[0], 4), QString("00 81 00 00"));
        QCOMPARE(hex(deck[1], 20), QString("00 87 0f 18 00 00 07 07 00 08 07 00 34 ff ff 35 ff ff 00 00"));
        for (const steam::Kind kind : {steam::Kind::controller, steam::Kind::receiver}) {
            const std::array<steam::Feature, 2> other = steam::imitate_nothing(kind);
            QCOMPARE(hex(other[0], 4), QString("00 81 00 00"));
            QCOMPARE(hex(other[1], 14), QString("00 87 09 18 00 00 07 07 00 08 07 00 00 00"));
        }
        QCOMPARE(hex(steam::imitate_as_usual()[0], 4), QString("00 85 00 00"));
        QCOMPARE(hex(steam::imitate_as_usual()[1], 4), QString("00 8e 00 00"));
        QCOMPARE(hex(steam::ask_whether_connected(), 4), QString("00 b4 00 00"));
    }

    void a_mouse_is_imitated_no_longer_and_again_data() { every_controller(); }
    void a_mouse_is_imitated_no_longer_and_again() {
        QFETCH(int, kind);
        ModelSteamPad model{static_cast<steam::Kind>(kind)};
        QVERIFY(model.imitates());
        for (const steam::Feature& report : steam::imitate_nothing(model.kind()))
            QVERIFY(model.receive(report));
        QVERIFY(!model.imitates());
        for (const steam::Feature& report : steam::imitate_as_usual())
            QVERIFY(model.receive(report));
        QVERIFY(model.imitates());
    }

    void every_tick_is_over_in_time_and_stronger_where_it_should_be_data() { every_controller(); }
    void every_tick_is_over_in_time_and_stronger_where_it_should_be() {
        QFETCH(int, kind);
        for (const double sharpness : {0.0, 0.3, 1.0})
            for (const double seconds : {1e-6, 0.002, 0.013, 0.05}) {
                double weaker = 0.0;
                for (const double amplitude : {0.07, 0.3, 0.6, 1.0}) {
                    ModelSteamPad model{static_cast<steam::Kind>(kind)};
                    const steam::Pulses pulses =
                        steam::pulses_of(Tick(amplitude, sharpness, seconds), model.kind());
                    model.receive(steam::play(steam::Side::left, pulses));
                    QCOMPARE(model.ticks(), 1ul);
                    QVERIFY(model.longest_ms() <= std::max(8.0, 1e3 * seconds) + 1e-6);
                    QVERIFY(model.felt(steam::Side::left) > weaker);
                    QCOMPARE(model.felt(steam::Side::right), 0.0);
                    weaker = model.felt(steam::Side::left);
                    for (int ms = 0; ms < 51; ++ms)
                        model.step();
                    QCOMPARE(model.felt(steam::Side::left), 0.0);
                }
                QVERIFY(std::abs(weaker - 1.0) < 0.01);
            }
        QCOMPARE(steam::pulses_of(Tick(), steam::Kind::deck), steam::Pulses{});
    }

    // The model, of which nothing is read back through what it is to try

    void the_model_tells_what_the_devices_do() {
        ModelSteamPad deck(steam::Kind::deck);
        std::vector<std::uint8_t> early;
        for (int ms = 0; ms < 3; ++ms)
            deck.step();
        QVERIFY(!deck.report(early));                        // each 4 ms
        deck.touch(steam::Side::left, {-32.5, 8.125}, true); // beside it, and half of the way up
        QCOMPARE(told(deck),
                 std::string("01 00 09 40 01 00 00 00 00 00 0a 00 00 00 00 00 01 80 00 40 00 00 00 00"));
        ModelSteamPad controller(steam::Kind::controller);
        controller.push_stick({1.0, -1.0});
        QCOMPARE(told(controller),
                 std::string("01 00 01 3c 01 00 00 00 00 00 00 00 00 00 00 00 ff 7f 01 80 00 00 00 00"));
        controller.touch(steam::Side::left, {0.0, 0.0});
        controller.touch(steam::Side::right, {0.0, 0.0}, true);
        QCOMPARE(told(controller),
                 std::string("01 00 01 3c 02 00 00 00 00 00 9c 00 00 00 00 00 00 00 00 00 00 00 00 00"));
        QCOMPARE(told(controller), // the stick's turn
                 std::string("01 00 01 3c 03 00 00 00 00 00 94 00 00 00 00 00 ff 7f 01 80 00 00 00 00"));
    }
    void the_model_tells_of_its_buttons_however_long_it_has_told() {
        ModelSteamPad deck(steam::Kind::deck);
        deck.touch(steam::Side::right, {0.0, 0.0}, true);
        for (int i = 0; i < 300; ++i)
            QCOMPARE(int(report_of(deck)[10]), 0x14);
    }
    void the_model_takes_whole_reports_and_nothing_behind_them() {
        ModelSteamPad model(steam::Kind::controller);
        steam::Feature report = steam::imitate_nothing(model.kind())[0];
        QVERIFY(!model.receive(std::span(report).first(64)));
        report[0] = 1;
        QVERIFY(!model.receive(report));
        QVERIFY(model.imitates());
        QVERIFY(model.receive(steam::Feature{0, 0x81}));
        std::array<std::uint8_t, 80> longer{0, 0x87, 0xFF}; // a setting that the report's end cuts
        longer[63] = 8;
        longer[64] = 7;
        QVERIFY(model.receive(std::span(longer).first(65)));
        QVERIFY(model.imitates());
        QVERIFY(model.receive(steam::Feature{0, 0x85, 3, 8, 7})); // settings of another command are none
        QVERIFY(model.receive(steam::Feature{0, 0x81}));
        QVERIFY(model.imitates());
    }
    void the_model_is_still_once_it_is_switched_off() {
        ModelSteamPad model(steam::Kind::controller);
        QCOMPARE(model.longest_ms(), 0.0);
        QVERIFY(model.receive(steam::play(steam::Side::left, {1000, 1000, 5, 0})));
        QCOMPARE(model.longest_ms(), 10.0);
        int ms = 0;
        for (; model.felt(steam::Side::left) > 0.0 && ms < 100; ++ms)
            model.step();
        QCOMPARE(ms, 10);
        QVERIFY(model.receive(steam::play(steam::Side::left, {1000, 1000, 20, 0})));
        QVERIFY(model.felt(steam::Side::left) > 0.0);
        model.switch_on(false);
        QCOMPARE(model.felt(steam::Side::left), 0.0);
        QVERIFY(!model.receive(steam::play_nothing()));
    }
    void the_model_reads_each_setting_where_it_stands() {
        ModelSteamPad model(steam::Kind::controller);
        QVERIFY(model.receive(steam::imitate_nothing(model.kind())[0]));
        steam::Feature one{0, 0x87, 3, 8, 7};
        QVERIFY(model.receive(one));
        QVERIFY(!model.imitates());
        const steam::Feature two{0, 0x87, 6, 8, 7, 0, 24, 8, 0}; // what another is set to is none
        QVERIFY(model.receive(two));
        QVERIFY(!model.imitates());
        one[4] = 0;
        QVERIFY(model.receive(one));
        QVERIFY(model.imitates());
    }

    void any_bytes_are_read() {
        std::mt19937 random(7);
        for (int i = 0; i < 20000; ++i) {
            std::string bytes(i % 3 == 0 ? random() % 80 : 64, '\0');
            for (char& byte : bytes)
                byte = static_cast<char>(random());
            if (bytes.size() > 2 && i % 2 == 0)
                bytes.replace(0, 3, {1, 0, static_cast<char>(random() % 10)});
            QCOMPARE(QString::fromStdString(test::complaint_about_steam_report(bytes)), QString());
        }
        const auto seeds =
            tp::test::corpus(tp::test::in_source("tests/device/touch_output/steam_pad/corpus"));
        QVERIFY(seeds.size() >= 4);
        for (const tp::test::Seed& seed : seeds)
            QCOMPARE(seed.name + ": " + test::complaint_about_steam_report(seed.text), seed.name + ": ");
    }
};

QTEST_APPLESS_MAIN(SteamReportsTest)
#include "steam_reports_test.moc"
