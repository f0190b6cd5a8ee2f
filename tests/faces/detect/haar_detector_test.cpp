// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture.hpp"
#include "faces/detect/haar_detector.hpp"
#include "faces/extract/face_extractor.hpp"
#include "faces/models/model_catalog.hpp"
#include "places.hpp"
#include "square_cascade.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <random>

using namespace tp;
namespace fs = std::filesystem;

namespace {

/// With one thing replaced.
QByteArray with(const char* old, const char* other) {
    const auto good = QByteArray::fromStdString(square_cascade::xml);
    const qsizetype at = good.indexOf(old);
    return at < 0 ? QByteArray() : QByteArray(good).replace(at, static_cast<qsizetype>(qstrlen(old)), other);
}

} // namespace

class HaarDetectorTest : public QObject {
    Q_OBJECT

    const std::optional<fs::path> known_ = installed_file(haar_model); ///< where the user has it
    QTemporaryDir folder_;

    fs::path put(const char* name, const std::string& content) const {
        const fs::path file = fs::path(folder_.path().toStdString()) / name;
        std::ofstream(file, std::ios::binary) << content;
        return file;
    }
    std::unique_ptr<Detector> squares() const {
        return std::move(HaarDetector::load(put("squares.xml", square_cascade::xml))).value();
    }

private slots:
    void init() {
        qputenv("TOUCHPHOTO_MODELS", folder_.path().toUtf8());
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
    }

