// SPDX-License-Identifier: Apache-2.0
#include "core/statistics/within_table.hpp"
#include "test_program.hpp"

#include <QTest>

#include <limits>

namespace within_table_test {

using namespace tp;

namespace {

WithinTable table() {
    return WithinTable({{"stiffness", {"0.1 N/mm", "0.2 N/mm"}}, {"path", {"circle", "triangle"}}});
}

/// All four cells but that one.
void add_but(WithinTable& table, const std::string& participant, std::size_t stiffness, std::size_t path) {
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t p = 0; p < 2; ++p)
            if (k != stiffness || p != path)
                table.add(participant, {k, p}, 1.0);
}

} // namespace

class WithinTableTest : public QObject {
    Q_OBJECT
private slots:
    void trials_of_a_cell_count_as_their_mean_in_any_order() {
        WithinTable trials = table();
        trials.add("2", {1, 1}, 8.0);
        trials.add("2", {0, 1}, 2.0);
        trials.add("2", {1, 0}, 4.0);
        trials.add("2", {1, 0}, 5.0);
        trials.add("2", {0, 0}, 1.0);
        const auto means = trials.means();
        QVERIFY(means.ok());
        QCOMPARE(means->participants, std::vector<std::string>{"2"});
        QCOMPARE(means->values, (std::vector{1.0, 2.0, 4.5, 8.0}));
        QCOMPARE(means->cells(), std::size_t{4});
        QVERIFY(means->left_out.empty());
    }
    void who_has_not_done_everything_is_left_out_by_name() {
        WithinTable trials = table();
        add_but(trials, "1", 9, 9);
        add_but(trials, "7", 1, 0);
        const auto means = trials.means();
        QVERIFY(means.ok());
        QCOMPARE(means->participants, std::vector<std::string>{"1"});
        QCOMPARE(means->left_out.size(), std::size_t{1});
        QCOMPARE(means->left_out.front(),
                 std::string(
                     "Participant 7 is left out: there is no trial with stiffness 0.2 N/mm, path circle."));
    }
    void what_is_no_number_is_no_trial() {
        for (const double value :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            WithinTable trials = table();
            add_but(trials, "1", 0, 1);
            trials.add("1", {0, 1}, value);
            QVERIFY(!trials.means());
        }
    }
    void nobody_is_an_error_that_says_why() {
        QCOMPARE(table().means().error(), std::string("There are no trials."));
        WithinTable trials = table();
        add_but(trials, "7", 0, 0);
        QCOMPARE(trials.means().error(),
                 std::string(
                     "No participant has done everything. Participant 7 is left out: there is no trial with "
                     "stiffness 0.1 N/mm, path circle."));
    }
};

} // namespace within_table_test

TP_TEST(within_table_test, WithinTableTest, nothing)
#include "within_table_test.moc"
