// SPDX-License-Identifier: Apache-2.0
#include "whole_program.hpp"

#include <QTest>

using namespace tp;

namespace {
constexpr int patience_ms = 60000; ///< for a busy machine
} // namespace

/// An album that nobody has filled speaks: what the real program sees on the sample portraits is said, found and
/// suggested.
class DescribedTest : public QObject {
    Q_OBJECT

    static void choose(WholeProgram& whole, const std::function<void(Choices&)>& change) {
        whole.program->preferences().change(change);
    }
    static QString summary(WholeProgram& whole) { return whole.program->browse().details()->summary(); }
    static std::size_t found(WholeProgram& whole, const char* typed) {
        const auto photos = whole.program->album().queries().search(typed, 10);
        return photos ? photos->size() : 0;
    }
    static void show(WholeProgram& whole, const char* name) {
        QVERIFY(whole.program->browse().trail()->show(whole.folder.filePath(QString("Family/") + name)));
    }

private slots:
    void an_empty_album_says_what_is_on_its_photographs() {
        WholeProgram whole;
        whole.shell().open("browse");
        QTRY_VERIFY_WITH_TIMEOUT(found(whole, "one person") == 2 && found(whole, "two people") == 1,
                                 patience_ms);
        show(whole, "ben_and_clara.jpg");
        QTRY_VERIFY_WITH_TIMEOUT(summary(whole).startsWith("Two people"), patience_ms);
        show(whole, "anna_smiling.jpg");
        QTRY_VERIFY_WITH_TIMEOUT(
            summary(whole).startsWith("One person, ") && summary(whole).contains("smiling"), patience_ms);
        QVERIFY2(!summary(whole).contains(".jpg"), qPrintable(summary(whole)));
    }

    void another_language_and_another_length_hold_at_once() {
        WholeProgram whole;
        whole.shell().open("browse");
        QTRY_VERIFY_WITH_TIMEOUT(found(whole, "two people") == 1, patience_ms);
        choose(whole, [](Choices& choices) {
            choices.language = "de";
            choices.descriptions = Choices::Descriptions::full;
        });
        QTRY_VERIFY_WITH_TIMEOUT(found(whole, "zwei Personen") == 1 && found(whole, "people") == 0,
                                 patience_ms);
        whole.shell().goHome();
        whole.shell().open("browse");
        show(whole, "ben_and_clara.jpg");
        QTRY_VERIFY_WITH_TIMEOUT(summary(whole).startsWith("Zwei Personen: eine links"), patience_ms);
    }

    void who_wants_none_has_nobody_look() {
        Choices choices = WholeProgram::asked();
        choices.descriptions = Choices::Descriptions::none;
        WholeProgram whole(choices);
        whole.shell().open("browse");
        QTRY_VERIFY_WITH_TIMEOUT(
            !whole.program->album().scanning() && whole.program->browse().trail()->ready(), patience_ms);
        show(whole, "ben_and_clara.jpg");
        QTest::qWait(300);
        QCOMPARE(summary(whole), QString("ben_and_clara.jpg; no recordings yet."));
        QCOMPARE(found(whole, "two people"), std::size_t(0));
    }

    void care_suggests_what_is_seen() {
        WholeProgram whole;
        whole.program->album();
        whole.shell().open("care");
        whole.program->care().open_photo(whole.folder.filePath("Family/ben_and_clara.jpg").toStdU16String());
        QTRY_VERIFY_WITH_TIMEOUT(
            whole.program->care().draft()->text().startsWith("Two people: one at the left"), patience_ms);
    }
};

QTEST_MAIN(DescribedTest)
#include "described_test.moc"
