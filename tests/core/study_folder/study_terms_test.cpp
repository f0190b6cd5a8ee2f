// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/study_terms.hpp"
#include "study_folder_check.hpp"

#include <QTest>

#include <random>

using namespace tp;
using namespace tp::test;

namespace {

const std::vector<StudySitting> sittings{
    {1, 1, {"2026-11-26", "touchphoto 0.1.0", "mouse", ""}},
    {1, 20, {"2026-11-27", "touchphoto 0.1.0", "force pad, on loan", "\"north\" 0.98"}}};
const std::string table =
    "participant,from_trial,date,software,device,calibration\n"
    "1,1,\"2026-11-26\",\"touchphoto 0.1.0\",\"mouse\",\"\"\n"
    "1,20,\"2026-11-27\",\"touchphoto 0.1.0\",\"force pad, on loan\",\"\"\"north\"\" 0.98\"\n";

} // namespace

class StudyTermsTest : public QObject {
    Q_OBJECT
private slots:
    void terms_are_lines_of_words() {
        for (const StudyTerms& terms : {StudyTerms{0, false}, StudyTerms{18446744073709551615U, true}})
            QCOMPARE(*read_terms(terms_text(terms)), terms);
        QVERIFY(terms_text({42, false}).ends_with("\nseed: 42\nparticipants: people\n"));
        QCOMPARE(*read_terms("\r\n# mine\r\n participants: simulated \r\nseed:7"), (StudyTerms{7, true}));
    }
    void what_is_wrong_with_the_terms_is_said_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<std::string>("said");
        const auto row = [](const char* text, const char* said) {
            QTest::newRow(text) << std::string(text) << std::string(said);
        };
        row("seed: -1", "Line 1 of the study's terms needs a whole number.");
        row("seed", "Line 1 of the study's terms needs a whole number.");
        row("\nparticipants: ghosts", "Line 2 of the study's terms needs people or simulated.");
        row("seed: 1\nseed: 1", "Line 2 of the study's terms says it a second time.");
        row("name: Anna", "Line 1 of the study's terms is not understood.");
        row("participants: people", "The study's terms have no seed: a line \"seed: NUMBER\" is missing.");
        row("seed: 1", "The study's terms do not say who takes part: a line \"participants: people\" or "
                       "\"participants: simulated\" is missing.");
    }
    void what_is_wrong_with_the_terms_is_said() {
        QFETCH(std::string, text);
        QFETCH(std::string, said);
        QCOMPARE(read_terms(text).error(), said);
        QVERIFY(!read_terms(std::string(most_terms_bytes + 1, '\n')).ok());
    }
    void a_sitting_is_a_line_with_its_words_in_quotation_marks() {
        QCOMPARE(sittings_text(sittings), table);
        QCOMPARE(*read_sittings(table), sittings);
        QVERIFY(read_sittings(sittings_text({}))->empty());
    }
    /// As a device may name itself.
    void words_stay_on_one_line() {
        const auto back =
            read_sittings(sittings_text({{1, 1, {"a\nb", "c\r,\xff", std::string(5000, 'x'), ""}}}));
        QVERIFY2(back.ok(), back.error().c_str());
        QCOMPARE(back->front().machine, (StudyMachine{"a b", "c ,\xEF\xBF\xBD", std::string(1000, 'x'), ""}));
    }
    void words_that_are_no_text_are_the_same_when_they_are_written_again() {
        const std::string once = sittings_text({{1, 1, {std::string(1000, '\xff'), "", "", ""}}});
        QCOMPARE(sittings_text(*read_sittings(once)), once);
    }
    void what_a_spreadsheet_has_written_is_read() {
        QCOMPARE(*read_sittings("participant,from_trial,date,software,device,calibration\r\n"
                                "1,1,2026-11-26,touchphoto 0.1.0,mouse,\r\n"),
                 std::vector{sittings[0]});
    }
    void what_is_wrong_with_a_sitting_is_said_data() {
        QTest::addColumn<std::string>("line");
        QTest::addColumn<std::string>("said");
        const std::string cells = "has another number of cells than there are columns";
        const std::string numbers = "needs whole numbers from 1 to 1000000 in its first two cells";
        QTest::newRow("five") << std::string("1,1,a,b,c") << cells;
        QTest::newRow("seven") << std::string("1,1,a,b,c,d,e") << cells;
        QTest::newRow("open") << std::string("1,1,a,b,c,\"d") << cells;
        QTest::newRow("behind") << std::string("1,1,a,b,\"c\"c,d") << cells;
        QTest::newRow("nobody") << std::string("0,1,a,b,c,d") << numbers;
        QTest::newRow("no trial") << std::string("1,x,a,b,c,d") << numbers;
        QTest::newRow("long") << "1,1,a,b,c," + std::string(1001, 'd') << cells;
    }
    void what_is_wrong_with_a_sitting_is_said() {
        QFETCH(std::string, line);
        QFETCH(std::string, said);
        QCOMPARE(read_sittings(table + line + "\n").error(), "Line 4 of the table of sittings " + said + ".");
    }
    void another_table_is_refused() {
        QVERIFY(read_sittings("a,b\n").error().starts_with("The table of sittings has other columns than "));
        QVERIFY(!read_sittings("").ok());
        QVERIFY(!read_sittings(table + std::string(most_sittings_bytes, '\n')).ok());
    }
    void any_bytes_are_refused_in_a_sentence() {
        std::mt19937 random(7);
        for (int round = 0; round < 5000; ++round) {
            std::string text = round % 2 == 0 ? table : terms_text({42, true});
            for (std::size_t change = 1 + random() % 3; change > 0; --change)
                text[random() % text.size()] =
                    random() % 3 == 0 ? static_cast<char>(random() % 256) : "01\",:\n#se"[random() % 9];
            QCOMPARE(complaint_about_terms(text), std::string());
        }
    }
};

QTEST_APPLESS_MAIN(StudyTermsTest)
#include "study_terms_test.moc"
