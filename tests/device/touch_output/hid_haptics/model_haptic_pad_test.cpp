// SPDX-License-Identifier: Apache-2.0
// The model, of which nothing is read back through what it is to try.
#include "../../descriptor_lines.hpp"
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"

#include <QTest>

#include <cstdint>
#include <string>
#include <vector>

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
    }

    void the_model_plays_as_long_as_it_is_told() {
        ModelHapticPad model;
        for (const int again : {0, 2}) { // once, and again so often
            model.receive(Bytes{3, 4, 100, static_cast<std::uint8_t>(again), 0, 0});
            int ms = 0;
            for (; model.felt() > 0.0 && ms < 1000; ++ms)
                model.step();
            QCOMPARE(ms, 10 * (1 + again));
        }
    }

    void the_model_tells_its_waveforms_and_how_long_each_is() {
        QCOMPARE(ModelHapticPad().feature(2),
                 (Bytes{0x06, 0x10, 0x03, 0x10, 0x08, 0x10, 0x04, 0x10, 10, 0, 10, 0, 10, 0, 10, 0}));
        QVERIFY(ModelHapticPad().feature(1).empty() && ModelHapticPad().feature(3).empty());
    }
};

QTEST_APPLESS_MAIN(ModelHapticPadTest)
#include "model_haptic_pad_test.moc"
