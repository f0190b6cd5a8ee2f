// SPDX-License-Identifier: Apache-2.0
#include "core/study/expression_observer.hpp"
#include "core/study/expression_table.hpp"
#include "core/study/expression_trial.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <numeric>
#include <random>

namespace expression_observer_test {

using namespace tp;

namespace {

constexpr Expression smiling = Expression::smiling, sad = Expression::sad, angry = Expression::angry;

double share(const ExpressionShares& shares, Expression expression) {
    return shares[static_cast<std::size_t>(expression)];
}

double sum_of(const ExpressionShares& shares) { return std::accumulate(shares.begin(), shares.end(), 0.0); }

/// A face that differs from others by its corners only.
ExpressionCues with_corners(double lift) {
    ExpressionCues cues{};
    at(cues, Cue::outer_corner_lift) = lift;
    at(cues, Cue::inner_corner_lift) = lift;
    return cues;
}

/// Three people who smile and are sad, each a little differently.
std::vector<ExpressionExample> three_people() {
    std::vector<ExpressionExample> faces;
    double own = -1.0;
    for (const char* person : {"anna", "ben", "clara"}) {
        faces.push_back({person, smiling, with_corners(6.0 + own)});
        faces.push_back({person, sad, with_corners(-4.0 + own)});
        own += 1.0;
    }
    return faces;
}

/// The mean of what the built-in observer takes an expression for.
ExpressionCues built_in_mean(Expression expression) {
    ExpressionCues cues{};
    const ExpressionObserver observer = ExpressionObserver::built_in();
    for (std::size_t i = 0; i < cue_count; ++i)
        cues[i] = observer.model()[i].means[static_cast<std::size_t>(expression)];
    return cues;
}

} // namespace

class ExpressionObserverTest : public QObject {
    Q_OBJECT
private slots:
    void names_go_there_and_back() {
        for (const Expression expression : all_expressions)
            QVERIFY(expression_named(name_of(expression)) == expression);
        QVERIFY(!expression_named("Smiling") && !expression_named(""));
    }

    void learns_means_and_the_spread_within_expressions() {
        const auto observer = ExpressionObserver::learned_from(three_people());
        QVERIFY2(observer.ok(), observer.error().c_str());
        const auto& lift = observer->model()[static_cast<std::size_t>(Cue::outer_corner_lift)];
        QCOMPARE(lift.means[static_cast<std::size_t>(smiling)], 6.0);
        QCOMPARE(lift.means[static_cast<std::size_t>(sad)], -4.0);
        QVERIFY(std::abs(lift.spread - 1.0) < 1e-12); // -1, 0, 1 twice, with four degrees of freedom
        // What never differs is not taken for more telling than a finger can feel.
        QCOMPARE(observer->model()[static_cast<std::size_t>(Cue::eye_opening)].spread, 0.5);
        QVERIFY(observer->knows(smiling) && observer->knows(sad) && !observer->knows(angry));
    }

    void the_order_of_the_examples_does_not_matter() {
        std::vector<ExpressionExample> faces = three_people();
        const auto before = ExpressionObserver::learned_from(faces);
        std::reverse(faces.begin(), faces.end());
        const auto after = ExpressionObserver::learned_from(faces);
        for (std::size_t i = 0; i < cue_count; ++i)
            for (std::size_t e = 0; e < expression_count; ++e)
                QVERIFY(std::abs(before->model()[i].means[e] - after->model()[i].means[e]) < 1e-12);
    }

    void what_cannot_be_learned_from_is_a_sentence() {
        std::vector<ExpressionExample> faces;
        QVERIFY(ExpressionObserver::learned_from(faces).error().ends_with('.'));
        faces.push_back({"anna", smiling, with_corners(6.0)});
        faces.push_back({"ben", smiling, with_corners(7.0)});
        QVERIFY(ExpressionObserver::learned_from(faces).error().ends_with('.'));
        faces = {{"anna", smiling, with_corners(6.0)}, {"anna", sad, with_corners(-4.0)}};
        QVERIFY(ExpressionObserver::learned_from(faces).error().ends_with('.'));
    }

    void shares_are_of_the_choices_and_together_one() {
        const ExpressionObserver observer = ExpressionObserver::built_in();
        std::mt19937 random(5);
        std::normal_distribution<double> off(0.0, 30.0);
        for (int i = 0; i < 500; ++i) {
            ExpressionCues cues = built_in_mean(all_expressions[static_cast<std::size_t>(i) % 5]);
            for (double& cue : cues)
                cue += off(random);
            for (const auto& choices : {paper_choices, choices_with_neutral}) {
                const ExpressionShares shares = observer.judge(cues, choices);
                QVERIFY(std::abs(sum_of(shares) - 1.0) < 1e-12);
                for (std::size_t e = 0; e < expression_count; ++e)
                    QVERIFY(shares[e] >= 0.0 && (choices[e] || shares[e] == 0.0));
            }
        }
        QCOMPARE(sum_of(observer.judge({}, ExpressionChoices{})), 0.0);
    }

