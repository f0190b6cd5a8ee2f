// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/language_runs.hpp"

#include <QTest>

#include <random>

using namespace tp;

namespace {

/// "de:Anna und |ru:Иван"
QString told(const QString& text, const QString& language) {
    QStringList parts;
    for (const LanguageRun& run : language_runs(text, language))
        parts << run.language + ':' + run.text;
    return parts.join('|');
}

} // namespace

class LanguageRunsTest : public QObject {
    Q_OBJECT
private slots:
    void names_keep_their_language_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* name, const char* language, const char* text, const char* expected) {
            QTest::newRow(name) << language << QString::fromUtf8(text) << QString::fromUtf8(expected);
        };
        row("nothing", "de", "", "");
        row("Latin", "de", "Jürgen und Zoë, Mai 2026; 3 Aufnahmen.", "de:Jürgen und Zoë, Mai 2026; 3 Aufnahmen.");
        row("Russian", "de", "Anna und Иван, Mai 2026.", "de:Anna und |ru:Иван, |de:Mai 2026.");
        row("a number after a name", "en", "Иван; 3 recordings.", "ru:Иван; |en:3 recordings.");
        row("Ukrainian by its letters", "en", "Next: Андрій.", "en:Next: |uk:Андрій.");
        row("Russian in Ukrainian", "uk", "Далі: Иван.", "uk:Далі: Иван.");
        row("Korean", "en", "박지민 in the garden.", "ko:박지민 |en:in the garden.");
        row("Latin in Korean", "ko", "Anna 와 박지민", "ko:Anna 와 박지민");
        row("Japanese begins with kanji", "en", "山田さん smiles.", "ja:山田さん |en:smiles.");
        row("Japanese ends with kanji", "en", "アンナ山田 smiles.", "ja:アンナ山田 |en:smiles.");
        row("Chinese", "en", "王小明 smiles.", "zh:王小明 |en:smiles.");
        row("Persian by its letters", "en", "پروین", "fa:پروین");
        row("two names", "en", "Γιώργος, דוד", "el:Γιώργος, |he:דוד");
        row("a bracket before", "en", "(Иван)", "ru:(Иван)");
        row("marks alone", "en", "…?", "en:…?");
        row("beyond 16 bits", "en", "𠮷 smiles.", "zh:𠮷 |en:smiles.");
        row("a combining mark", "en", "Zoe\xCC\x88 smiles.", "en:Zoe\xCC\x88 smiles.");
    }
    void names_keep_their_language() {
        QFETCH(QString, language);
        QFETCH(QString, text);
        QFETCH(QString, expected);
        QCOMPARE(told(text, language), expected);
    }

    void nothing_is_lost_and_no_part_is_empty() {
        std::mt19937 random(1);
        const QString letters = QString::fromUtf8("aZ 1.,(я ІГ한あ漢א א\nع…é");
        for (int i = 0; i < 3000; ++i) {
            QString text;
            for (int n = static_cast<int>(random() % 20); n > 0; --n)
                text += letters[static_cast<int>(random() % static_cast<unsigned>(letters.size()))];
            QString together, before;
            for (const LanguageRun& run : language_runs(text, i % 2 == 0 ? "de" : "ko")) {
                QVERIFY(!run.text.isEmpty());
                QVERIFY2(run.language != before, qPrintable(text));
                together += run.text;
                before = run.language;
            }
            QCOMPARE(together, text);
        }
    }
};

QTEST_GUILESS_MAIN(LanguageRunsTest)
#include "language_runs_test.moc"
