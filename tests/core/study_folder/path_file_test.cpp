// SPDX-License-Identifier: Apache-2.0
#include "core/packing/gzip.hpp"
#include "core/study_folder/path_file.hpp"
#include "corpus.hpp"
#include "places.hpp"
#include "study_folder_check.hpp"

#include <QTest>

#include <limits>
#include <random>
#include <set>
#include <string>

using namespace tp;
using namespace tp::test;

namespace {

const std::vector<FingerSample> path{{0.0, 1.5, -2.25, 0.125, 0.0},
                                     {0.01, -0.0001, 99.9996, -0.00001, -1.0},
                                     {12.3456, -100.0, 100.0, 3.0, 1e-9}};
const std::string csv = "time_s,x_mm,y_mm,fx_n,fy_n\n"
                        "0.0000,1.500,-2.250,0.1250,0.0000\n"
                        "0.0100,0.000,100.000,0.0000,-1.0000\n"
                        "12.3456,-100.000,100.000,3.0000,0.0000\n";
const std::string head = csv.substr(0, csv.find('\n') + 1);

} // namespace

class PathFileTest : public QObject {
    Q_OBJECT
private slots:
    void a_sample_is_a_line_in_micrometres_and_tenths_of_a_millinewton() {
        QCOMPARE(path_text(path), csv);
        const auto back = read_path_text(csv);
        QVERIFY2(back.ok(), back.error().c_str());
        QCOMPARE(back->size(), path.size());
        QCOMPARE(back->at(2), (FingerSample{12.3456, -100.0, 100.0, 3.0, 0.0}));
        QCOMPARE(path_file_name(7, 12), std::string("participant-007-trial-0012.csv.gz"));
        QCOMPARE(path_file_name(1234, 12345), std::string("participant-1234-trial-12345.csv.gz"));
    }
    void packed_it_is_the_same_bytes_each_time_and_the_same_path_again() {
        QVERIFY(path_bytes(path) == path_bytes(path));
        QCOMPARE(*gunzipped(path_bytes(path), 10'000), csv);
        QCOMPARE(*read_path_bytes(path_bytes(path)), *read_path_text(csv));
        QVERIFY(read_path_bytes(path_bytes({}))->empty());
    }
    void what_cannot_be_written_is_no_path() {
        QVERIFY(is_path(path) && is_path({}));
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const double far = std::numeric_limits<double>::infinity();
        for (const FingerSample& wrong :
             {FingerSample{nan, 0, 0, 0, 0}, FingerSample{0, nan, 0, 0, 0}, FingerSample{0, 0, -far, 0, 0},
              FingerSample{0, 0, 0, far, 0}, FingerSample{0, 0, 0, 0, 1.1e6}, FingerSample{-0.1, 0, 0, 0, 0}})
            QVERIFY(!is_path(std::vector{wrong}));
        QVERIFY(!is_path(std::vector<FingerSample>{{0.2}, {0.1}}));
        QVERIFY(is_path(std::vector<FingerSample>{{0.2}, {0.2}}));
        QVERIFY(is_path(std::vector<FingerSample>(most_path_samples)));
        QVERIFY(!is_path(std::vector<FingerSample>(most_path_samples + 1)));
    }
    void what_is_wrong_is_said_with_its_line_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<std::string>("said");
        QTest::newRow("nothing") << std::string()
                                 << std::string("The finger's path has other columns than "
                                                "time_s,x_mm,y_mm,fx_n,fy_n.");
        const std::string line_2 = "Line 2 of the finger's path has no five numbers.";
        QTest::newRow("four") << head + "0,1,2,3\n" << line_2;
        QTest::newRow("six") << head + "0,1,2,3,4,5\n" << line_2;
        QTest::newRow("a comma too many") << head + "0,1,2,3,4,\n" << line_2;
        QTest::newRow("a word") << head + "0,1,2,3,x\n" << line_2;
        QTest::newRow("nan") << head + "0,nan,2,3,4\n" << line_2;
        QTest::newRow("far") << head + "0,1,2,3,1e7\n" << line_2;
        QTest::newRow("empty line") << head + "\n" << line_2;
        QTest::newRow("back") << csv + "12.3455,0,0,0,0\n"
                              << std::string("Line 5 of the finger's path goes back in time.");
        QTest::newRow("before it began") << head + "-1,0,0,0,0\n"
                                         << std::string("Line 2 of the finger's path goes back in time.");
        QTest::newRow("torn") << csv.substr(0, csv.size() - 1)
                              << std::string("The last line of the finger's path is not whole.");
    }
    void what_is_wrong_is_said_with_its_line() {
        QFETCH(std::string, text);
        QFETCH(std::string, said);
        QCOMPARE(read_path_text(text).error(), said);
        QCOMPARE(complaint_about_path_text(text), std::string());
        QCOMPARE(complaint_about_path(gzipped(text)), std::string());
    }
    void more_samples_than_an_hour_has_are_refused() {
        std::string text = head;
        for (std::size_t i = 0; i < most_path_samples; ++i)
            text += "0,0,0,0,0\n";
        QCOMPARE(read_path_text(text)->size(), most_path_samples);
        QCOMPARE(read_path_text(text + "0,0,0,0,0\n").error(),
                 std::string("The finger's path has more than 3600001 samples."));
    }
    void a_torn_file_is_said() {
        const std::string bytes = path_bytes(path);
        for (std::size_t cut = 0; cut < bytes.size(); ++cut)
            QCOMPARE(read_path_bytes(bytes.substr(0, cut)).error(),
                     std::string("The finger's path cannot be unpacked: it ends too soon."));
        QVERIFY(read_path("/nowhere/x.csv.gz").error().find("x.csv.gz") != std::string::npos);
    }
    void of_the_fuzzers_corpora_only_what_is_whole_is_read() {
        const std::set<std::string> whole{"two_samples", "no_samples", "five_hundred_samples",
                                          "twenty_kilobytes_of_samples"};
        for (const Seed& seed : corpus(in_source("tests/core/study_folder/path_text_corpus"))) {
            QCOMPARE(complaint_about_path_text(seed.text), std::string());
            QVERIFY2(read_path_text(seed.text).ok() == whole.contains(seed.name), seed.name.c_str());
        }
        for (const Seed& seed : corpus(in_source("tests/core/study_folder/path_corpus"))) {
            QCOMPARE(complaint_about_path(seed.text), std::string());
            QVERIFY2(read_path_bytes(seed.text).ok() == whole.contains(seed.name), seed.name.c_str());
        }
    }
    void any_bytes_are_refused_in_a_sentence() {
        std::mt19937 random(5);
        for (int round = 0; round < 3000; ++round) {
            std::string text = round % 2 == 0 ? csv : path_bytes(path);
            for (std::size_t change = 1 + random() % 3; change > 0; --change)
                text[random() % text.size()] =
                    random() % 3 == 0 ? static_cast<char>(random() % 256) : "0123,.\n-e"[random() % 9];
            QCOMPARE(complaint_about_path_text(text), std::string());
            QCOMPARE(complaint_about_path(text), std::string());
            QCOMPARE(complaint_about_path(gzipped(text)), std::string());
        }
    }
};

QTEST_APPLESS_MAIN(PathFileTest)
#include "path_file_test.moc"