    void half_way_between_two_means_both_are_as_likely() {
        const auto observer = ExpressionObserver::learned_from(three_people());
        QVERIFY(std::abs(share(observer->judge(with_corners(1.0), paper_choices), smiling) - 0.5) < 1e-9);
        QVERIFY(share(observer->judge(with_corners(2.0), paper_choices), smiling) > 0.9);
        QVERIFY(share(observer->judge(with_corners(0.0), paper_choices), sad) > 0.9);
    }

    void a_finger_that_feels_nothing_has_no_opinion() {
        FingerTouch numb;
        numb.noise_mm = 1e6;
        const ExpressionShares shares =
            ExpressionObserver::built_in().judge(built_in_mean(smiling), paper_choices, numb);
        for (const Expression expression : all_expressions)
            QVERIFY(std::abs(share(shares, expression) - (expression == Expression::neutral ? 0.0 : 0.25)) <
                    1e-3);
    }

    /// The signs that a person would name, and that the data must have taught.
    void the_built_in_observer_knows_what_faces_do() {
        const auto mean = [](Expression expression, Cue cue) { return at(built_in_mean(expression), cue); };
        for (const Cue lift : {Cue::outer_corner_lift, Cue::inner_corner_lift}) {
            QVERIFY(mean(smiling, lift) > mean(Expression::neutral, lift) + 3.0);
            QVERIFY(mean(sad, lift) < mean(Expression::neutral, lift) - 2.0);
        }
        for (const Expression other : {smiling, sad, angry, Expression::neutral}) {
            QVERIFY(mean(Expression::surprised, Cue::mouth_opening) > mean(other, Cue::mouth_opening) + 3.0);
            QVERIFY(mean(Expression::surprised, Cue::eye_opening) > mean(other, Cue::eye_opening) + 1.0);
        }
        QVERIFY(mean(sad, Cue::lid_slope) > mean(angry, Cue::lid_slope) + 0.5);
        QVERIFY(mean(angry, Cue::lip_height) < mean(sad, Cue::lip_height) - 1.0);
        const ExpressionObserver observer = ExpressionObserver::built_in();
        for (const Expression expression : all_expressions) {
            QVERIFY(observer.knows(expression));
            QVERIFY(answer_of(observer.judge(built_in_mean(expression), choices_with_neutral)) == expression);
        }
    }

    /// A mirror face (its corners turned over) must not be taken for the same.
    void turned_over_corners_turn_the_answer_over() {
        const auto observer = ExpressionObserver::learned_from(three_people());
        for (const double lift : {1.5, 3.0, 8.0}) {
            QVERIFY(answer_of(observer->judge(with_corners(1.0 + lift), paper_choices)) == smiling);
            QVERIFY(answer_of(observer->judge(with_corners(1.0 - lift), paper_choices)) == sad);
        }
    }

    void a_finger_errs_as_much_as_is_said() {
        ExpressionCues cues{};
        cues.fill(20.0);
        FingerTouch touch;
        touch.noise_mm = 0.8;
        touch.eyes_mm = 50.0; // so that a millimetre is 2 %
        std::mt19937_64 random(9);
        constexpr int touches = 20'000;
        std::array<double, cue_count> sums{}, squares{};
        for (int i = 0; i < touches; ++i) {
            const ExpressionCues once = felt(cues, touch, random);
            for (std::size_t c = 0; c < cue_count; ++c) {
                sums[c] += once[c] - 20.0;
                squares[c] += (once[c] - 20.0) * (once[c] - 20.0);
            }
        }
        for (std::size_t c = 0; c < cue_count; ++c) {
            const double expected = 1.6 * cue_kinds[c].noise_gain;
            QVERIFY(std::abs(std::sqrt(squares[c] / touches) - expected) < 0.03 * expected);
            QVERIFY(std::abs(sums[c] / touches) < 0.05 * expected);
        }
    }

    void lips_nearer_than_a_millimetre_are_one_line() {
        FingerTouch touch;
        touch.noise_mm = 1e-9;
        std::mt19937_64 random(1);
        ExpressionCues cues{};
        at(cues, Cue::mouth_opening) = 0.9;
        at(cues, Cue::eye_opening) = 1.1;
        const ExpressionCues once = felt(cues, touch, random);
        QVERIFY(std::abs(at(once, Cue::mouth_opening)) < 1e-6);
        QVERIFY(std::abs(at(once, Cue::eye_opening) - 1.1) < 1e-6);
    }

