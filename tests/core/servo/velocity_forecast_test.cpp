// SPDX-License-Identifier: Apache-2.0
#include "core/servo/velocity_forecast.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace velocity_forecast_test {

using namespace tp;

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// Of a swing of 1 mm: mean product of forecast and true velocity while the force acts, as a share of the velocity's
/// square. 1: as a damper without any delay; below 0: it drives.
double worth_of(VelocityForecast& forecast, double hz, std::size_t delay, double quantum = 0.0) {
    double product = 0.0;
    double square = 0.0;
    std::vector<double> said;
    const auto place = [&](double time) { return std::sin(turn * hz * time); };
    for (int i = 0; i < 2000; ++i) {
        const double now = 0.001 * i;
        double x = place(now);
        if (quantum > 0.0)
            x = quantum * std::round(x / quantum);
        forecast.feed(now, {0.0, x});
        said.push_back(forecast.velocity().y);
        if (i < 1000)
            continue;
        const double true_velocity = (place(now + 0.001) - place(now)) / 0.001; // in the tick to come
        product += said[said.size() - 1 - delay] * true_velocity;
        square += true_velocity * true_velocity;
    }
    return product / square;
}

} // namespace

class VelocityForecastTest : public QObject {
    Q_OBJECT
private slots:
    void tells_a_steady_speed() {
        for (const double delay : {0.0, 0.002, 0.004}) {
            VelocityForecast forecast(0.001, delay, 0.0);
            for (int i = 0; i < 100; ++i)
                forecast.feed(0.001 * i, {0.05 * i, -0.02 * i});
            QVERIFY(length(forecast.velocity() - Vec2(50.0, -20.0)) < 1e-6);
            QVERIFY(forecast.worth() > 0.99);
        }
    }

    /// A quarter of a period late a damping force does nothing, and later it drives: at 4 ms and 100 Hz it is half a
    /// period late.
    void is_on_time_for_a_swing_however_late_the_force() {
        for (const std::size_t delay : {0u, 1u, 2u, 4u})
            for (const double hz : {1.0, 5.0, 16.0, 32.0, 50.0, 64.0, 80.0, 100.0}) {
                VelocityForecast forecast(0.001, 0.001 * static_cast<double>(delay), 0.0);
                const double worth = worth_of(forecast, hz, delay);
                QVERIFY2(worth > 0.9 && worth < 1.1,
                         qPrintable(QString("%1 Hz, %2 ms: %3").arg(hz).arg(delay).arg(worth)));
                QVERIFY(forecast.worth() > 0.99);
            }
    }

    void an_encoder_s_steps_do_not_turn_it_round() {
        for (const double quantum : {0.02, 0.09})
            for (const std::size_t delay : {0u, 1u, 2u, 4u})
                for (const double hz : {1.0, 5.0, 16.0, 32.0, 64.0, 100.0}) {
                    VelocityForecast forecast(0.001, 0.001 * static_cast<double>(delay), quantum);
                    QVERIFY(worth_of(forecast, hz, delay, quantum) > 0.6);
                }
    }

    /// A step of 0.09 mm in a millisecond is 90 mm/s; a handle at rest between two steps moves at next to nothing.
    void a_handle_at_rest_between_two_steps_hardly_moves() {
        VelocityForecast forecast(0.001, 0.0, 0.09);
        double fastest = 0.0;
        for (int i = 0; i < 1000; ++i) {
            forecast.feed(0.001 * i, {i / 7 % 2 == 0 ? 0.0 : 0.09, 0.0});
            if (i > 100)
                fastest = std::max(fastest, length(forecast.velocity()));
        }
        QVERIFY(fastest < 20.0);
    }

    /// Motion that does not go on as it was: nothing can be forecast, and no damping force may rely on it.
    void says_how_little_it_knows() {
        std::mt19937 random(1);
        std::normal_distribution<double> noise;
        VelocityForecast forecast(0.001, 0.004, 0.0);
        double worth = 0.0;
        for (int i = 0; i < 3000; ++i) {
            forecast.feed(0.001 * i, {noise(random), noise(random)});
            worth += i >= 1000 ? forecast.worth() / 2000.0 : 0.0;
        }
        QVERIFY2(worth < 0.3, qPrintable(QString::number(worth)));
    }

    void readings_that_are_rare_are_forecast_by_their_own_time() {
        VelocityForecast forecast(0.001, 0.004, 0.0);
        for (int i = 0; i < 400; ++i)
            forecast.feed(0.004 * i, {std::sin(turn * 10.0 * 0.004 * i), 0.0});
        // The force that is written now acts 4 ms later, for the next 4 ms: the velocity in the middle of those.
        const double when = 0.004 * 399 + 0.004 + 0.002;
        QVERIFY(std::abs(forecast.velocity().x - turn * 10.0 * std::cos(turn * 10.0 * when)) < 6.0);
    }

    void forgets_and_ignores_what_it_should() {
        VelocityForecast forecast(0.001, 0.002, 0.0);
        QVERIFY(forecast.velocity() == Vec2(0.0) && forecast.worth() == 1.0);
        forecast.feed(5.0, {80.0, -40.0});
        QVERIFY(forecast.velocity() == Vec2(0.0));
        for (int i = 1; i < 50; ++i)
            forecast.feed(5.0 + 0.001 * i, {80.0 + 0.1 * i, -40.0});
        const Vec2 before = forecast.velocity();
        QVERIFY(std::abs(before.x - 100.0) < 1e-6);
        forecast.feed(5.049, {90.0, 0.0});
        forecast.feed(5.050, {std::nan(""), 0.0});
        forecast.feed(std::nan(""), {0.0, 0.0});
        QVERIFY(forecast.velocity() == before);
        forecast.feed(6.0, {10.0, 10.0}); // after a second nothing is known
        QVERIFY(forecast.velocity() == Vec2(0.0));
        forecast.feed(5.9, {70.0, 10.0}); // a clock that was set back
        QVERIFY(forecast.velocity() == Vec2(0.0));
        forecast.feed(5.901, {70.1, 10.0});
        QVERIFY(is_finite(forecast.velocity()));
        forecast.reset();
        QVERIFY(forecast.velocity() == Vec2(0.0) && forecast.worth() == 1.0);
    }
};

} // namespace velocity_forecast_test

TP_TEST(velocity_forecast_test, VelocityForecastTest, nothing)
#include "velocity_forecast_test.moc"
