// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/look_settings.hpp"
#include "setting_ground.hpp"
#include "test_program.hpp"

namespace look_settings_test {

using namespace tp;

class LookSettingsTest : public QObject {
    Q_OBJECT
private slots:
    void every_choice_is_kept_said_and_taken_back() {
        SettingGround ground;
        LookSettings looks(ground.steps);
        ground.try_each({[&] { looks.chooseUser(1); }, [&] { looks.chooseTheme(2); },
                         [&] { looks.setTextScale(2); }, [&] { looks.setMotion(false); }});
    }
    void what_is_out_of_bounds_is_not_taken() {
        SettingGround ground;
        LookSettings looks(ground.steps);
        for (const int index : {-1, 99}) {
            looks.chooseUser(index);
            looks.chooseTheme(index);
        }
        QCOMPARE(ground.now(), Choices{});
        looks.setTextScale(9.0);
        QCOMPARE(ground.now().text_scale, 2.0);
    }
};

} // namespace look_settings_test

TP_TEST(look_settings_test, LookSettingsTest, event_loop)
#include "look_settings_test.moc"
