// SPDX-License-Identifier: Apache-2.0
// Portraits of one person told from others': what is counted, and that it ends in a table and a plot. No time is
// asserted.
#include "app/figures/bench/identity_bench.hpp"
#include "places.hpp"

#include <QImage>
#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace tp;

namespace {

/// A portrait whose numbers are all 0 but the first, and perhaps the second.
DescribedPortrait portrait(const char* person, const char* photo, float first, float second = 0.0F,
                           const char* how = as_it_is) {
    DescribedPortrait described{person, photo, how, true, Unfit::no, {}};
    described.numbers[0] = first;
    described.numbers[1] = second;
    return described;
}

/// Anna, Ben and Clara, two portraits each, and what is seen of them when they are half covered.
std::vector<DescribedPortrait> three_people() {
    return {portrait("anna", "anna_1.jpg", 0.0F),
            portrait("anna", "anna_2.jpg", 0.25F),
            portrait("ben", "ben_2.jpg", 0.75F),
            portrait("ben", "ben_1.jpg", 1.0F),
            portrait("clara", "clara_1.jpg", 0.0F, 0.75F),
            portrait("clara", "clara_2.jpg", 0.0F, 0.75F),
            portrait("anna", "anna_2.jpg", 0.75F, 0.0F, "half covered"),
            portrait("ben", "ben_2.jpg", 0.75F, 0.0F, "half covered")};
}

} // namespace

class IdentityBenchTest : public QObject {
    Q_OBJECT

private slots:
    void rates_of_heaps_that_are_apart() {
        const ErrorRates rates = error_rates({0.1, 0.3, 0.2}, {0.9, 0.8, 0.7, 0.6});
        QCOMPARE(rates.equal_error_percent, 0.0);
        QCOMPARE(rates.true_accepts_percent, 100.0);
        QCOMPARE(rates.threshold, 0.6);
    }
    void rates_of_heaps_that_overlap() {
        // Within 0.5 there are one of four impostors and three of four genuine pairs.
        const ErrorRates rates = error_rates({0.1, 0.2, 0.4, 0.7}, {0.5, 0.8, 0.9, 1.0});
        QCOMPARE(rates.equal_error_percent, 25.0);
        QCOMPARE(rates.true_accepts_percent, 75.0);
    }
    void one_impostor_in_a_thousand_is_accepted() {
        std::vector<double> impostor;
        for (int i = 0; i < 1000; ++i)
            impostor.push_back(0.5 + 0.001 * i);
        QCOMPARE(error_rates({0.4, 0.5}, impostor).threshold, 0.501);
        QCOMPARE(error_rates({0.4, 0.5}, impostor).true_accepts_percent, 100.0);
        QCOMPARE(error_rates({0.4, 0.6}, impostor).true_accepts_percent, 50.0);
    }
    void heaps_the_wrong_way_round() {
        QCOMPARE(error_rates({0.9, 0.8}, {0.1, 0.2}).equal_error_percent, 100.0);
    }

    void the_first_portrait_is_compared_with_the_others() {
        const auto rows = identity_rows(three_people());
        QCOMPARE(rows.size(), std::size_t{2});
        QCOMPARE(rows[0].how, std::string(as_it_is));
        QCOMPARE(rows[0].portraits, 6);
        QCOMPARE(rows[0].genuine_pairs, 3);
        QCOMPARE(rows[0].impostor_pairs, 6);
        QVERIFY(std::abs(rows[0].genuine - 0.5 / 3.0) < 1e-6); // 0.25, 0.25 and 0
        QCOMPARE(rows[0].equal_error_percent, 0.0);
        QCOMPARE(rows[1].portraits, 2);
        QCOMPARE(rows[1].genuine_pairs + rows[1].impostor_pairs, 0); // each person's first, and no other
    }
    void faces_that_were_not_found_make_no_pairs() {
        auto portraits = three_people();
        portraits[1].found = false;
        portraits[2].unfit = Unfit::covered;
        const auto rows = identity_rows(portraits);
        QCOMPARE(rows[0].found, 5);
        QCOMPARE(rows[0].unfit, 1);
        QCOMPARE(rows[0].genuine_pairs, 2);
        QCOMPARE(rows[0].impostor_pairs, 4);
    }
    void groups_of_the_portraits_as_they_are() {
        auto portraits = three_people();
        IdentityGroups groups = identity_groups(portraits);
        QCOMPARE(groups.people, 3);
        QCOMPARE(groups.faces, 6);
        QCOMPARE(groups.groups, 3);
        QCOMPARE(groups.purity, 1.0);
        QCOMPARE(groups.groups_a_person(), 1.0);
        portraits[4].numbers = portraits[0].numbers; // one of Clara's looks like Anna
        portraits[5].unfit = Unfit::blurred;
        groups = identity_groups(portraits);
        QCOMPARE(groups.faces, 5);
        QCOMPARE(groups.groups, 2);
        QCOMPARE(groups.purity, 0.8);
    }
    void nobody() {
        QVERIFY(identity_rows({}).empty());
        QCOMPARE(identity_groups({}).groups, 0);
        QCOMPARE(identity_groups({}).groups_a_person(), 0.0);
    }

    void drawn_portraits_end_in_a_table_and_a_plot() {
        QTemporaryDir folder;
        const std::filesystem::path out = folder.path().toStdString();
        for (const char* name : {"anna_sad.jpg", "anna_smiling.jpg"}) // small: there are thirty ways
            QVERIFY(QImage(QString::fromUtf8(tp::test::in_source("resources/samples")) + "/" + name)
                        .scaledToWidth(240, Qt::SmoothTransformation)
                        .save(folder.filePath(name), nullptr, 95));
        const std::atomic<bool> stop{false};
        int steps = 0;
        const auto bench = run_identity_bench(
            {out / "anna_sad.jpg", out / "anna_smiling.jpg"}, [&](const std::string&) { ++steps; }, stop);
        QVERIFY2(bench.ok(), bench.error().c_str());
        QCOMPARE(steps, 2);
        const auto rows = identity_rows(bench->portraits);
        QVERIFY(rows.size() > 25 && rows[0].how == as_it_is && rows.back().how == "face 25 px");
        QCOMPARE(rows[0].genuine_pairs, 1);
        QVERIFY(rows[0].genuine > 0.05 && rows[0].genuine < 0.6);
        QVERIFY(write_identity_table(out, rows).ok() && plot_identity(out, bench->portraits).ok());
        for (const char* name : {"identity.csv", "identity.png", "identity.svg"})
            QVERIFY2(std::filesystem::file_size(out / name) > 100, name);
    }
    void it_stops_when_asked() {
        const std::atomic<bool> stop{true};
        const auto bench = run_identity_bench(
            {"/nowhere/x_1.jpg"}, [](const std::string&) {}, stop);
        QVERIFY(bench.ok() && bench->portraits.empty());
        const std::atomic<bool> go_on{false};
        QVERIFY(!run_identity_bench(
                     {"/nowhere/x_1.jpg"}, [](const std::string&) {}, go_on)
                     .ok());
    }
};

QTEST_MAIN(IdentityBenchTest)
#include "identity_bench_test.moc"
