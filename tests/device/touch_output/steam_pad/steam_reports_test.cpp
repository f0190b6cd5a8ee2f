// SPDX-License-Identifier: Apache-2.0
#include "corpus.hpp"
#include "device/touch_output/steam_pad/model_steam_pad.hpp"
#include "device/touch_output/steam_pad/steam_reports.hpp"
#include "places.hpp"
#include "report_check.hpp"

#include <QTest>

#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

using namespace tp;

namespace {

std::vector<std::uint8_t> report_of(ModelSteamPad& model) {
    std::vector<std::uint8_t> bytes;
    while (!model.report(bytes))
        model.step();
    return bytes;
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
