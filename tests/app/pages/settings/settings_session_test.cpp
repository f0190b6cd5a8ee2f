// SPDX-License-Identifier: Apache-2.0
#include "settings_bench.hpp"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace tp;

class SettingsSessionTest : public QObject {
    Q_OBJECT
private slots:
    void every_choice_is_kept_said_and_taken_back() {
        SettingsBench bench;
        SettingsSession& session = bench.session;
        const std::vector<std::function<void()>> changes{
            [&] { session.chooseVoice(1); }, [&] { session.chooseRate(4); },        [&] { session.chooseLanguage(3); },
            [&] { session.chooseUser(1); },  [&] { session.chooseTheme(2); },       [&] { session.chooseGuide(0); },
            [&] { session.setTextScale(2); }, [&] { session.setPlaybackSpeed(1.5); }, [&] { session.setMaxForce(0.4); },
            [&] { session.setMotion(false); }, [&] { session.setEarcons(false); },  [&] { session.setBrows(true); },
            [&] { session.setNose(true); },  [&] { session.setIrises(true); }};
        for (std::size_t i = 0; i < changes.size(); ++i) {
            const Choices before = bench.now();
            bench.voice.clear();
            changes[i]();
            QVERIFY2(bench.now() != before, qPrintable(QString::number(i)));
            QVERIFY2(!bench.voice.said().isEmpty(), qPrintable(QString::number(i)));
            changes[i](); // the same again is no change
            session.undo();
            QVERIFY2(bench.now() == before, qPrintable(QString::number(i)));
            QVERIFY(bench.voice.said().back().startsWith("Taken back: "));
        }
        QVERIFY(session.undoable().isEmpty());
        session.undo();
        QCOMPARE(bench.voice.said().back(), QString("There is nothing to take back."));
    }

    void a_slider_that_is_moved_on_is_one_step() {
        SettingsBench bench;
        for (const double force : {0.9, 0.8, 0.7})
            bench.session.setMaxForce(force);
        bench.session.undo();
        QCOMPARE(bench.now().max_force_n, Choices{}.max_force_n);
    }

    void what_is_out_of_bounds_is_not_taken() {
        SettingsBench bench;
        for (const int index : {-1, 99}) {
            bench.session.chooseVoice(index);
            bench.session.chooseRate(index);
            bench.session.chooseLanguage(index);
            bench.session.chooseUser(index);
            bench.session.chooseTheme(index);
            bench.session.chooseGuide(index);
            bench.session.removeFolder(index);
        }
        QCOMPARE(bench.now(), Choices{});
        bench.session.setMaxForce(40.0);
        QCOMPARE(bench.now().max_force_n, 1.5);
        bench.session.setTextScale(9.0);
        QCOMPARE(bench.now().text_scale, 2.0);
    }

    void folders_come_and_go_and_come_back() {
        const QTemporaryDir folder;
        SettingsBench bench;
        bench.session.addFolder();
        QVERIFY(bench.session.choosing());
        bench.session.chooser()->begin_in(folder.path());
        bench.session.chooser()->choose();
        QVERIFY(!bench.session.choosing());
        QCOMPARE(bench.now().folders, QStringList(QDir(folder.path()).absolutePath()));
        bench.session.addFolder();
        bench.session.chooser()->begin_in(folder.path());
        bench.session.chooser()->choose();
        QCOMPARE(bench.now().folders.size(), 1);
        QCOMPARE(bench.voice.said().back(), QString("The album has this folder already."));
        bench.session.removeFolder(0);
        QVERIFY(bench.now().folders.isEmpty());
        QVERIFY(bench.voice.said().back().contains("stay where they are"));
        bench.session.undo();
        QCOMPARE(bench.now().folders.size(), 1);
        bench.session.addFolder();
        QVERIFY(bench.session.back());
        QVERIFY(!bench.session.back());
        QCOMPARE(bench.voice.said().back(), QString("No folder was chosen."));
    }

    void the_reset_keeps_folders_language_and_place_and_is_taken_back() {
        SettingsBench bench;
        Choices choices;
        choices.asked = true;
        choices.folders = {"/photos"};
        choices.last_photo = "/photos/1.jpg";
        choices.language = "de";
        Choices expected = choices;
        choices.theme = Choices::Theme::light;
        choices.max_force_n = 0.2;
        bench.preferences.set(choices);
        bench.session.reset();
        QCOMPARE(bench.now(), expected);
        bench.session.undo();
        QCOMPARE(bench.now(), choices);
    }

    void undo_leaves_one_where_one_is() {
        SettingsBench bench;
        bench.session.chooseTheme(1);
        bench.preferences.change([](Choices& choices) { choices.last_photo = "/photos/2.jpg"; });
        bench.session.undo();
        QCOMPARE(bench.now().last_photo, QString("/photos/2.jpg"));
        QCOMPARE(bench.now().theme, Choices::Theme::dark);
    }

    void what_is_stored_is_said_and_the_index_can_go() {
        SettingsBench bench;
        bench.preferences.change([](Choices& choices) {
            choices.folders = {"/photos"};
            choices.last_photo = "/photos/2.jpg";
        });
        const QString all = bench.session.stored().join('\n');
        for (const char* part : {"preferences.json", "/nowhere", "/photos", "/photos/2.jpg", "Nothing leaves this computer"})
            QVERIFY2(all.contains(part), part);
        bench.session.discardIndex();
        QCOMPARE(bench.discarded, 1);
        QVERIFY(bench.voice.said().back().contains("thrown away"));
    }
};

QTEST_GUILESS_MAIN(SettingsSessionTest)
#include "settings_session_test.moc"
