// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/language_runs.hpp"
#include "test_program.hpp"

#include <QTest>

#include <random>

namespace language_runs_test {

using namespace tp;

namespace {

/// "de:Anna und |ru:Иван"
QString told(const QString& text, const QString& language, const SpokenNames& names = {}) {
    QStringList parts;
    for (const LanguageRun& run : language_runs(text, language, names))
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

    void known_names_are_of_their_own_language_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* name, const char* language, const char* text, const char* expected) {
            QTest::newRow(name) << language << QString::fromUtf8(text) << QString::fromUtf8(expected);
        };
        row("alone", "en", "Giulia", "it:Giulia");
        row("marks stay with it", "de", "Anna und José, Mai 2026.", "de:Anna und |es:José, |de:Mai 2026.");
        row("a bracket before", "en", "(Giulia)", "it:(Giulia)");
        row("its own language", "it", "Giulia, Mai 2026.", "it:Giulia, Mai 2026.");
        row("another country's", "en", "With Kate.", "en:With Kate.");
        row("a country's", "de", "Mit Kate.", "de:Mit |en-GB:Kate.");
        row("the longest", "en", "Giulia Maria smiles.", "pl:Giulia Maria |en:smiles.");
        row("two words in another order", "en", "Maria Giulia smiles.", "en:Maria |it:Giulia |en:smiles.");
        row("within a word", "en", "Giulias, aGiulia, Giulia2, Giulia\xCC\x80", "en:Giulias, aGiulia, Giulia2, Giulia\xCC\x80");
        row("a part of a name of two", "en", "Anne-Giulia, Giulia-Anne", "en:Anne-|it:Giulia, Giulia-|en:Anne");
        row("an apostrophe in a word", "en", "O'Kate, Giulia\xE2\x80\x99s", "en:O'Kate, Giulia\xE2\x80\x99s");
        row("quotation marks", "en", "'Giulia'.", "it:'Giulia'.");
        row("another case", "en", "GIULIA", "en:GIULIA");
        row("a Korean ending", "ko", "Giulia와 Tom", "it:Giulia|ko:와 Tom");
        row("two at once", "en", "Giulia José", "it:Giulia |es:José");
        row("two of one language", "en", "Giulia, Luca smile.", "it:Giulia, Luca |en:smile.");
        row("another than its script's", "en", "Next: Иван.", "en:Next: |bg:Иван.");
        row("letters of another language in it", "en", "Мирослав і", "sr:Мирослав |uk:і");
        row("its script's where it is the sentence's", "de", "Павел", "ru:Павел");
        row("in another script, the sentence's language", "de", "Mit Ганс.", "de:Mit |ru:Ганс.");
        row("with a digit", "en", "R2 D2 beeps", "fr:R2 D2 |en:beeps");
        row("beyond 16 bits", "en", "𠮷 smiles, a𠮷 too", "ko:𠮷 |en:smiles, a|ko:𠮷 |en:too");
        row("kana after it", "en", "山田さん", "ko:山田|ja:さん");
        row("kana after a Chinese one", "en", "王小明さん", "zh:王小明|ja:さん");
    }
    void known_names_are_of_their_own_language() {
        const auto name = [](const char* text, const char* language) {
            return SpokenName{QString::fromUtf8(text), language};
        };
        const SpokenNames names{name("Giulia", "it"),  name("José", "es"),    name("Giulia Maria", "pl"),
                                name("Kate", "en-GB"), name("Иван", "bg"),    name("Мирослав", "sr"),
                                name("Павел", "ru"),   name("Ганс", "de"),    name("R2 D2", "fr"),
                                name("𠮷", "ko"),      name("山田", "ko"),    name("Luca", "it"),
                                name("王小明", "zh"),
                                name("", "fr")};
        QFETCH(QString, language);
        QFETCH(QString, text);
        QFETCH(QString, expected);
        QCOMPARE(told(text, language, names), expected);
    }

    void nothing_is_lost_with_known_names() {
        std::mt19937 random(2);
        const auto below = [&](qsizetype n) { return static_cast<qsizetype>(random() % static_cast<unsigned>(n)); };
        const QString letters = QString::fromUtf8("aab'- 1(яІГ한漢ア\xCC\x81𠮷");
        const auto word = [&](qsizetype longest) {
            QString text;
            for (qsizetype n = below(longest + 1); n > 0; --n)
                text += letters[below(letters.size())]; // lone halves of a letter beyond 16 bits too
            return text;
        };
        const QStringList tags{"de", "ko", "fr", "zh", "ru", "ja", "de-AT"};
        for (int i = 0; i < 3000; ++i) {
            SpokenNames names;
            for (qsizetype n = below(5); n > 0; --n)
                names.push_back({word(3), tags[below(tags.size())]});
            const QString language = i % 2 == 0 ? "de" : "ko";
            const QString text = word(20);
            QString together, before;
            for (const LanguageRun& run : language_runs(text, language, names)) {
                QVERIFY(!run.text.isEmpty());
                QVERIFY2(run.language != before, qPrintable(text));
                together += run.text;
                before = run.language;
            }
            QCOMPARE(together, QString::fromStdU32String(text.toStdU32String()));
        }
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

} // namespace language_runs_test

TP_TEST(language_runs_test, LanguageRunsTest, event_loop)
#include "language_runs_test.moc"
