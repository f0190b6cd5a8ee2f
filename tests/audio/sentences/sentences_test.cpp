// SPDX-License-Identifier: Apache-2.0
#include "audio/sentences/sentence_list.hpp"
#include "audio/sentences/sentence_pattern.hpp"
#include "audio/sentences/sentences.hpp"
#include "corpus.hpp"
#include "marked_sentences.hpp"
#include "places.hpp"
#include "sentences_check.hpp"

#include <QCoreApplication>
#include <QHash>
#include <QRandomGenerator>
#include <QStringList>
#include <QTest>
#include <QTranslator>

#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <utility>

using namespace tp;
using namespace tp::testing;

namespace {

/// German of a few sentences, with places in another order than in English.
class SomeGerman final : public QTranslator {
public:
    QString translate(const char* context, const char* source, const char*, int) const override {
        static const QHash<QString, QString> words{
            {"The file \"%1\" cannot be read.", "Die Datei „%1“ kann nicht gelesen werden."},
            {"There is no recording \"%1\" on \"%2\".", "Bei „%2“ gibt es keine Aufnahme „%1“."},
            {"The recording \"%1\" cannot be used: %2", "Die Aufnahme „%1“ ist unbrauchbar: %2"},
            {"\"%1\" cannot be used: %2", "„%1“ ist unbrauchbar: %2"},
            {"it is damaged.", "sie ist beschädigt."},
            {"%1 It was left as it is.", "%1 Sie blieb, wie sie ist."},
            {"the memo about %1", "die Notiz über %1"},
            {"%1 was deleted", "%1 wurde gelöscht"},
            {"%1: %2", "%1: %2"},
            {"The picture cannot be decoded.", "Das Bild ist nicht lesbar."},
        };
        return QString(context) == "Sentence" ? words.value(QString::fromUtf8(source)) : QString();
    }
    bool isEmpty() const override { return false; }
};

template <typename Language>
struct Speaking {
    Language language;
    Speaking() { QCoreApplication::installTranslator(&language); }
    ~Speaking() { QCoreApplication::removeTranslator(&language); }
};

QString read(const QString& english) { return in_persons_language(english); }

/// Letters that make no sentence of ours, as long as a name is.
QString some_word(QRandomGenerator& random) {
    QString word;
    for (int i = random.bounded(1, 9); i > 0; --i)
        word += QChar(u'α' + random.bounded(20));
    return word;
}

template <typename T>
const T& one_of(std::span<const T> all, QRandomGenerator& random) {
    return all[random.bounded(static_cast<quint32>(all.size()))];
}

/// The sentence with a word in each place.
QString made(const char* source, QRandomGenerator& random, QStringList& words) {
    words.clear();
    for (int i = 0; i < 9; ++i)
        words << some_word(random);
    return with_places(QString::fromUtf8(source), words);
}

} // namespace

class SentencesTest : public QObject {
    Q_OBJECT
private slots:
    void a_sentence_comes_out_in_the_persons_language() {
        const Speaking<SomeGerman> german;
        QCOMPARE(read("The file \"a.jpg\" cannot be read."), "Die Datei „a.jpg“ kann nicht gelesen werden.");
        QCOMPARE(read("There is no recording \"a.flac\" on \"b.jpg\"."), "Bei „b.jpg“ gibt es keine Aufnahme „a.flac“.");
        QCOMPARE(in_persons_language(std::string("The picture cannot be decoded.")), "Das Bild ist nicht lesbar.");
    }

    void a_sentence_in_a_sentence_too() {
        const Speaking<SomeGerman> german;
        QCOMPARE(read("The recording \"a\" cannot be used: it is damaged."), "Die Aufnahme „a“ ist unbrauchbar: sie ist beschädigt.");
        QCOMPARE(read("\"a\" cannot be used: it is damaged. It was left as it is."),
                 "„a“ ist unbrauchbar: sie ist beschädigt. Sie blieb, wie sie ist.");
        QCOMPARE(read("b.jpg: it is damaged."), "b.jpg: sie ist beschädigt.");
        QCOMPARE(read("the memo about Anna was deleted"), "die Notiz über Anna wurde gelöscht");
    }

    void several_sentences_each() {
        const Speaking<SomeGerman> german;
        QCOMPARE(read("The file \"a\" cannot be read. The file \"b\" cannot be read."),
                 "Die Datei „a“ kann nicht gelesen werden. Die Datei „b“ kann nicht gelesen werden.");
        QCOMPARE(read("The picture cannot be decoded. Segmentation fault"), "Das Bild ist nicht lesbar. Segmentation fault");
        QCOMPARE(read("What a day. It rains! The picture cannot be decoded."), "What a day. It rains! Das Bild ist nicht lesbar.");
    }

    void what_is_no_sentence_of_ours_stays_as_it_is() {
        const Speaking<SomeGerman> german;
        for (const char* text : {"", " ", ".", "Input/output error.", "Anna", "a: b", "https://touchphoto.example: 4",
                                 "The file cannot be", "the memo", "\"\"", "%1", "%1: %2"})
            QCOMPARE(read(text), text);
    }

    void a_name_is_not_translated_whatever_it_says() {
        const Speaking<SomeGerman> german;
        QCOMPARE(read("The file \"it is damaged.\" cannot be read."), "Die Datei „it is damaged.“ kann nicht gelesen werden.");
        QCOMPARE(read("The file \"%2 %1.jpg\" cannot be read."), "Die Datei „%2 %1.jpg“ kann nicht gelesen werden.");
        QCOMPARE(read("The file \"a\" b. C\" cannot be read."), "Die Datei „a\" b. C“ kann nicht gelesen werden.");
        QCOMPARE(read("There is no recording \"a\" on \"b\" on \"c\"."), "Bei „b\" on \"c“ gibt es keine Aufnahme „a“.");
        QCOMPARE(read("The file \"\" cannot be read."), "Die Datei „“ kann nicht gelesen werden.");
    }