    void an_exact_face_has_one_answer_and_a_felt_one_several() {
        const ExpressionObserver observer = ExpressionObserver::built_in();
        ExpressionCues between{};
        for (std::size_t i = 0; i < cue_count; ++i)
            between[i] = 0.55 * built_in_mean(sad)[i] + 0.45 * built_in_mean(angry)[i];
        ExpressionTrial trial;
        QCOMPARE(share(answers_to(between, observer, trial), sad), 1.0);
        trial.touch = FingerTouch{};
        const ExpressionShares felt_once = answers_to(between, observer, trial);
        QVERIFY(share(felt_once, sad) > 0.3 && share(felt_once, angry) > 0.2);
        QVERIFY(std::abs(sum_of(felt_once) - 1.0) < 1e-9);
        QVERIFY(answers_to(between, observer, trial) == felt_once);
        ++trial.seed;
        QVERIFY(answers_to(between, observer, trial) != felt_once);
    }

    void more_noise_costs_right_answers() {
        const ExpressionObserver observer = ExpressionObserver::built_in();
        double before = 101.0;
        for (const double noise_mm : {0.1, 0.5, 1.0, 2.0, 4.0, 8.0}) {
            ExpressionTrial trial;
            trial.touch = FingerTouch{};
            trial.touch->noise_mm = noise_mm;
            ExpressionTable table;
            for (const Expression shown : {smiling, Expression::surprised, sad, angry})
                table.add(shown, answers_to(built_in_mean(shown), observer, trial));
            const double right = *table.percent_right(paper_choices);
            QVERIFY(right < before + 0.5);
            before = right;
        }
        QVERIFY(before < 60.0);
    }

    void nobody_is_judged_by_their_own_faces() {
        std::vector<ExpressionExample> faces = three_people();
        const auto before = observers_by_others(faces, paper_choices);
        QVERIFY2(before.ok(), before.error().c_str());
        faces[0].cues = with_corners(-50.0); // anna's
        faces[1].cues = with_corners(50.0);
        const auto after = observers_by_others(faces, paper_choices);
        for (const char* person : {"anna", "ben"}) {
            const auto& was = before.value().at(person).model();
            const auto& is = after.value().at(person).model();
            const bool same =
                std::equal(was.begin(), was.end(), is.begin(), [](const auto& a, const auto& b) {
                    return a.means == b.means && a.spread == b.spread;
                });
            QCOMPARE(same, std::string_view(person) == "anna");
        }
    }

    void too_few_people_to_leave_one_out_is_a_sentence() {
        std::vector<ExpressionExample> faces = three_people();
        faces.resize(2);
        const std::string error = observers_by_others(faces, paper_choices).error();
        QVERIFY2(error.find("\"anna\"") != std::string::npos && error.ends_with('.'), error.c_str());
        faces = three_people();
        for (ExpressionExample& face : faces)
            face.shown = face.shown == sad ? Expression::neutral : face.shown;
        QVERIFY(!observers_by_others(faces, paper_choices).ok()); // neutral is no answer there
        QVERIFY(observers_by_others(faces, choices_with_neutral).ok());
    }

    void the_table_counts() {
        ExpressionTable table;
        table.add(sad, {0.0, 0.0, 0.75, 0.25, 0.0});
        table.add(sad, {0.0, 0.0, 0.25, 0.75, 0.0});
        table.add(smiling, {1.0, 0.0, 0.0, 0.0, 0.0});
        table.add(Expression::neutral, {0.0, 0.0, 0.0, 1.0, 0.0});
        QCOMPARE(table.faces(sad), 2);
        QCOMPARE(table.percent(sad, sad), 50.0);
        QCOMPARE(table.percent(sad, angry), 50.0);
        QCOMPARE(table.percent(angry, angry), 0.0);
        QCOMPARE(*table.percent_right(paper_choices), 75.0);
        QCOMPARE(*table.percent_right(choices_with_neutral), 50.0);
        QVERIFY(!ExpressionTable{}.percent_right(paper_choices).has_value());
    }

    void the_papers_figures_are_its_mean() {
        double sum = 0.0;
        for (const Expression shown : {smiling, Expression::surprised, sad, angry})
            sum += *paper_percent_right(shown);
        QCOMPARE(sum / 4.0, 88.75);
        QVERIFY(!paper_percent_right(Expression::neutral));
    }
};

} // namespace expression_observer_test

TP_TEST(expression_observer_test, ExpressionObserverTest, nothing)
#include "expression_observer_test.moc"
