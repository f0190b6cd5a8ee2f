// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/golden_set.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <fstream>

namespace golden_set_test {

using namespace tp;

namespace {

/// Two people, each contour of both as far off as said, percent.
std::vector<PortraitErrors> two_people(double first, double second) {
    std::vector<PortraitErrors> people(2);
    people[0].photo = "002_03.jpg";
    people[1].photo = "011_03.jpg";
    people[0].percent.emplace().fill(first);
    people[1].percent.emplace().fill(second);
    return people;
}

const GoldenRow golden = golden_row(two_people(0.5, 1.5));

std::string only_difference(std::vector<PortraitErrors> measured) {
    const auto all = differences("embedded", golden, measured);
    return all.size() == 1 ? all[0] : std::to_string(all.size()) + " differences";
}

} // namespace

class GoldenSetTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::string error_of(const std::string& text) const {
        const std::string file = (folder_.path() + "/golden.txt").toStdString();
        std::ofstream(file) << text;
        return read_golden_set(file).error();
    }

private slots:
    void means_worst_ones_and_failures_are_counted() {
        QCOMPARE(golden.people, std::size_t{2});
        QCOMPARE(golden.failures, std::size_t{0});
        QCOMPARE(golden.features[at_outline].mean, 1.0);
        QCOMPARE(golden.features[at_outline].worst, 1.5);
        auto failing = two_people(0.5, 5.1);
        QCOMPARE(golden_row(failing).failures, std::size_t{1});
        failing[0].problem = "The face is turned.";
        QCOMPARE(golden_row(failing).failures, std::size_t{2});
        failing[1].percent.reset();
        QCOMPARE(golden_row(failing).failures, std::size_t{2});
        QCOMPARE(golden_row(failing).features[at_outline].worst, 0.5);
    }

    void what_lies_within_the_margin_is_no_difference() {
        QVERIFY(differences("embedded", golden, two_people(0.5, 1.5)).empty());
        QVERIFY(differences("embedded", golden, two_people(0.49, 1.53)).empty());
        QVERIFY(differences("embedded", golden, two_people(0.52, 1.46)).empty());
    }
    void a_worse_mean_is_told_with_feature_and_people() {
        auto measured = two_people(0.5, 1.5);
        (*measured[0].percent)[at_inner_lip] = 0.6; // 5 % more in the mean
        const std::string said = only_difference(measured);
        QVERIFY2(
            said.starts_with("embedded: the mean error of inner_lip is 1.0500 %, in the golden set 1.0000"),
            said.c_str());
        QVERIFY2(said.ends_with("the largest: 011_03.jpg (1.50 %), 002_03.jpg (0.60 %)."), said.c_str());
    }
    void a_worse_person_is_told_where_the_mean_is_kept() {
        auto measured = two_people(0.5, 1.5);
        (*measured[0].percent)[at_left_eye] = 0.4;
        (*measured[1].percent)[at_left_eye] = 1.6; // 6.7 % more
        const std::string said = only_difference(measured);
        QVERIFY2(said.starts_with("embedded: the worst left_eye is 1.6000 % off"), said.c_str());
        QVERIFY2(said.find("011_03.jpg (1.60 %)") != std::string::npos, said.c_str());
    }
    void what_is_better_asks_to_be_kept() {
        auto measured = two_people(0.5, 1.5);
        (*measured[0].percent)[at_outline] = 0.4;
        const std::string said = only_difference(measured);
        QVERIFY2(said.ends_with("better than 1.0000 in the golden set; `cmake --build build/release --target "
                                "renew_golden_set` keeps it."),
                 said.c_str());
    }
    void a_failure_is_told_with_its_reason() {
        auto measured = two_people(0.5, 1.5);
        measured[1].problem = "The face is turned.";
        QCOMPARE(only_difference(measured), std::string("embedded: 1 portraits fail, 0 in the golden set: "
                                                        "011_03.jpg (The face is turned.)."));
        measured = two_people(0.5, 1.5);
        measured.pop_back();
        QVERIFY(
            only_difference(measured).starts_with("embedded: 1 people were measured, the golden set has 2"));
    }
    void errors_without_a_number_are_worse() {
        QVERIFY(!differences("embedded", golden, two_people(0.5, std::nan(""))).empty());
    }

    void the_better_figure_of_both_is_kept() {
        auto measured = two_people(0.7, 1.2);
        (*measured[0].percent)[at_outline] = 1.7;
        const GoldenRow kept = better_of(golden, golden_row(measured));
        QCOMPARE(kept.features[at_right_eye].mean, 0.95);
        QCOMPARE(kept.features[at_right_eye].worst, 1.2);
        QCOMPARE(kept.features[at_outline].mean, 1.0);
        QCOMPARE(kept.features[at_outline].worst, 1.5);
        measured.pop_back(); // of other people nothing can be kept
        QCOMPARE(better_of(golden, golden_row(measured)).features[at_outline].worst, 1.7);
    }
    void what_is_written_is_read_back() {
        const GoldenSet set{{"embedded", golden}, {"mesh", golden_row(two_people(0.1234, 6.0))}};
        const std::string file = (folder_.path() + "/set.txt").toStdString();
        std::ofstream(file) << text_of(set);
        const auto back = read_golden_set(file);
        QVERIFY2(back.ok(), back.error().c_str());
        QCOMPARE(text_of(*back), text_of(set));
        QCOMPARE(back->at("mesh").failures, std::size_t{1});
        QCOMPARE(back->at("mesh").features[at_inner_lip].mean, 3.0617);
    }
    void damaged_sets_are_a_sentence_data() {
        QTest::addColumn<QString>("without");
        for (const char* word : {"people", "mean", "0.5000", "outline", "failures"})
            QTest::newRow(word) << word;
    }
    void damaged_sets_are_a_sentence() {
        QFETCH(QString, without);
        const GoldenSet set{{"embedded", golden_row(two_people(0.5, 0.5))}};
        const QString whole = QString::fromStdString(text_of(set)), damaged = QString(whole).remove(without);
        QCOMPARE(error_of(whole.toStdString()), std::string());
        QVERIFY(error_of(damaged.toStdString()).starts_with("In the golden set \""));
        QVERIFY(error_of(whole.section('\n', 0, -3).toStdString())
                    .ends_with("figures of \"embedded\" are missing."));
        QVERIFY(read_golden_set("/nowhere/set.txt").error().ends_with("cannot be read."));
    }
    /// The test of its figures (faces.accuracy) needs portraits, which not every clone has.
    void the_committed_set_can_be_read() {
        const auto committed = read_golden_set(tp::test::in_source("tests/faces/golden_set.txt"));
        QVERIFY2(committed.ok(), committed.error().c_str());
        QCOMPARE(committed->size(), std::size_t{3});
        for (const auto& [name, row] : *committed) {
            QCOMPARE(row.people, std::size_t{34});
            QCOMPARE(row.failures, std::size_t{0});
            for (const auto& figures : row.features)
                QVERIFY2(figures.mean > 0.0 && figures.mean < figures.worst, name.c_str());
        }
    }
};

} // namespace golden_set_test

TP_TEST(golden_set_test, GoldenSetTest, nothing)
#include "golden_set_test.moc"
