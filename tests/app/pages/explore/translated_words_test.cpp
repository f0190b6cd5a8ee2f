// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/extraction_words.hpp"
#include "app/pages/explore/feature_labels.hpp"
#include "app/pages/explore/place_words.hpp"
#include "app/photo/scene/feature_words.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/servo/fault.hpp"
#include "faces/base/face.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QTest>
#include <QTranslator>

#include <algorithm>
#include <string>

namespace translated_words_test {

using namespace tp;

namespace {

/// Every text becomes itself between brackets.
class Brackets final : public QTranslator {
public:
    QString translate(const char*, const char* source, const char*, int) const override {
        return "[" + QString::fromUtf8(source) + "]";
    }
    bool isEmpty() const override { return false; }
};

} // namespace

class TranslatedWordsTest : public QObject {
    Q_OBJECT
private slots:
    void every_feature_has_a_word_to_translate() {
        for (const char* name : {feature::left_eye, feature::right_eye, feature::outer_lip, feature::inner_lip,
                                 feature::outline, feature::left_brow, feature::right_brow, feature::nose,
                                 feature::left_iris, feature::right_iris}) {
            const std::string word = spoken_feature(name);
            QVERIFY2(std::ranges::any_of(translatable_features(), [&](const char* one) { return word == one; }),
                     word.c_str());
        }
    }
    void every_fault_is_there_to_translate() {
        Brackets brackets;
        QCoreApplication::installTranslator(&brackets);
        for (int i = 1; i <= static_cast<int>(Fault::device_lost); ++i) {
            const std::string english = sentence(static_cast<Fault>(i));
            QCOMPARE(in_persons_language(english), '[' + QString::fromStdString(english) + ']');
        }
        QCoreApplication::removeTranslator(&brackets);
    }
    void features_with_their_owners() {
        QCOMPARE(feature_label(feature::left_eye, "Anna", 2), QString("left eye of Anna"));
        QCOMPARE(feature_label(feature::left_eye, {}, 2), QString("left eye of face 2"));
        QCOMPARE(feature_label(feature::outer_lip, {}, 0), QString("lips"));
        QCOMPARE(at_the_start("left eye"), QString("Left eye"));
        QCOMPARE(at_the_start({}), QString());
    }
    void nothing_is_said_past_the_catalogue() {
        Brackets brackets;
        QCoreApplication::installTranslator(&brackets);
        QCOMPARE(feature_word(feature::left_eye), QString("[left eye]"));
        Extraction extraction;
        extraction.faces.resize(1);
        extraction.faces[0].contours = {contour_through(feature::left_eye, {{0, 0}, {1, 1}}, false),
                                        contour_through(feature::outline, {{0, 0}, {1, 1}}, false)};
        extraction.problem = "No face was found in this picture.";
        QCOMPARE(describe(extraction, {"Anna"}), QString("[Anna.] [One face.] [[[eyes] and [outline]] can be felt.] "
                                                         "[No face was found in this picture.]"));
        QVERIFY(where_am_i({"Anna", false, "x", false, 2, 6}).startsWith("[Anna. "));
        QCoreApplication::removeTranslator(&brackets);
    }
};

} // namespace translated_words_test

TP_TEST(translated_words_test, TranslatedWordsTest, event_loop)
#include "translated_words_test.moc"
