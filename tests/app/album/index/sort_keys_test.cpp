// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/sort_keys.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>

namespace sort_keys_test {

using namespace tp;

class SortKeysTest : public QObject {
    Q_OBJECT

private slots:
    void names_are_in_the_order_that_a_person_expects() {
        const std::vector<std::string> expected{"anna.jpg",    "Ärger.jpg",  "IMG_1.jpg",   "img_2.jpg",
                                                "IMG_010.jpg", "IMG_11.jpg", "IMG_100.jpg", "Zoo.jpg"};
        std::vector<std::string> names = expected;
        std::reverse(names.begin(), names.end());
        std::sort(names.begin(), names.end(),
                  [](const auto& a, const auto& b) { return sort_key(a) < sort_key(b); });
        QCOMPARE(names, expected);
    }

    void every_name_has_a_key() {
        QVERIFY(!sort_key("J\xF6rg\n.jpg").empty());
        QVERIFY(!sort_key(std::string(255, '9')).empty());
        QVERIFY(sort_key(std::string(254, '9')) < sort_key(std::string(255, '9')));
        QCOMPARE(sort_key("000"), sort_key("0"));
        QVERIFY(sort_key("").empty());
    }

    void folding_ignores_case_and_accents() {
        QCOMPARE(folded("MÜLLER Ñandú ﬁ"), std::string("muller nandu fi"));
        QCOMPARE(folded("שלום 👵"), std::string("שלום 👵"));
    }

    void words_start_where_a_letter_follows_none() {
        QCOMPARE(word_starts("anna-maria müller"),
                 (std::vector<std::string>{"anna-maria müller", "maria müller", "müller"}));
        QVERIFY(word_starts("").empty());
        QVERIFY(word_starts(" - ").empty());
        QCOMPARE(word_starts("a b c d e f g h i j").size(), std::size_t(8));
    }

    void moments_data() {
        QTest::addColumn<QByteArray>("iso");
        QTest::addColumn<qlonglong>("ms"); // -1: none
        QTest::newRow("day one") << QByteArray("1970-01-01T00:00:00Z") << 0LL;
        QTest::newRow("offset") << QByteArray("1970-01-01T02:00:00+02:00") << 0LL;
        QTest::newRow("west") << QByteArray("1969-12-31T19:30:01-04:30") << 1000LL;
        QTest::newRow("offset without colon") << QByteArray("1970-01-01T02:00:00+0200") << 0LL;
        QTest::newRow("fraction") << QByteArray("1970-01-01T00:00:01.25") << 1250LL;
        QTest::newRow("long fraction") << QByteArray("1970-01-01T00:00:01.123456789Z") << 1123LL;
        QTest::newRow("without seconds") << QByteArray("1970-01-01T00:01+00:00") << 60'000LL;
        QTest::newRow("day") << QByteArray("1970-01-02") << 86'400'000LL;
        QTest::newRow("month") << QByteArray("1970-02") << 31 * 86'400'000LL;
        QTest::newRow("year") << QByteArray("1971") << 365 * 86'400'000LL;
        QTest::newRow("empty") << QByteArray("") << -1LL;
        QTest::newRow("no month") << QByteArray("2026-13-01") << -1LL;
        QTest::newRow("no day") << QByteArray("2026-02-30") << -1LL;
        QTest::newRow("camera without a clock") << QByteArray("0000-00-00T00:00:00") << -1LL;
        QTest::newRow("words") << QByteArray("yesterday") << -1LL;
    }

    void moments() {
        QFETCH(QByteArray, iso);
        QFETCH(qlonglong, ms);
        const auto moment = moment_of(iso.toStdString());
        QCOMPARE(moment ? moment->ms : -1, ms);
    }

    void a_year_is_that_of_the_camera() {
        QCOMPARE(moment_of("2025-12-31T23:30:00-05:00")->year, 2025);
        QCOMPARE(moment_of("2026-01-01T00:30:00+02:00")->year, 2026);
    }
};

} // namespace sort_keys_test

TP_TEST(sort_keys_test, SortKeysTest, event_loop)
#include "sort_keys_test.moc"
