// SPDX-License-Identifier: Apache-2.0
#include "audio/sentences/sentence_pattern.hpp"

#include <QTest>

using namespace tp;

namespace {

QString places(const char* pattern, const QString& text, SentencePattern::Strict strict = SentencePattern::Strict::no) {
    const auto found = SentencePattern(pattern).places_in(text, strict);
    if (!found)
        return "does not fit";
    QStringList all;
    for (const QStringView one : *found)
        all << one.toString();
    return all.join(" | ");
}

constexpr auto strictly = SentencePattern::Strict::yes;

} // namespace

class SentencePatternTest : public QObject {
    Q_OBJECT
private slots:
    void what_stands_in_its_places_is_found() {
        QCOMPARE(places("The file \"%1\" is larger than %2 MB.", "The file \"a.svg\" is larger than 64 MB."), "a.svg | 64");
        QCOMPARE(places("%1 became %2", "Anna became Anne"), "Anna | Anne");
        QCOMPARE(places("%1: %2", "a: b: c"), "a | b: c");
        QCOMPARE(places("%1 was %2 in another copy; it is %3 now.", "A was B in another copy; it is C now."), "A | B | C");
    }

    void another_sentence_does_not_fit() {
        QCOMPARE(places("The file %1 is gone.", "The file a is here."), "does not fit");
        QCOMPARE(places("The file %1 is gone.", "A file a is gone."), "does not fit");
        QCOMPARE(places("The file %1 is gone.", "The file"), "does not fit");
        QCOMPARE(places("The file %1 is gone.", ""), "does not fit");
        QCOMPARE(places("%1 is %2 now", "it was b now"), "does not fit");
    }

    void beginning_and_end_do_not_share_letters() {
        QCOMPARE(places("a %1 a", "a a"), "does not fit");
        QCOMPARE(places("a \"%1\"", "a \""), "does not fit");
        QCOMPARE(places("%1 b b %2 b", "a b b b"), "does not fit");
    }

    void a_place_holds_something_unless_it_is_a_name() {
        QCOMPARE(places("a %1 b", "a  b"), "does not fit");
        QCOMPARE(places("%1 b", " b"), "does not fit");
        QCOMPARE(places("a: %1", "a: "), "does not fit");
        QCOMPARE(places("%1 b %2", "x b "), "does not fit");
        QCOMPARE(places("a \"%1\" b", "a \"\" b"), "");
    }

    void a_name_is_what_stands_in_quotation_marks() {
        const SentencePattern pattern("\"%1\" and %2 in \"%3\".");
        QVERIFY(pattern.is_name(0));
        QVERIFY(!pattern.is_name(1));
        QVERIFY(pattern.is_name(2));
    }

    void strictly_a_name_has_no_quotation_marks_and_only_the_last_place_holds_two_sentences() {
        QCOMPARE(places("No \"%1\".", "No \"a\" b\"."), "a\" b");
        QCOMPARE(places("No \"%1\".", "No \"a\" b\".", strictly), "does not fit");
        QCOMPARE(places("No \"%1\".", "No \"a. b\".", strictly), "a. b");
        QCOMPARE(places("No %1.", "No a. No b.", strictly), "does not fit");
        QCOMPARE(places("No %1.", "No a.b!", strictly), "does not fit");
        QCOMPARE(places("No: %1", "No: a. B.", strictly), "a. B.");
    }

    void a_place_is_as_short_as_it_can_be_and_the_last_is_what_remains() {
        QCOMPARE(places("%1 of %2", "a of b of c"), "a | b of c");
        QCOMPARE(places("%1 of %2 now", "a of b now of c now"), "a | b now of c");
    }

    void what_stands_in_a_place_is_not_looked_into() {
        QCOMPARE(with_places("%2 by %1, %1", {"%2", "%1"}), "%1 by %2, %2");
        QCOMPARE(with_places("100 % of %3, %%1 %", {"a"}), "100 % of %3, %a %");
    }

    void the_one_that_says_more_weighs_more() {
        QCOMPARE(SentencePattern("The %1 of %2.").letters_before(), 4);
        QVERIFY(SentencePattern("The recording \"%1\" cannot be used: %2").weight() >
                SentencePattern("\"%1\" cannot be used: %2").weight());
        QCOMPARE(SentencePattern("%1: %2").weight(), 2);
        QVERIFY(!SentencePattern("The disk is full.").has_places());
    }
};

QTEST_GUILESS_MAIN(SentencePatternTest)
#include "sentence_pattern_test.moc"
