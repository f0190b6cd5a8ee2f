// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/extraction_words.hpp"
#include "test_program.hpp"

#include <QTest>

namespace extraction_words_test {

using namespace tp;

namespace {

Face face_with(std::vector<const char*> names) {
    Face face;
    for (const char* name : names)
        face.contours.push_back(contour_through(name, {{0.0, 0.0}, {1.0, 1.0}}, false));
    return face;
}

const std::vector<const char*> everything{feature::left_eye, feature::right_eye, feature::outer_lip,
                                          feature::inner_lip, feature::outline};

} // namespace

class ExtractionWordsTest : public QObject {
    Q_OBJECT
private slots:
    void one_face() {
        Extraction extraction;
        extraction.faces = {face_with(everything)};
        QCOMPARE(describe(extraction), QString("One face. Eyes, mouth and outline can be felt."));
    }
    void several_faces() {
        Extraction extraction;
        extraction.faces = {face_with(everything), face_with(everything)};
        QCOMPARE(describe(extraction), QString("Two faces. Eyes, mouth and outline of each can be felt."));
    }
    void people_come_first() {
        Extraction extraction;
        extraction.faces = {face_with(everything), face_with(everything), face_with(everything)};
        QCOMPARE(describe(extraction, {"Anna", "", "Tom"}),
                 QString("Anna and Tom. Three faces. Eyes, mouth and outline of each can be felt."));
        QCOMPARE(listed({"Anna", "Tom", "Clara"}), QString("Anna, Tom and Clara"));
        QCOMPARE(listed({}), QString());
    }
    void a_fault_is_told_once_where_face_and_picture_have_the_same() {
        Extraction extraction;
        extraction.faces = {face_with({feature::outline})};
        extraction.problem = extraction.faces[0].problem = "It is partly covered.";
        QCOMPARE(describe(extraction), QString("One face. Outline can be felt. It is partly covered."));
    }
    void only_what_is_there_is_promised() {
        Extraction extraction;
        extraction.faces = {face_with({feature::outline})};
        QCOMPARE(describe(extraction), QString("One face. Outline can be felt."));
    }
    void a_doubtful_face_says_so() {
        Extraction extraction;
        extraction.faces = {face_with(everything)};
        extraction.faces[0].problem = "It is partly covered.";
        QVERIFY(describe(extraction).endsWith(" can be felt. It is partly covered."));
    }
    void no_face_says_why() {
        Extraction extraction;
        QCOMPARE(describe(extraction), QString("No face was found in this picture."));
        extraction.problem = "The file is damaged.";
        QCOMPARE(describe(extraction), QString("The file is damaged."));
    }
};

} // namespace extraction_words_test

TP_TEST(extraction_words_test, ExtractionWordsTest, event_loop)
#include "extraction_words_test.moc"
