// SPDX-License-Identifier: Apache-2.0
// Contours that somebody else placed by hand, as a file: read, or refused with a sentence.
#include "byte_mutants.hpp"
#include "faces/evaluation/placed_truth.hpp"
#include "placed_truth_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace placed_truth_test {

using namespace tp;

namespace {

const std::string triangle = "[[1, 2], [3, 4.5], [5, 1]]";

/// A photograph with its five contours, of which one has other points.
std::string portrait(const std::string& name, const std::string& outline = triangle) {
    std::string text = "\"" + name + "\": {";
    for (const char* key :
         {"eye_on_the_left_of_the_picture", "eye_on_the_right_of_the_picture", "outer_lip", "inner_lip"})
        text += "\"" + std::string(key) + "\": " + triangle + ", ";
    return text + "\"outline\": " + outline + "}";
}

} // namespace

class PlacedTruthTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    Result<std::vector<PlacedPortrait>> read(const std::string& text) const {
        const std::filesystem::path file = folder_.filePath("truth.json").toStdString();
        std::ofstream(file, std::ios::binary) << text;
        return read_placed_truth(file, "/photos");
    }
    QString complaint(const std::string& text) const { return QString::fromStdString(read(text).error()); }

private slots:
    void each_photograph_has_its_five_contours() {
        const auto people = read("{" + portrait("001.jpg") + ", " + portrait("[{[{[{[{[{.jpg") + "}");
        QVERIFY2(people.ok(), people.error().c_str());
        QCOMPARE(people->size(), std::size_t(2));
        QCOMPARE((*people)[0].photo, std::filesystem::path("/photos/001.jpg"));
        QCOMPARE((*people)[1].truth.size(), std::size_t(5));
        QCOMPARE((*people)[1].truth[4].name, std::string("outline"));
        QCOMPARE((*people)[1].truth[4].pieces.size(), std::size_t(2)); // open, as an outline is
    }

    void what_is_no_truth_is_said_to_be_none_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("nobody") << QByteArray("{}");
        QTest::newRow("no JSON") << QByteArray("contours");
        QTest::newRow("a list") << QByteArray("[1, 2]");
        QTest::newRow("YAML, which OpenCV reads too")
            << "%YAML:1.0\n---\n" + QByteArray::fromStdString(portrait("a")).replace('"', "") + '\n';
        QTest::newRow("cut") << QByteArray::fromStdString("{" + portrait("001.jpg")).chopped(9);
        QTest::newRow("a zero in it") << QByteArray::fromStdString("{" + portrait("001.jpg") + "}") + '\0';
        QTest::newRow("levels without end") << "{\"001.jpg\": " + QByteArray(1'000'000, '[');
        QTest::newRow("nine levels") << "{\"001.jpg\": " + QByteArray(8, '[') + QByteArray(8, ']') + ", " +
                                            QByteArray::fromStdString(portrait("002.jpg")) + "}";
        QTest::newRow("a point without places")
            << QByteArray::fromStdString("{" + portrait("001.jpg", "[1, 2, 3]") + "}");
        QTest::newRow("beyond any picture")
            << QByteArray::fromStdString("{" + portrait("001.jpg", "[[1, 2], [3, 1e300], [5, 1]]") + "}");
        QTest::newRow("no number") << QByteArray::fromStdString(
            "{" + portrait("001.jpg", "[[1, 2], [3, .Nan], [5, 1]]") + "}");
    }
    void what_is_no_truth_is_said_to_be_none() {
        QFETCH(QByteArray, text);
        const QString said = complaint(text.toStdString());
        QVERIFY2(said.endsWith("truth.json\" cannot be read as contours placed by hand."), qPrintable(said));
    }

    /// Each file that is known, and some that are damaged.
    void whatever_it_holds_it_is_refused_or_has_contours() {
        const auto files = test::corpus(test::in_source("tests/faces/evaluation/truth_corpus"));
        for (const test::Seed& file : files)
            QCOMPARE(test::complaint_about_placed_truth(file.text), std::string());
        test::ByteMutator mutator(7);
        for (int i = 0; i < 300; ++i)
            QCOMPARE(test::complaint_about_placed_truth(mutator.mutant(files)), std::string());
    }

    void a_contour_that_is_missing_is_named() {
        QVERIFY(complaint("{" + portrait("00\u202E1.jpg", "[[1, 2], [3, 4]]") + "}")
                    .endsWith("a photo has no outline: 00 1.jpg"));
    }

    void a_file_is_never_larger_than_it_may_be() {
        const QString said = complaint("{" + std::string(16 << 20, ' ') + portrait("001.jpg") + "}");
        QVERIFY2(said.contains("is larger than 16 MB"), qPrintable(said));
        QVERIFY(read("{" + std::string(1 << 20, ' ') + portrait("001.jpg") + "}").ok());
        QVERIFY(!read_placed_truth("/dev/zero", "/photos").ok());
        QVERIFY(!read_placed_truth(folder_.filePath("none").toStdString(), "/photos").ok());
    }
};

} // namespace placed_truth_test

TP_TEST(placed_truth_test, PlacedTruthTest, nothing)
#include "placed_truth_test.moc"