    void the_sentence_that_says_most_is_meant() {
        const Speaking<SomeGerman> german;
        QCOMPARE(read("The recording \"a\" cannot be used: x"), "Die Aufnahme „a“ ist unbrauchbar: x");
        QCOMPARE(read("\"a\" cannot be used: x"), "„a“ ist unbrauchbar: x");
    }

    void every_sentence_of_the_list_is_known_with_anything_in_its_places() {
        const Speaking<Brackets> brackets;
        QRandomGenerator random(7);
        for (int round = 0; round < 5; ++round)
            for (const char* source : sentence_list()) {
                QStringList words;
                const QString text = made(source, random, words);
                if (QString(source) == "%1: %2")
                    QCOMPARE(read(text), text);
                else
                    QCOMPARE(read(text), u'⟦' + text + u'⟧');
            }
    }

    void every_sentence_is_known_as_the_reason_in_another() {
        const Speaking<Brackets> brackets;
        QRandomGenerator random(8);
        QStringList words;
        for (const char* source : sentence_list()) {
            const SentencePattern pattern(source);
            if (!pattern.has_places() || QString(source) == "%1: %2" || !QString(source).endsWith(": %" + QString::number(QString(source).count('%'))))
                continue;
            const int last = static_cast<int>(QString(source).count('%')) - 1;
            for (const char* reason : sentence_list()) {
                const QString inner = made(reason, random, words);
                made(source, random, words);
                words[last] = inner;
                const QString told = read(with_places(source, words));
                QCOMPARE(without_brackets(told), with_places(source, words));
                const int unknown = QString(reason) == "%1: %2" ? 1 : 0;
                QVERIFY2(told.count(u'⟦') == 2 - unknown, qPrintable(told));
            }
        }
    }

    void every_two_sentences_one_after_the_other_are_known() {
        const Speaking<Brackets> brackets;
        QRandomGenerator random(9);
        QStringList words;
        QStringList whole;
        for (const char* source : sentence_list())
            if (QString(source).endsWith('.'))
                whole << made(source, random, words);
        for (int round = 0; round < 4000; ++round) {
            const QString first = whole[random.bounded(whole.size())], second = whole[random.bounded(whole.size())];
            const QString told = read(first + ' ' + second);
            QCOMPARE(without_brackets(told), first + ' ' + second);
            QVERIFY2(told == u'⟦' + first + "⟧ ⟦" + second + u'⟧' || (told.count(u'⟦') == 2 && told.endsWith("⟧⟧")) ||
                         (told.count(u'⟦') == 2 && told.startsWith("⟦⟦")),
                     qPrintable(told));
        }
    }

    void nothing_is_lost_of_any_text() {
        QRandomGenerator random(10);
        const QString pieces[] = {"\"", ". ", ": ", " ", "%1", "%2", "it is damaged.", " cannot be read", "The file ", "a",
                                  "ä", "\n", "The recording \"", " It was left as it is.", " of ", " about ", " became ", "; "};
        QStringList words;
        for (int round = 0; round < 3000; ++round) {
            QString text;
            for (int i = random.bounded(1, 14); i > 0; --i)
                text += random.bounded(3) == 0 ? made(one_of(sentence_list(), random), random, words)
                                               : one_of(std::span<const QString>(pieces), random);
            const std::string complaint = test::complaint_about_sentence(text.toStdString());
            QVERIFY2(complaint.empty(), qPrintable(text + ": " + QString::fromStdString(complaint)));
        }
    }

    void hostile_texts_are_read_to_their_end_data() {
        QTest::addColumn<QByteArray>("text");
        const auto many = [](const char* what, const char* before = "", const char* after = "") {
            return before + QByteArray(what).repeated(100'000 / static_cast<qsizetype>(qstrlen(what))) + after;
        };
        QTest::newRow("a long name") << many("a", "The file \"", "\" cannot be read.");
        QTest::newRow("a name of quotation marks") << many("\"", "The file \"", "\" cannot be read.");
        QTest::newRow("a name of sentences") << many("it is damaged. ", "The file \"", "\" cannot be read.");
        QTest::newRow("dots and spaces") << many(". ");
        QTest::newRow("colons") << many("a: ");
        QTest::newRow("sentences") << many("The file \"a\" cannot be read. ");
        QTest::newRow("reasons in reasons") << many("\"a\" cannot be used: ");
        QTest::newRow("what stands between places") << many(" was \" in another copy; it is \" became ");
        QTest::newRow("the same words, never their end") << many("The recording \"");
        QTest::newRow("no text at all") << many("\xff\xfe\x80");
        QTest::newRow("a letter begun") << QByteArray("The file \"\xe2\x82\" cannot be read.");
        QTest::newRow("a zero") << QByteArray("The file \"\0\" cannot be read.", 28);
    }
    void hostile_texts_are_read_to_their_end() {
        QFETCH(QByteArray, text);
        QCOMPARE(test::complaint_about_sentence(text.toStdString()), std::string());
    }

    void inputs_that_the_fuzzer_keeps_do_no_harm() {
        const auto seeds = tp::test::corpus(tp::test::in_source("tests/audio/sentences/corpus"));
        QVERIFY(seeds.size() >= 5);
        for (const tp::test::Seed& seed : seeds)
            QCOMPARE(seed.name + ": " + test::complaint_about_sentence(seed.text), seed.name + ": ");
    }
};

QTEST_GUILESS_MAIN(SentencesTest)
#include "sentences_test.moc"
