// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/feeling_settings.hpp"
#include "setting_ground.hpp"
#include "test_program.hpp"

namespace feeling_settings_test {

using namespace tp;

namespace {

/// With no force device at all.
struct FeelingBench : SettingGround {
    DeviceSettings devices{narrator, preferences, {}};
    FeelingSettings feeling{steps, devices};
};

} // namespace

class FeelingSettingsTest : public QObject {
    Q_OBJECT
private slots:
    void every_choice_is_kept_said_and_taken_back() {
        FeelingBench bench;
        FeelingSettings& feeling = bench.feeling;
        bench.try_each({[&] { feeling.chooseGuide(0); }, [&] { feeling.setMaxForce(0.4); },
                        [&] { feeling.setBrows(true); }, [&] { feeling.setNose(true); },
                        [&] { feeling.setIrises(true); }, [&] { feeling.chooseDevice(0); }});
    }
    void what_is_out_of_bounds_is_not_taken() {
        FeelingBench bench;
        for (const int index : {-1, 99}) {
            bench.feeling.chooseGuide(index);
            bench.feeling.chooseDevice(index);
        }
        QCOMPARE(bench.now(), Choices{});
        bench.feeling.setMaxForce(40.0);
        QCOMPARE(bench.now().max_force_n, 1.5);
    }
};

} // namespace feeling_settings_test

TP_TEST(feeling_settings_test, FeelingSettingsTest, event_loop)
#include "feeling_settings_test.moc"
