// SPDX-License-Identifier: Apache-2.0
#include "app/parts/preferences/preferences.hpp"
#include "choices_check.hpp"
#include "places.hpp"
#include "svg_mutants.hpp"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

using namespace tp;

namespace {

Choices unusual() {
    Choices choices;
    choices.asked = true;
    choices.voice = Choices::Voice::screen_reader;
    choices.rate = Choices::Rate::very_fast;
    choices.user = Choices::User::caregiver;
    choices.language = "ko";
    choices.theme = Choices::Theme::yellow_on_black;
    choices.text_scale = 2.0;
    choices.motion = false;
    choices.earcons = false;
    choices.guide = Choices::Guide::ticks_and_sonar;
    choices.max_force_n = 0.3;
    choices.shutter_by_itself = false;
    choices.keep_moment = choices.capture_told = true;
    choices.playback_speed = 1.5;
    choices.brows = choices.nose = choices.irises = true;
    choices.folders = {"/photos/Familie Müller", "/사진"};
    choices.last_photo = "/사진/1.jpg";
    choices.touch = "PAD-7";
    choices.touch_strength = 0.2;
    choices.touch_sharpness = 0.9;
    choices.touch_latency_s = 0.04;
    choices.touch_latencies_s = {{"PAD-7", 0.008}, {"motor:/dev/input/event3", 0.0}};
    choices.device = "TP-1";
    return choices;
}

std::filesystem::path in(const QTemporaryDir& folder, const char* name) {
    return std::filesystem::path(folder.path().toStdString()) / name;
}

} // namespace

class PreferencesTest : public QObject {
    Q_OBJECT
private slots:
    void every_choice_survives_being_written_and_read() {
        QCOMPARE(choices_from(json_of(unusual()), {}), unusual());
        QCOMPARE(choices_from(json_of({}), unusual()), Choices{});
    }

    void what_makes_no_sense_is_left_as_it_was() {
        const QByteArray text = R"({"text_scale": 9, "max_force_n": -1, "voice": "loud", "motion": "no",
            "album_folders": "x", "speech_rate": 3, "playback_speed": "NaN", "theme": "light"})";
        Choices expected = unusual();
        expected.theme = Choices::Theme::light;
        bool spoilt = true;
        QCOMPARE(choices_from(text, unusual(), &spoilt), expected);
        QVERIFY(!spoilt);
        QCOMPARE(choices_from("[1, 2", unusual(), &spoilt), unusual());
        QVERIFY(spoilt);
    }

    void a_latency_that_makes_no_sense_is_not_taken_and_others_are() {
        const Choices read = choices_from(
            R"({"touch_latencies_s": {"A": 0.02, "B": 9, "C": -1, "D": "late", "E": [0.1]}})", unusual());
        QCOMPARE(read.touch_latencies_s, (QMap<QString, double>{{"A", 0.02}}));
        QCOMPARE(choices_from(R"({"touch_latencies_s": 0.1})", unusual()), unusual());
    }

    void an_output_is_as_late_as_it_was_measured_else_as_all_were_else_as_it_says() {
        Choices choices;
        QCOMPARE(touch_latency_s(choices, "A", 0.03), 0.03);
        choices.touch_latency_s = 0.1; // from when there was one for all
        QCOMPARE(touch_latency_s(choices, "A", 0.03), 0.1);
        choices.touch_latencies_s["A"] = 0.0;
        QCOMPARE(touch_latency_s(choices, "A", 0.03), 0.0);
        QCOMPARE(touch_latency_s(choices, "B", 0.03), 0.1);
    }

    void speech_rates_rise_within_what_a_voice_takes() {
        double before = -1.0;
        for (const auto rate : {Choices::Rate::very_slow, Choices::Rate::slow, Choices::Rate::normal,
                                Choices::Rate::fast, Choices::Rate::very_fast}) {
            QVERIFY(speech_rate(rate) > before && speech_rate(rate) < 1.0);
            before = speech_rate(rate);
        }
        QCOMPARE(speech_rate(Choices::Rate::normal), 0.0);
    }

    void they_are_there_again_at_the_next_start_and_only_for_their_owner() {
        const QTemporaryDir folder;
        const std::filesystem::path file = in(folder, "new folder/preferences.json");
        {
            Preferences preferences(file);
            QVERIFY(!preferences.choices().asked);
            QSignalSpy changed(&preferences, &Preferences::changed);
            preferences.set(unusual());
            preferences.set(unusual());
            QCOMPARE(changed.count(), 1);
        }
        QCOMPARE(Preferences(file).choices(), unusual());
        QCOMPARE(std::filesystem::status(file).permissions(),
                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    }

    void many_changes_are_one_write_soon_after() {
        const QTemporaryDir folder;
        const std::filesystem::path file = in(folder, "preferences.json");
        Preferences preferences(file);
        preferences.change([](Choices& choices) { choices.max_force_n = 0.5; });
        preferences.change([](Choices& choices) { choices.max_force_n = 0.7; });
        QVERIFY(!std::filesystem::exists(file));
        QTRY_VERIFY(std::filesystem::exists(file));
        QCOMPARE(Preferences(file).choices().max_force_n, 0.7);
    }

    void a_spoilt_file_is_set_aside_and_told() {
        const QTemporaryDir folder;
        const std::filesystem::path file = in(folder, "preferences.json");
        QFile spoilt(QString::fromStdString(file.string()));
        QVERIFY(spoilt.open(QIODevice::WriteOnly));
        spoilt.write("{\"asked\": tr");
        spoilt.close();
        const Preferences preferences(file);
        QCOMPARE(preferences.choices(), Choices{});
        QVERIFY(preferences.notice().contains("set aside"));
        QVERIFY(std::filesystem::exists(in(folder, "preferences.json.aside")));
    }

    void a_disk_that_does_not_take_them_costs_a_sentence() {
        const QTemporaryDir folder;
        QFile in_the_way(folder.filePath("file"));
        QVERIFY(in_the_way.open(QIODevice::WriteOnly));
        Preferences preferences(in(folder, "file/preferences.json"));
        preferences.set(unusual());
        QVERIFY(preferences.keep().startsWith("Your settings could not be saved: "));
        QCOMPARE(preferences.choices(), unusual());
    }

    void hostile_preferences() {
        const auto files = tp::test::corpus(tp::test::in_source("tests/app/parts/preferences/corpus"));
        QVERIFY(files.size() >= 4);
        for (const auto& file : files)
            QCOMPARE(tp::test::complaint_about_choices(file.text), std::string());
    }
};

QTEST_GUILESS_MAIN(PreferencesTest)
#include "preferences_test.moc"
