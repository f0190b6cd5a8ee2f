// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/feature_tracker.hpp"
#include "test_program.hpp"

#include <QTest>

namespace feature_tracker_test {

using namespace tp;

namespace {
/// Two level lines, 6 mm apart.
const FlatScene two_lines{{"low", "high"},
                          {{{{-50.0, 0.0}, {50.0, 0.0}}, false}, {{{-50.0, 6.0}, {50.0, 6.0}}, false}}};
} // namespace

class FeatureTrackerTest : public QObject {
    Q_OBJECT
private slots:
    void it_is_entered_nearer_than_it_is_left() {
        FeatureTracker tracker;
        QCOMPARE(tracker.follow(two_lines, {0.0, -3.0}), -1);
        QCOMPARE(tracker.follow(two_lines, {0.0, -2.4}), 0);
        QCOMPARE(tracker.follow(two_lines, {0.0, -3.9}), 0);
        QCOMPARE(tracker.follow(two_lines, {0.0, -4.1}), -1);
        QCOMPARE(tracker.follow(two_lines, {0.0, -3.9}), -1);
    }
    void between_two_lines_it_does_not_flicker() {
        FeatureTracker tracker;
        tracker.follow(two_lines, {0.0, 0.0});
        QCOMPARE(tracker.follow(two_lines, {0.0, 3.2}), 0);
        QCOMPARE(tracker.follow(two_lines, {0.0, 2.8}), 0);
        QCOMPARE(tracker.follow(two_lines, {0.0, 3.8}), 1);
        QCOMPARE(tracker.follow(two_lines, {0.0, 2.8}), 1);
    }
    void nothing_is_felt_in_an_empty_scene() {
        FeatureTracker tracker;
        tracker.set(3);
        QCOMPARE(tracker.follow({}, {0.0, 0.0}), -1);
    }
    void a_finger_that_is_nowhere_is_on_nothing() {
        FeatureTracker tracker;
        QCOMPARE(tracker.follow(two_lines, Vec2(std::nan(""))), -1);
    }
};

} // namespace feature_tracker_test

TP_TEST(feature_tracker_test, FeatureTrackerTest, event_loop)
#include "feature_tracker_test.moc"
