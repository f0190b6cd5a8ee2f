// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/descriptor.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

namespace descriptor_test {

using namespace tp;

class DescriptorTest : public QObject {
    Q_OBJECT

private slots:
    void what_is_not_finite_is_refused() {
        for (const float wrong :
             {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
              -std::numeric_limits<float>::infinity()}) {
            FaceNumbers numbers{};
            numbers[descriptor_length - 1] = wrong;
            QVERIFY(!descriptor_of(numbers));
        }
    }
    void numbers_go_to_the_nearest_step() {
        FaceNumbers numbers{};
        numbers[0] = 0.25F;
        numbers[1] = -0.25F;
        numbers[2] = 0.0117F; // 1.4976 steps
        numbers[3] = 5.0F;
        numbers[4] = -1e30F;
        const FaceDescriptor bytes = *descriptor_of(numbers);
        QCOMPARE(int(bytes[0]), 32);
        QCOMPARE(int(bytes[1]), -32);
        QCOMPARE(int(bytes[2]), 1);
        QCOMPARE(int(bytes[3]), 127);
        QCOMPARE(int(bytes[4]), -127);
        QCOMPARE(int(bytes[5]), 0);
    }
    void distances() {
        FaceNumbers a{}, b{};
        a[3] = 0.25F;
        b[3] = -0.125F;
        b[100] = 0.5F;
        QCOMPARE(distance(a, b), 0.625);
        QCOMPARE(distance(*descriptor_of(a), *descriptor_of(b)), 0.625);
        QCOMPARE(squared_distance(*descriptor_of(a), *descriptor_of(b)), 48 * 48 + 64 * 64);
        FaceDescriptor most{}, least{};
        most.fill(127);
        least.fill(-127);
        QCOMPARE(squared_distance(most, least), 128 * 254 * 254);
    }
    void bytes_are_as_far_apart_as_the_numbers() {
        std::mt19937 random(5);
        std::normal_distribution<float> normal(0.0F, 0.06F);
        for (int i = 0; i < 1000; ++i) {
            FaceNumbers a{}, b{};
            for (std::size_t n = 0; n < descriptor_length; ++n) {
                a[n] = normal(random);
                b[n] = a[n] + 0.4F * normal(random);
            }
            QVERIFY(std::abs(distance(a, b) - distance(*descriptor_of(a), *descriptor_of(b))) < 0.015);
        }
    }
};

} // namespace descriptor_test

TP_TEST(descriptor_test, DescriptorTest, event_loop)
#include "descriptor_test.moc"
