// SPDX-License-Identifier: Apache-2.0
// The model, of which nothing is read back through what it is to try.
#include "../../descriptor_lines.hpp"
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace model_haptic_pad_test {

using namespace tp;

namespace {
using Bytes = std::vector<std::uint8_t>;
}

class ModelHapticPadTest : public QObject {
    Q_OBJECT
private slots:
    void the_model_says_what_it_has() {
        const std::string wanted = "d0005 1 in -1\nd0022 2 in 0\nd0022 2 in 0\n"
                                   "e0001 2 in 0\ne0010 2 in 3\ne0011 2 in 3\n"
                                   "i1 at 0: 1x1 [d0042] 0..1 0..0 0e0\n"
                                   "i1 at 1: 3x1 -[] 0..1 0..0 0e0\n"
                                   "i1 at 4: 1x4 [d0051] 0..15 0..0 0e0\n"
                                   "i1 at 8: 1x16 [10030] 0..4095 0..1000 11e-2\n"
                                   "i1 at 24: 1x16 [10031] 0..2047 0..600 11e-2\n"
                                   "i1 at 40: 1x1 [d0042] 0..1 0..0 0e0\n"
                                   "i1 at 41: 3x1 -[] 0..1 0..0 0e0\n"
                                   "i1 at 44: 1x4 [d0051] 0..15 0..0 0e0\n"
                                   "i1 at 48: 1x16 [10030] 0..4095 0..1000 11e-2\n"
                                   "i1 at 64: 1x16 [10031] 0..2047 0..600 11e-2\n"
                                   "i1 at 80: 1x1 [90001] 0..1 0..0 0e0\n"
                                   "i1 at 81: 7x1 -[] 0..1 0..0 0e0\n"
                                   "f2 at 0: 4x16 [a0003-a0006] 0..32767 0..0 0e0\n"
                                   "f2 at 64: 4x16 [a0003-a0006] 0..32767 0..0 0e0\n"
                                   "o3 at 0: 1x8 [e0021] 0..7 0..0 0e0\n"
                                   "o3 at 8: 1x8 [e0023] 0..100 0..0 0e0\n"
                                   "o3 at 16: 1x8 [e0024] 0..5 0..0 0e0\n"
                                   "o3 at 24: 1x16 [e0025] 0..1000 0..0 0e0";
        QCOMPARE(tp::testing::lines_of(ModelHapticPad::descriptor()), wanted);
        std::string by_itself = wanted; // auto trigger instead of the manual one
        by_itself.replace(by_itself.find("e0021"), 5, "e0020");
        QCOMPARE(tp::testing::lines_of(ModelHapticPad::descriptor_without_trigger()), by_itself);
    }

    void the_model_plays_as_long_as_it_is_told() {
        ModelHapticPad model;
        for (const auto& [ordinal, once_ms] : {std::pair{3, 10}, {4, 10}, {5, 20}})
            for (const int again : {0, 2}) { // once, and again so often
                model.receive(Bytes{3, static_cast<std::uint8_t>(ordinal), 100,
                                    static_cast<std::uint8_t>(again), 0, 0});
                int ms = 0;
                for (; model.felt() > 0.0 && ms < 1000; ++ms)
                    model.step();
                QCOMPARE(ms, once_ms * (1 + again));
            }
    }

    void what_goes_on_goes_on_until_it_is_stopped() {
        ModelHapticPad model;
        model.receive(Bytes{3, 6, 100, 0, 0, 0});
        for (int ms = 0; ms < 5000; ++ms)
            model.step();
        QCOMPARE(model.felt(), 1.0);
        model.receive(Bytes{3, 2, 0, 0, 0, 0});
        QCOMPARE(model.felt(), 0.0);
    }

    void the_model_obeys_its_trigger_and_nothing_else() {
        ModelHapticPad model;
        model.receive(Bytes{2, 4, 100, 0, 0, 0});
        model.receive(Bytes{3, 4, 100, 0, 0});                       // cut short
        for (const std::uint8_t ordinal : Bytes{0, 1, 2, 7, 8, 255}) // none of its list
            model.receive(Bytes{3, ordinal, 100, 0, 0, 0});
        QCOMPARE(model.ticks(), 0ul);
        QCOMPARE(model.waveform(), 0); // none yet
    }
    void the_model_tells_of_fingers_each_8_ms_and_once_that_they_are_gone() {
        ModelHapticPad model;
        const auto told = [&model](int ms) {
            Bytes report, last;
            int count = 0;
            for (int i = 0; i < ms; ++i) {
                model.step();
                for (; model.report(report); ++count)
                    last = report;
            }
            return std::pair(count, last);
        };
        QCOMPARE(told(80).first, 0);
        model.touch(0, {0.0, 0.0});
        QCOMPARE(told(7).first, 0);
        QVERIFY(told(1) ==
                std::pair(1, Bytes{1, 0x01, 0x00, 0x08, 0x00, 0x04, 0, 0x00, 0x08, 0x00, 0x04, 0}));
        for (int i = 1; i < 17; ++i) { // each touch has a number, of four bits
            model.lift(0);
            model.touch(0, {0.0, 0.0});
            QCOMPARE(int(told(8).second.at(1)), (i << 4 | 1) & 0xFF);
        }
        model.lift(0);
        QCOMPARE(told(8).first, 1);
        model.touch(0, {80.0, 50.0}, true); // beside the pad: the nearest that it can tell
        model.touch(1, {-80.0, -50.0}, true);
        QVERIFY(told(80) == std::pair(10, Bytes{1, 0x11, 0xFF, 0x0F, 0, 0, 0x21, 0, 0, 0xFF, 0x07, 1}));
        model.lift(0);
        model.lift(1);
        QVERIFY(told(80) == std::pair(1, Bytes{1, 0x10, 0xFF, 0x0F, 0, 0, 0x20, 0, 0, 0xFF, 0x07, 0}));
    }
    void the_model_tells_its_waveforms_and_how_long_each_is() {
        QCOMPARE(ModelHapticPad().feature(2),
                 (Bytes{0x06, 0x10, 0x03, 0x10, 0x08, 0x10, 0x04, 0x10, 10, 0, 10, 0, 10, 0, 10, 0}));
        QVERIFY(ModelHapticPad().feature(1).empty() && ModelHapticPad().feature(3).empty());
    }
};

} // namespace model_haptic_pad_test

TP_TEST(model_haptic_pad_test, ModelHapticPadTest, nothing)
#include "model_haptic_pad_test.moc"
