// SPDX-License-Identifier: Apache-2.0
#include "app/parts/controls/recording_announcer.hpp"
#include "app/shell/shell.hpp"
#include "audio/speech/recording_voice.hpp"

#include <QSignalSpy>
#include <QTest>

using namespace tp;

class ShellTest : public QObject {
    Q_OBJECT
private slots:
    void init() { happened_.clear(); }

    void a_page_is_left_before_another_is_entered() {
        Shell shell(narrator_);
        fill(shell);
        shell.goHome();
        shell.open("b");
        QCOMPARE(happened_, QStringList({"enter a", "leave a", "enter b"}));
        QCOMPARE(shell.title(), QString("Page b"));
        shell.open("nowhere");
        QCOMPARE(shell.page(), QString("b"));
    }

    void back_goes_the_way_one_came_and_ends_at_home() {
        Shell shell(narrator_);
        fill(shell);
        for (const char* page : {"a", "b", "c", "c", "b"})
            shell.open(page);
        QStringList way;
        for (int i = 0; i < 5; ++i) {
            shell.back();
            way << shell.page();
        }
        QCOMPARE(way, QStringList({"c", "b", "a", "a", "a"}));
        QVERIFY(shell.home());
        shell.open("b");
        shell.goHome();
        shell.back();
        QCOMPARE(shell.page(), QString("a")); // home forgets the way
    }

    void help_says_the_pages_words_and_the_keys_that_hold_everywhere() {
        Shell shell(narrator_);
        fill(shell);
        shell.open("b");
        shell.help("Press 7.");
        QVERIFY(voice_.said().back().startsWith("Page b. Press 7. On every page: Escape"));
        const QString help = voice_.said().back();
        shell.repeat();
        QCOMPARE(voice_.said().count(help), 2);
        QCOMPARE(shell.sentence(), help);
    }

    void the_voice_is_switched_from_everywhere_and_that_is_told() {
        Shell shell(narrator_);
        fill(shell);
        QSignalSpy toggled(&shell, &Shell::voice_toggled);
        shell.toggleVoice();
        QCOMPARE(announcer_.announced().back(), QString("Voice off."));
        shell.toggleVoice();
        QCOMPARE(voice_.said().back(), QString("Voice on."));
        QCOMPARE(toggled.count(), 2);
        QCOMPARE(toggled[0].first().toBool(), false);
    }

private:
    void fill(Shell& shell) {
        for (const char* name : {"a", "b", "c"})
            shell.add({name, [name] { return QString("Page ") + name; },
                       [this, name] { happened_ << QString("enter ") + name; },
                       [this, name] { happened_ << QString("leave ") + name; }});
    }
    QStringList happened_;
    RecordingVoice voice_;
    RecordingAnnouncer announcer_;
    Narrator narrator_{voice_, announcer_};
};

QTEST_GUILESS_MAIN(ShellTest)
#include "shell_test.moc"
