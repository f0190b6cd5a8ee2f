// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/braille.hpp"
#include "test_program.hpp"

#include <QTest>

#include <atomic>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace braille_test {

using namespace tp;

namespace {

std::string unicode(std::string_view text, const char* language) {
    const auto braille = braille_of(text, language);
    return braille ? as_unicode({braille->cells}) : braille.error();
}

} // namespace

class BrailleTest : public QObject {
    Q_OBJECT
private slots:
    void names_in_three_languages_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("braille");
        // Capital sign, A, n, n, a; and so on, as the codes' own tables have them.
        QTest::newRow("English") << "Anna" << "en" << "⠠⠁⠝⠝⠁";
        QTest::newRow("German, no capitals") << "Jürgen" << "de" << "⠚⠳⠗⠛⠑⠝";
        QTest::newRow("Korean") << "김민수" << "ko" << "⠈⠕⠢⠑⠕⠒⠠⠍";
        QTest::newRow("Korean in an English album") << "김민수" << "en" << "⠈⠕⠢⠑⠕⠒⠠⠍";
        QTest::newRow("a region is no other language") << "Anna" << "en-GB" << "⠠⠁⠝⠝⠁";
        QTest::newRow("two words, blanks at the ends") << "  Al \t Bo " << "de" << "⠁⠇⠀⠃⠕";
        QTest::newRow("nobody") << "" << "en" << "";
        QTest::newRow("blanks") << " \n\t " << "en" << "";
    }
    void names_in_three_languages() {
        QFETCH(QString, name);
        QFETCH(QString, language);
        QFETCH(QString, braille);
        QCOMPARE(QString::fromStdString(unicode(name.toStdString(), language.toUtf8().constData())), braille);
    }
    void what_has_no_braille_is_counted() {
        const auto mixed = braille_of("A😀b", "en");
        QCOMPARE(mixed->left_out, 1);
        QCOMPARE(as_unicode({mixed->cells}), std::string("⠠⠁⠃"));
        const auto arabic = braille_of("محمد", "en");
        QCOMPARE(arabic->left_out, 4);
        QVERIFY(arabic->cells.empty());
    }
    void any_bytes_at_all() {
        std::mt19937 random(3);
        for (int i = 0; i < 400; ++i) {
            std::string bytes;
            for (auto k = random() % 60; k > 0; --k)
                bytes += static_cast<char>(random());
            for (const char* language : {"en", "de", "ko"})
                QVERIFY(braille_of(bytes, language).ok());
        }
        QVERIFY(braille_of(std::string(300, 'a'), "en")->cells.size() == 300);
        QVERIFY(braille_of(std::string(100'000, 'x'), "de").ok());
        QVERIFY(braille_of("\xe2\x80\xae" "Anna", "en").ok()); // turns the direction of writing
    }
    void a_language_without_braille_is_said() {
        QCOMPARE(QString::fromStdString(braille_of("Anna", "xx").error()),
                 QString("There is no braille for the language \"xx\"; there is for en, de and ko."));
    }
    void threads_take_turns() {
        std::atomic<int> wrong{0};
        std::vector<std::jthread> threads;
        for (const char* language : {"en", "de", "ko", "en"})
            threads.emplace_back([&wrong, language] {
                const std::string first = unicode("Anna", language);
                for (int i = 0; i < 200; ++i)
                    wrong += unicode("Anna", language) == first ? 0 : 1;
            });
        threads.clear();
        QCOMPARE(wrong.load(), 0);
    }

    void lines_break_between_words() {
        const auto cells = braille_of("aaa bbb cccccc", "de")->cells;
        const auto lines = wrapped(cells, 7);
        QCOMPARE(lines.size(), 2u);
        QCOMPARE(as_unicode(lines), std::string("⠁⠁⠁⠀⠃⠃⠃\n⠉⠉⠉⠉⠉⠉"));
        QCOMPARE(wrapped(cells, 2).size(), 7u); // words longer than a line break anywhere
        QVERIFY(wrapped({}, 5).empty());
        QVERIFY(wrapped({0, 0, 0}, 2).empty());
    }
    void dots_have_their_true_distances() {
        const std::vector<std::vector<BrailleCell>> lines{{0x3f, 0x01}, {0x20}};
        const std::vector<Vec2> dots = dots_of(lines, {10.0, 20.0});
        QCOMPARE(dots.size(), 8u);
        const auto is_at = [](Vec2 dot, double x, double y) { return length(dot - Vec2(x, y)) < 1e-9; };
        QVERIFY(is_at(dots[0], 10.75, 20.75));
        QVERIFY(is_at(dots[1], 10.75, 23.25)); // 2.5 mm
        QVERIFY(is_at(dots[3], 13.25, 20.75));
        QVERIFY(is_at(dots[6], 16.75, 20.75)); // 6 mm to the next cell
        QVERIFY(is_at(dots[7], 13.25, 35.75)); // 10 mm to the next line
        const Vec2 size = size_of(lines);
        QVERIFY(is_at(size, 10.0, 16.5));
    }
};

} // namespace braille_test

TP_TEST(braille_test, BrailleTest, event_loop)
#include "braille_test.moc"
