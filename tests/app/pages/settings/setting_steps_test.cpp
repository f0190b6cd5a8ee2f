// SPDX-License-Identifier: Apache-2.0
#include "setting_ground.hpp"
#include "test_program.hpp"

namespace setting_steps_test {

using namespace tp;

class SettingStepsTest : public QObject {
    Q_OBJECT
private slots:
    void a_step_is_kept_said_and_taken_back() {
        SettingGround ground;
        const auto brows = [&] {
            ground.steps.make("brows", "Brows are felt.", [](Choices& choices) { choices.brows = true; });
        };
        ground.try_each({brows});
        ground.steps.undo();
        QCOMPARE(ground.last(), QString("There is nothing to undo."));
        brows();
        QCOMPARE(ground.steps.undoable(), QString("brows"));
        QCOMPARE(ground.last(), QString("Brows are felt."));
    }
    void a_slider_that_is_moved_on_is_one_step() {
        SettingGround ground;
        for (const double force : {0.9, 0.8, 0.7})
            ground.steps.make("the force", "Weaker.",
                              [force](Choices& choices) { choices.max_force_n = force; });
        ground.steps.undo();
        QCOMPARE(ground.now().max_force_n, Choices{}.max_force_n);
    }
    void the_reset_keeps_folders_language_and_place_and_is_taken_back() {
        SettingGround ground;
        Choices choices;
        choices.asked = true;
        choices.folders = QStringList{"/photos"};
        choices.last_photo = "/photos/1.jpg";
        choices.language = "de";
        Choices expected = choices;
        choices.theme = Choices::Theme::light;
        choices.max_force_n = 0.2;
        ground.preferences.set(choices);
        ground.steps.reset();
        QCOMPARE(ground.now(), expected);
        ground.steps.undo();
        QCOMPARE(ground.now(), choices);
    }
    void undo_leaves_one_where_one_is() {
        SettingGround ground;
        ground.steps.make("the nose", "Felt.", [](Choices& choices) { choices.nose = true; });
        ground.preferences.change([](Choices& choices) { choices.last_photo = "/photos/2.jpg"; });
        ground.steps.undo();
        QCOMPARE(ground.now().last_photo, QString("/photos/2.jpg"));
        QVERIFY(!ground.now().nose);
    }
};

} // namespace setting_steps_test

TP_TEST(setting_steps_test, SettingStepsTest, event_loop)
#include "setting_steps_test.moc"