    void what_the_cascade_describes_is_found_where_it_is_data() {
        QTest::addColumn<int>("enlarged");
        QTest::newRow("small") << 1;
        QTest::newRow("shrunk to search it") << 5;
    }
    void what_the_cascade_describes_is_found_where_it_is() {
        QFETCH(int, enlarged);
        const int side = 60 * enlarged;
        const Vec2 middle(180 * enlarged, 130 * enlarged);
        const cv::Mat picture =
            square_cascade::picture({400 * enlarged, 300 * enlarged}, {int(middle.x), int(middle.y)}, side);
        for (const Effort effort : {Effort::usual, Effort::thorough}) {
            const auto found = squares()->detect(picture, effort);
            QCOMPARE(found.size(), std::size_t{1});
            const Detection& face = found[0];
            // The window is twice as large as the square, the head 1.08 times as large as that.
            QVERIFY(std::abs(face.size() - 2.16 * side) < 0.2 * side);
            QVERIFY(length(face.box.centre() - middle) < 0.2 * side);
            QVERIFY(face.score > 0.1 && face.score < 1.0);
            QVERIFY(face.right_eye.x < middle.x && face.left_eye.x > middle.x);
            QVERIFY(face.right_eye.y == face.left_eye.y && face.right_eye.y < middle.y);
            QVERIFY(std::abs(face.left_eye.x - face.right_eye.x - 0.73 * side) < 0.1 * side);
        }
    }
    void where_there_is_none_none_is_found() {
        QVERIFY(
            squares()->detect(cv::Mat(300, 400, CV_8UC3, cv::Scalar::all(128)), Effort::thorough).empty());
        QVERIFY(squares()->detect(cv::Mat::zeros(16, 16, CV_8UC3), Effort::usual).empty());
    }
    /// Putting windows together takes the square of their number.
    void a_cascade_that_sees_faces_everywhere_ends() {
        const auto everywhere =
            HaarDetector::load(put("everywhere.xml", QByteArray(with("5.0000000000000000e-01", "-5."))
                                                         .replace("5.0000000000000000e-01", "-5.")
                                                         .toStdString()));
        QVERIFY2(everywhere.ok(), everywhere.error().c_str());
        cv::RNG random(4);
        cv::Mat noise(1280, 1280, CV_8UC3);
        random.fill(noise, cv::RNG::UNIFORM, 0, 255);
        const auto found = (*everywhere)->detect(noise, Effort::thorough);
        QVERIFY(!found.empty() && found.size() < 10'000);
    }

    void it_is_chosen_by_its_file_and_by_its_name() {
        const fs::path file = put("squares.xml", square_cascade::xml);
        QCOMPARE(find_model(file.string(), PluggableModel::Role::detector)->kind, &haar_model);
        QVERIFY(FaceExtractor::create({file.string(), "embedded"}).ok());
        const auto by_name = FaceExtractor::create({"haar", "embedded"});
        if (!fs::exists(haar_model.of_system))
            QVERIFY2(by_name.error().find("\"haar\" is not installed") != std::string::npos &&
                         by_name.error().find("opencv-data") != std::string::npos,
                     by_name.error().c_str());
        const fs::path own = put(haar_model.file, square_cascade::xml);
        QCOMPARE(find_model("haar", PluggableModel::Role::detector)->file, own);
        QVERIFY(FaceExtractor::create({"haar", "embedded"}).ok());
        QCOMPARE(problem_with_model(haar_model, own), std::string());
        // It finds a square; our nets see that this is no face.
        const cv::Mat picture = square_cascade::picture({400, 300}, {180, 130}, 60);
        QCOMPARE(FaceExtractor::create({"haar", "embedded"}).value().extract(picture).problem,
                 std::string("No face was found in this picture."));
        fs::remove(own);
    }
    void the_known_cascade_finds_drawn_faces() {
        if (!known_)
            QSKIP("needs Debian's package opencv-data");
        auto faces = FaceExtractor::create({known_->string(), "embedded"}).value();
        for (const char* name : {"anna_smiling", "ben_angry", "clara_sad"}) {
            const fs::path photo = std::string(tp::test::in_source("resources/samples/")) + name + ".jpg";
            QCOMPARE(faces.extract(photo).faces.size(), std::size_t{1});
        }
    }

    void hostile_files_are_a_sentence_data() {
        QTest::addColumn<QByteArray>("content");
        const auto good = QByteArray::fromStdString(square_cascade::xml);
        const QByteArray begun("<?xml version=\"1.0\"?><opencv_storage>");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("a letter") << QByteArray("Dear Anna");
        QTest::newRow("only the header") << QByteArray("<?xml version=\"1.0\"?>");
        QTest::newRow("no elements") << begun + "</opencv_storage>";
        QTest::newRow("cut in the middle") << good.first(good.size() / 2);
        QTest::newRow("cut at its end") << good.first(good.size() - 30);
        QTest::newRow("a comment without end") << with("-->", "");
        QTest::newRow("another classifier") << with("opencv-cascade-classifier", "opencv-haar-classifier");
        QTest::newRow("other features") << with("HAAR", "LBP");
        QTest::newRow("features with categories") << with("<maxCatCount>0", "<maxCatCount>256");
        QTest::newRow("no window") << with("<width>24", "<width>0");
        QTest::newRow("a negative window") << with("<height>24", "<height>-24");
        QTest::newRow("a countless window") << with("<width>24", "<width>2000000000");
        QTest::newRow("a window in words") << with("<width>24", "<width>wide");
        QTest::newRow("a smaller window than its features'") << with("<width>24", "<width>20");
        QTest::newRow("no stages") << with("<stages>", "<others>").replace("</stages>", "</others>");
        QTest::newRow("a threshold in words") << with("5.0000000000000000e-01", "half");
        QTest::newRow("an endless threshold") << with("5.0000000000000000e-01", "1e999");
        QTest::newRow("a feature beyond the last") << with("0 -1 0 1.6", "0 -1 2 1.6");
        QTest::newRow("a negative feature") << with("0 -1 0 1.6", "0 -1 -1 1.6");
        QTest::newRow("a leaf beyond the last") << with("0 -1 0 1.6", "0 -2 0 1.6");
        QTest::newRow("a branch beyond the last") << with("0 1 0 1. -1", "0 2 0 1. -1");
        QTest::newRow("a branch back") << with("1. -1 -2 1 0.", "1. -1 1 1 0.");
        QTest::newRow("a node without threshold") << with("0 -1 0 1.6000000238418579e+00", "0 -1 0");
        QTest::newRow("a leaf too few") << with("-1. 1. 1.", "-1. 1.");
        QTest::newRow("no leaves") << with("-1. 1.</leafValues>", "</leafValues>");
        QTest::newRow("a rectangle beyond the window") << with("6 6 12 12 4.", "16 6 12 12 4.");
        QTest::newRow("a rectangle below the window") << with("6 6 12 12 4.", "6 16 12 12 4.");
        QTest::newRow("a negative rectangle") << with("6 6 12 12 4.", "-6 6 12 12 4.");
        QTest::newRow("a rectangle of overflowing size") << with("6 6 12 12 4.", "6 6 2147483647 12 4.");
        QTest::newRow("a rectangle of four numbers") << with("6 6 12 12 4.", "6 6 12 12");
        QTest::newRow("a turned rectangle beyond the window") << with("12 2 10 10 1.", "2 2 10 10 1.");
        QTest::newRow("a turned rectangle below the window") << with("12 2 10 10 1.", "12 12 10 10 1.");
        QTest::newRow("four rectangles")
            << with("6 6 12 12 4.</_>", "6 6 12 12 4.</_><_>0 0 1 1 1.</_><_>0 0 1 1 1.</_>");
        QTest::newRow("no rectangles") << with("<_>\n          12 2 10 10 1.</_>", "");
        QTest::newRow("no features") << with("<features>", "<others>").replace("</features>", "</others>");
        QTest::newRow("nested elements") << begun + QByteArray("<a>").repeated(500'000);
        QTest::newRow("nested elements behind closed ones")
            << begun + QByteArray("</a>").repeated(500'000) + QByteArray("<a>").repeated(500'000);
        QTest::newRow("nested elements in a list") << begun + "<a>" + QByteArray("<_>").repeated(500'000);
        QTest::newRow("an entity") << with("HAAR", "&haar;");
        QTest::newRow("a document type")
            << with("<opencv_storage>", "<!DOCTYPE a [<!ENTITY a \"aaaa\">]><opencv_storage>");
        QTest::newRow("binary numbers") << with("<rects>", "<rects type_id=\"binary\">");
        QTest::newRow("a zero byte") << good.first(100) + '\0' + good.mid(101);
        QTest::newRow("a long word") << with("HAAR", QByteArray(100'000, 'A').constData());
        QTest::newRow("another format") << QByteArray("%YAML:1.0\n---\ncascade: 1\n");
        QTest::newRow("many bytes") << good + QByteArray(9'000'000, ' ');
    }
    void hostile_files_are_a_sentence() {
        QFETCH(QByteArray, content);
        const std::string error = HaarDetector::load(put("hostile.xml", content.toStdString())).error();
        QVERIFY2(error.ends_with("is not a Haar cascade that can be used."), error.c_str());
    }
    void a_missing_file_is_a_sentence() {
        QVERIFY(HaarDetector::load("/nowhere/cascade.xml").error().ends_with("that can be used."));
        QVERIFY(HaarDetector::load(folder_.path().toStdString()).error().ends_with("that can be used."));
    }
    /// Whatever is damaged: it is refused, or safe to use.
    void damaged_files_are_safe() {
        const cv::Mat picture = square_cascade::picture({80, 60}, {40, 30}, 20);
        std::mt19937 random(8);
        const std::string signs = "0123456789AB_/<>-. \n&\"!";
        int used = 0;
        for (int i = 0; i < 400; ++i) {
            std::string bad = square_cascade::xml;
            for (unsigned k = 0; k <= random() % 3; ++k) {
                std::size_t at = random() % bad.size();
                if (i % 2) // a digit becomes another
                    at = bad.find_last_of("0123456789", std::max(at, bad.find("1.0")));
                bad[at] = signs[random() % (i % 2 ? 10 : signs.size())];
            }
            const auto detector = HaarDetector::load(put("damaged.xml", bad));
            if (!detector.ok())
                continue;
            ++used;
            (*detector)->detect(picture, Effort::usual);
        }
        qInfo("%d of 400 damaged files could be used", used);
        QVERIFY(used > 0 && used < 400);
    }
};

QTEST_GUILESS_MAIN(HaarDetectorTest)
#include "haar_detector_test.moc"
