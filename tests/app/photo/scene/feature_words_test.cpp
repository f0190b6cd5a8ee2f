// SPDX-License-Identifier: Apache-2.0
#include "app/photo/scene/feature_words.hpp"
#include "test_program.hpp"

#include <QTest>

namespace feature_words_test {

class FeatureWordsTest : public QObject {
    Q_OBJECT
private slots:
    void says_what_a_person_would_say() {
        const auto said = [](const char* name) { return QString::fromStdString(tp::spoken_feature(name)); };
        QCOMPARE(said("left_eye"), QString("left eye"));
        QCOMPARE(said("outer_lip"), QString("lips"));
        QCOMPARE(said("inner_lip"), QString("mouth opening"));
        QCOMPARE(said("outline"), QString("face outline"));
        QCOMPARE(said("face 2 outer_lip"), QString("lips of face 2"));
        QCOMPARE(said("a garden_gate"), QString("a garden gate"));
        QCOMPARE(said("face "), QString("face "));
        QCOMPARE(said(""), QString());
    }
};

} // namespace feature_words_test

TP_TEST(feature_words_test, FeatureWordsTest, nothing)
#include "feature_words_test.moc"
