// SPDX-License-Identifier: Apache-2.0
#include "browse_parts.hpp"
#include "test_program.hpp"

#include <QString>
#include <QStringList>
#include <QTest>

namespace browse_trail_test {

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;
using Topic = BrowseLists::Topic;

class BrowseTrailTest : public QObject {
    Q_OBJECT
private slots:
    void one_photograph_after_the_other_with_sounds_that_say_so() {
        PartsAtGarden bench;
        bench.trail().next();
        QCOMPARE(bench.said(), QString("Anna and Ben, June 2026; 1 recording(s)."));
        QCOMPARE(bench.earcon(), Earcon::next);
        QCOMPARE(bench.trail().placeText(), QString("5 of 5"));
        bench.trail().next();
        QCOMPARE(bench.said(), QString("This is the last photograph."));
        QCOMPARE(bench.earcon(), Earcon::list_end);
        bench.trail().previous();
        QCOMPARE(bench.said(), garden_words);
        QCOMPARE(bench.earcon(), Earcon::previous);
        bench.trail().first();
        QCOMPARE(bench.trail().placeText(), QString("1 of 5"));
        bench.trail().previous();
        QCOMPARE(bench.said(), QString("This is the first photograph."));
        bench.trail().last();
        QCOMPARE(bench.trail().placeText(), QString("5 of 5"));
    }

    void surprise_is_another_photograph_among_all() {
        PartsAtGarden bench;
        bench.lists().openTopic(Topic::People);
        bench.lists().choose(0);
        for (int i = 0; i < 5; ++i) {
            const QString before = bench.trail().photo();
            bench.trail().surprise();
            QVERIFY(bench.trail().photo() != before);
            QCOMPARE(bench.said(), bench.details().summary());
            QCOMPARE(bench.trail().count(), 5);
            QCOMPARE(bench.trail().title(), QString("All photographs"));
        }
    }

    void where_one_was_is_gone_one_begins_at_the_first() {
        PartsAtGarden bench;
        bench.parts.reset();
        bench.drawn.preferences.change([](Choices& choices) { choices.last_photo = "/nowhere/x.jpg"; });
        bench.start();
        QCOMPARE(bench.trail().placeText(), QString("1 of 5"));
        bench.trail().next();
        QCOMPARE(bench.drawn.preferences.choices().last_photo, bench.trail().photo());
    }

    void a_photograph_that_is_renamed_stays_without_a_word() {
        PartsAtGarden bench;
        const fs::path there = bench.drawn.root() / "Anna and Tom.jpg";
        fs::rename(bench.five.garden, there);
        QTRY_COMPARE(bench.trail().photo(), QString::fromStdString(there.string()));
        QTRY_COMPARE(bench.details().summary(), garden_words); // what belongs to it has followed
        QVERIFY(bench.voice.said().filter("gone").isEmpty());
    }

    void who_comes_to_a_photograph_hears_of_it_when_all_is_known() {
        PartsAtGarden bench;
        QStringList heard;
        connect(&bench.trail(), &BrowseTrail::shown_anew, this, [&](bool another, bool backwards) {
            heard << QString("%1 %2").arg(another ? "another" : "same", backwards ? "backwards" : "on");
        });
        connect(&bench.trail(), &BrowseTrail::photoChanged, this,
                [&] { heard << bench.details().summary(); });
        bench.trail().previous();
        QCOMPARE(heard, QStringList({"another backwards", "August 2025; no recordings yet."}));
        heard.clear();
        bench.trail().show_here();
        QCOMPARE(heard, QStringList({"same on", "August 2025; no recordings yet."}));
        QVERIFY(!bench.trail().show("/nowhere/x.jpg"));
    }

    void out_of_sight_nothing_is_told() {
        PartsAtGarden bench;
        bench.trail().leave();
        QVERIFY(bench.trail().show(QString::fromStdString(bench.five.walk.string())));
        QCOMPARE(bench.voice.said(), QStringList());
        QCOMPARE(bench.trail().placeText(), QString("5 of 5"));
    }
};

} // namespace browse_trail_test

TP_TEST(browse_trail_test, BrowseTrailTest, window)
#include "browse_trail_test.moc"
