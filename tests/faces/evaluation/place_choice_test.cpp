// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/place_choice.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace place_choice_test {

using namespace tp;

namespace {

constexpr int features = 4, places = 21;

cv::Mat1d column(std::initializer_list<double> values) {
    cv::Mat1d result(static_cast<int>(values.size()), 1);
    std::copy(values.begin(), values.end(), result.begin());
    return result;
}

/// Places with features of different sizes, as slopes and bends have them, chosen as often as `weights` say.
std::vector<PlaceChoice> drawn(const cv::Mat1d& weights, int count, unsigned seed) {
    cv::RNG random(seed);
    std::vector<PlaceChoice> choices;
    for (int i = 0; i < count; ++i) {
        PlaceChoice choice{cv::Mat1d(places, features), 0.0};
        for (int f = 0; f < features; ++f)
            random.fill(choice.seen.col(f), cv::RNG::NORMAL, 0.0, 0.3 + 0.5 * f);
        const cv::Mat1d logarithms(choice.seen * weights);
        std::vector<double> until(places);
        double sum = 0.0;
        for (int k = 0; k < places; ++k)
            until[static_cast<std::size_t>(k)] = sum += std::exp(logarithms(k));
        const double drawn_at = random.uniform(0.0, sum);
        while (choice.taken + 1 < places && until[static_cast<std::size_t>(choice.taken)] < drawn_at)
            choice.taken += 1.0;
        choices.push_back(choice);
    }
    return choices;
}

const cv::Mat1d some_weights = column({2.0, -1.0, 0.0, 0.7});

} // namespace

class PlaceChoiceTest : public QObject {
    Q_OBJECT

private slots:
    void derivatives_are_those_of_the_value() {
        auto choices = drawn(some_weights, 30, 3);
        for (PlaceChoice& choice : choices)
            choice.taken = std::min(choice.taken + 0.37, places - 1.0); // between two places
        const cv::Mat1d at = column({0.5, -0.3, 1.1, 0.2});
        const LogLikelihood here = log_likelihood(choices, at);
        constexpr double step = 1e-5;
        for (int f = 0; f < features; ++f) {
            cv::Mat1d before = at.clone(), after = at.clone();
            before(f) -= step;
            after(f) += step;
            const LogLikelihood lower = log_likelihood(choices, before);
            const LogLikelihood upper = log_likelihood(choices, after);
            QVERIFY(std::abs((upper.value - lower.value) / (2.0 * step) - here.gradient(f)) < 1e-4);
            for (int g = 0; g < features; ++g)
                QVERIFY(std::abs((upper.gradient(g) - lower.gradient(g)) / (2.0 * step) -
                                 here.curvature(f, g)) < 1e-4);
        }
    }

    void the_likelihood_is_concave() {
        const auto choices = drawn(some_weights, 50, 4);
        cv::RNG random(5);
        for (int i = 0; i < 20; ++i) {
            cv::Mat1d a(features, 1), b(features, 1);
            random.fill(a, cv::RNG::NORMAL, 0.0, 3.0);
            random.fill(b, cv::RNG::NORMAL, 0.0, 3.0);
            const double middle = log_likelihood(choices, cv::Mat1d(0.5 * (a + b))).value;
            QVERIFY(middle >=
                    0.5 * (log_likelihood(choices, a).value + log_likelihood(choices, b).value) - 1e-9);
            cv::Mat1d values;
            cv::eigen(log_likelihood(choices, a).curvature, values);
            QVERIFY(values(0) <= 1e-9);
        }
    }

    void weights_that_made_the_choices_are_found() {
        const cv::Mat1d found = likeliest_weights(drawn(some_weights, 4000, 6), features, 1e-3);
        for (int f = 0; f < features; ++f)
            QVERIFY2(std::abs(found(f) - some_weights(f)) < 0.15, qPrintable(QString::number(found(f))));
    }
    void no_other_weights_are_likelier() {
        const auto choices = drawn(some_weights, 300, 7);
        const cv::Mat1d found = likeliest_weights(choices, features, 1e-6);
        const LogLikelihood best = log_likelihood(choices, found);
        QVERIFY(cv::norm(best.gradient) < 1e-2);
        cv::RNG random(8);
        for (int i = 0; i < 20; ++i) {
            cv::Mat1d other(features, 1);
            random.fill(other, cv::RNG::NORMAL, 0.0, 0.2);
            other += found;
            QVERIFY(log_likelihood(choices, other).value <= best.value + 1e-6);
        }
    }
    void the_unit_of_a_feature_does_not_matter() {
        const auto choices = drawn(some_weights, 300, 9);
        auto others = choices;
        for (PlaceChoice& choice : others) {
            choice.seen = choice.seen.clone();
            choice.seen.col(1) *= 100.0;
        }
        const cv::Mat1d a = likeliest_weights(choices, features, 10.0);
        const cv::Mat1d b = likeliest_weights(others, features, 10.0);
        QVERIFY(std::abs(a(1) - 100.0 * b(1)) < 1e-4 && std::abs(a(0) - b(0)) < 1e-4);
    }

    void perfectly_told_apart_stays_finite() {
        PlaceChoice sure{cv::Mat1d(places, features, 0.0), 4.0};
        sure.seen(4, 0) = 1.0;
        const cv::Mat1d found = likeliest_weights({sure, sure, sure}, features, 1.0);
        QVERIFY(cv::checkRange(found) && found(0) > 0.5);
        QVERIFY(std::abs(found(1)) < 1e-9); // a feature that never varies says nothing
    }
    void what_cannot_be_judged_is_left_out() {
        const auto sound = drawn(some_weights, 100, 10);
        const cv::Mat1d expected = likeliest_weights(sound, features, 1.0);
        const auto broken = [&](auto breaking) {
            PlaceChoice choice{sound[0].seen.clone(), sound[0].taken};
            breaking(choice);
            return choice;
        };
        const std::vector<PlaceChoice> faults{
            PlaceChoice{},
            broken([](PlaceChoice& c) { c.seen = c.seen.row(0); }),
            broken([](PlaceChoice& c) { c.seen = c.seen.colRange(1, features); }),
            broken([](PlaceChoice& c) { c.seen(3, 1) = NAN; }),
            broken([](PlaceChoice& c) { c.seen(0, 0) = INFINITY; }),
            broken([](PlaceChoice& c) { c.taken = -0.1; }),
            broken([](PlaceChoice& c) { c.taken = places - 0.9; }),
            broken([](PlaceChoice& c) { c.taken = NAN; })};
        for (std::size_t i = 0; i < faults.size(); ++i) {
            auto choices = sound;
            choices.insert(choices.begin() + 50, faults[i]);
            QVERIFY2(cv::norm(likeliest_weights(choices, features, 1.0), expected) == 0.0,
                     qPrintable(QString::number(i)));
        }
    }
    void without_choices_weights_are_zero() {
        QCOMPARE(cv::norm(likeliest_weights({}, features, 10.0)), 0.0);
        QCOMPARE(log_likelihood({}, some_weights).value, 0.0);
    }
};

} // namespace place_choice_test

TP_TEST(place_choice_test, PlaceChoiceTest, event_loop)
#include "place_choice_test.moc"
