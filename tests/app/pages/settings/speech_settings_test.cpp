// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/speech_settings.hpp"
#include "setting_ground.hpp"
#include "test_program.hpp"

namespace speech_settings_test {

using namespace tp;

class SpeechSettingsTest : public QObject {
    Q_OBJECT
private slots:
    void every_choice_is_kept_said_and_taken_back() {
        SettingGround ground;
        SpeechSettings speech(ground.steps);
        ground.try_each({[&] { speech.chooseVoice(1); }, [&] { speech.chooseRate(4); },
                         [&] { speech.chooseLanguage(3); }, [&] { speech.setPlaybackSpeed(1.5); },
                         [&] { speech.setEarcons(false); }, [&] { speech.chooseDescriptions(2); },
                         [&] { speech.chooseDescribedFirst(1); }});
    }
    void descriptions_are_chosen_by_length_and_by_what_is_first() {
        SettingGround ground;
        SpeechSettings speech(ground.steps);
        QCOMPARE(speech.descriptions(), 1);
        speech.chooseDescriptions(0);
        QVERIFY(ground.now().descriptions == Choices::Descriptions::none);
        QCOMPARE(ground.last(), QString("Only what people wrote about a photograph is said."));
        speech.chooseDescriptions(3);
        speech.chooseDescriptions(-1);
        QCOMPARE(speech.descriptions(), 0);
        QCOMPARE(speech.describedFirst(), 0);
        speech.chooseDescribedFirst(1);
        QVERIFY(ground.now().place_first);
        QCOMPARE(ground.last(), QString("Time and place come first."));
    }
    void the_new_language_is_said_by_its_own_name() {
        SettingGround ground;
        SpeechSettings speech(ground.steps);
        QCOMPARE(speech.language(), 0);
        speech.chooseLanguage(2);
        QCOMPARE(ground.last(), QString("Deutsch."));
        QCOMPARE(ground.now().language, QString("de"));
        QCOMPARE(speech.language(), 2);
    }
    void what_is_out_of_bounds_is_not_taken() {
        SettingGround ground;
        SpeechSettings speech(ground.steps);
        for (const int index : {-1, 99}) {
            speech.chooseVoice(index);
            speech.chooseRate(index);
            speech.chooseLanguage(index);
        }
        QCOMPARE(ground.now(), Choices{});
        speech.setPlaybackSpeed(40.0);
        QCOMPARE(ground.now().playback_speed, 2.0);
    }
};

} // namespace speech_settings_test

TP_TEST(speech_settings_test, SpeechSettingsTest, event_loop)
#include "speech_settings_test.moc"
