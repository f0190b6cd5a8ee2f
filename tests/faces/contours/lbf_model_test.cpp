// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/polyline.hpp"
#include "drawn_facemark.hpp"
#include "faces/contours/lbf_model.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/extract/face_extractor.hpp"
#include "faces/models/lbf_file.hpp"
#include "faces/models/model_catalog.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <opencv2/core/persistence.hpp>

#include <fstream>
#include <random>

using namespace tp;
using namespace drawn_facemark;
namespace fs = std::filesystem;

namespace {

double largest_gap(const Points& line, const Points& points) {
    double largest = 0.0;
    for (const Vec2 p : points)
        largest = std::max(largest, distance_to({line, true}, p));
    return largest;
}

double mean_distance(const Points& a, const Points& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += length(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

std::string bytes_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

class LbfModelTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::vector<DrawnFace> faces_;
    std::string file_;

    std::string put(const char* name, const std::string& content) const {
        const std::string file = (folder_.path() + "/" + name).toStdString();
        std::ofstream(file, std::ios::binary) << content;
        return file;
    }

private slots:
    void initTestCase() {
        quiet_opencv();
        faces_ = drawn_faces();
        file_ = (folder_.path() + "/small.yaml").toStdString();
        train(faces_, file_);
    }

    void our_features_pass_through_the_68_points() {
        Points points;
        for (const cv::Point2f p : points_68(faces_[2].points))
            points.emplace_back(p.x, p.y);
        const Landmarks found = features_of_68(points);
        const auto part = [&](std::size_t begin, std::size_t end) {
            return Points(points.begin() + static_cast<std::ptrdiff_t>(begin),
                          points.begin() + static_cast<std::ptrdiff_t>(end));
        };
        QCOMPARE(found.right_eye.size(), std::size_t{16});
        QCOMPARE(found.left_eye.size(), std::size_t{16});
        QCOMPARE(found.outer_lip.size(), std::size_t{20});
        QCOMPARE(found.inner_lip.size(), std::size_t{20});
        const double eyes = length(points[45] - points[36]);
        QVERIFY(largest_gap(found.right_eye, part(36, 42)) < 0.02 * eyes);
        QVERIFY(largest_gap(found.left_eye, part(42, 48)) < 0.02 * eyes);
        QVERIFY(largest_gap(found.outer_lip, part(48, 60)) < 0.02 * eyes);
        QVERIFY(largest_gap(found.inner_lip, part(60, 68)) < 0.02 * eyes);
        QVERIFY(largest_gap(found.outline, part(0, 17)) < 0.02 * eyes);
        QCOMPARE(found.right_eye[0], points[36]);
        QCOMPARE(found.right_eye[eye_corner], points[39]);
        QCOMPARE(found.left_eye[0], points[45]);
        QCOMPARE(found.left_eye[eye_corner], points[42]);
        QCOMPARE(found.outer_lip[mouth_corner], points[54]);
        QVERIFY(found.right_eye[4].y > found.right_eye[12].y); // the lower lid first
        QVERIFY(found.left_eye[4].y > found.left_eye[12].y);
        QVERIFY(found.outer_lip[5].y > found.outer_lip[15].y);
        QVERIFY(found.inner_lip[5].y > found.inner_lip[15].y);
        QVERIFY(found.right_brow.empty() && found.nose.empty());
    }
    void points_on_one_another_are_safe() {
        for (const std::size_t different : {std::size_t{0}, std::size_t{1}, std::size_t{30}}) {
            Points points(68, Vec2(3.0));
            for (std::size_t i = 0; i < different; ++i)
                points[2 * i] = Vec2(static_cast<double>(i), 5.0);
            const Landmarks found = features_of_68(points);
            for (const Points* line : {&found.right_eye, &found.outer_lip, &found.inner_lip, &found.outline})
                for (const Vec2 p : *line)
                    QVERIFY(is_finite(p));
        }
    }

    void a_facemark_places_the_faces_that_it_learned() {
        const auto model = std::move(LbfModel::load(file_)).value();
        double eyes = 0.0, lips = 0.0, outline = 0.0;
        for (const DrawnFace& face : faces_) {
            const auto found = model->locate(face.picture, face.detection);
            QVERIFY(found && found->confidence >= 0.5);
            const double percent =
                100.0 / length(face.points.left_eye[0] - face.points.right_eye[0]) / double(faces_.size());
            eyes += percent * mean_distance(found->right_eye, face.points.right_eye);
            lips += percent * mean_distance(found->outer_lip, face.points.outer_lip);
            outline += percent * mean_distance(found->outline, face.points.outline);
        }
        qInfo("of what it learned: eyes %.1f, lips %.1f, outline %.1f %%", eyes, lips, outline);
        QVERIFY(eyes < 5.0 && lips < 8.0 && outline < 12.0);
    }
    void a_face_on_its_side_has_the_same_contours() {
        const auto model = std::move(LbfModel::load(file_)).value();
        const DrawnFace& face = faces_[2];
        const Landmarks upright = model->locate(face.picture, face.detection).value();
        cv::Mat side;
        cv::rotate(face.picture, side, cv::ROTATE_90_CLOCKWISE);
        const auto map = [&](Vec2 p) { return Vec2(face.picture.rows - p.y, p.x); };
        Detection there = face.detection;
        const Vec2 corner = map(Vec2(face.detection.box.min.x, face.detection.box.max.y));
        there.box = {corner, corner + Vec2(face.detection.box.height(), face.detection.box.width())};
        there.right_eye = map(face.detection.right_eye);
        there.left_eye = map(face.detection.left_eye);
        const auto tilted = model->locate(side, there);
        QVERIFY(tilted);
        Points wanted;
        for (const Vec2 p : upright.outer_lip)
            wanted.push_back(map(p));
        const double eyes = length(upright.left_eye[0] - upright.right_eye[0]);
        QVERIFY(mean_distance(wanted, tilted->outer_lip) < 0.05 * eyes);
    }
    void where_no_face_is_none_is_seen() {
        const auto model = std::move(LbfModel::load(file_)).value();
        cv::RNG random(4);
        cv::Mat noise(600, 600, CV_8UC3);
        random.fill(noise, cv::RNG::UNIFORM, 0, 255);
        for (Detection place : {faces_[0].detection, Detection{{{0, 0}, {9, 9}}, {1e9, 0}, {1e9, 50}, 1.0},
                                Detection{{{0, 0}, {9, 9}}, {5, 5}, {5, 5}, 1.0}}) {
            const auto found = model->locate(noise, place);
            QVERIFY(!found || found->confidence < 0.5);
        }
    }

    void it_is_chosen_by_its_file_and_by_its_name() {
        const auto extracted = [&](const std::string& choice) {
            return FaceExtractor::create({"embedded", choice}).value().extract(faces_[2].picture);
        };
        QCOMPARE(extracted(file_).faces.size(), std::size_t{1});
        const QByteArray before = qgetenv("TOUCHPHOTO_MODELS");
        qputenv("TOUCHPHOTO_MODELS", folder_.path().toUtf8());
        const std::string missing = FaceExtractor::create({"embedded", "lbf"}).error();
        QVERIFY2(missing.find("\"lbf\" is not installed") != std::string::npos, missing.c_str());
        fs::copy_file(file_, fs::path(folder_.path().toStdString()) / lbf_model.file);
        QCOMPARE(extracted("lbf").faces.size(), std::size_t{1});
        qputenv("TOUCHPHOTO_MODELS", before);
    }

    void hostile_files_are_a_sentence_data() {
        QTest::addColumn<QByteArray>("content");
        const QByteArray good = QByteArray::fromStdString(bytes_of(file_));
        const auto with = [&](const char* old, const char* other) {
            return QByteArray(good).replace(good.indexOf(old), static_cast<qsizetype>(qstrlen(old)), other);
        };
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("a letter") << QByteArray("Dear Anna");
        QTest::newRow("only the header") << QByteArray("%YAML:1.0\n---\n");
        QTest::newRow("cut in the middle") << good.first(good.size() / 2);
        QTest::newRow("cut at its end") << good.first(good.size() - 300);
        QTest::newRow("another number of points") << with("n_landmarks: 68", "n_landmarks: 29");
        QTest::newRow("more stages than it has") << with("stages_n: 2", "stages_n: 9");
        QTest::newRow("no stages") << with("stages_n: 2", "stages_n: 0");
        QTest::newRow("countless trees") << with("tree_n: 3", "tree_n: 2000000000");
        QTest::newRow("deeper trees than it has") << with("tree_depth: 3", "tree_depth: 4");
        QTest::newRow("negative depth") << with("tree_depth: 3", "tree_depth: -3");
        QTest::newRow("depth in words") << with("tree_depth: 3", "tree_depth: deep");
        QTest::newRow("a table is missing") << with("tree_1_67_2:", "tree_1_67_9:");
        QTest::newRow("thresholds are missing") << with("thresholds_0_0_0:", "thresholds_9_0_0:");
        QTest::newRow("a table of another size") << with("rows: 8", "rows: 7");
        QTest::newRow("an enormous table") << with("rows: 8", "rows: 2000000000");
        QTest::newRow("a table of whole numbers") << with("dt: d", "dt: i");
        QTest::newRow("nested brackets") << QByteArray("%YAML:1.0\n---\na: " + QByteArray(1'000'000, '['));
        QTest::newRow("nested brackets, one a line")
            << QByteArray("%YAML:1.0\n---\na: " + QByteArray("[\n").repeated(500'000));
        QTest::newRow("nested braces") << QByteArray("%YAML:1.0\n---\na: " + QByteArray(1'000'000, '{'));
        QTest::newRow("nested lists")
            << QByteArray("%YAML:1.0\n---\na: " + QByteArray("- ").repeated(500'000));
        QTest::newRow("nested names") << QByteArray("%YAML:1.0\n---\n" + QByteArray("a: ").repeated(500'000));
        QTest::newRow("another format") << QByteArray("<?xml version=\"1.0\"?><opencv_storage/>");
    }
    void hostile_files_are_a_sentence() {
        QFETCH(QByteArray, content);
        const std::string error = LbfModel::load(put("hostile.yaml", content.toStdString())).error();
        QVERIFY2(error.ends_with("is not an LBF facemark of 68 points that can be used."), error.c_str());
    }
    void a_missing_file_is_a_sentence() {
        QVERIFY(LbfModel::load("/nowhere/lbfmodel.yaml").error().ends_with("that can be used."));
        QVERIFY(LbfModel::load(folder_.path().toStdString()).error().ends_with("that can be used."));
    }
    /// Whatever is damaged: it is refused, or safe to use.
    void damaged_files_are_safe() {
        const std::string good = bytes_of(file_);
        std::mt19937 random(8);
        const std::string signs = "0123456789ABZaz+/=:-[]{} \n.%!\"'";
        int used = 0;
        for (int i = 0; i < 24; ++i) {
            std::string bad = good;
            for (unsigned k = 0; k <= random() % 4; ++k)
                bad[random() % (i % 2 ? bad.size() : 2000)] = signs[random() % signs.size()];
            const auto model = LbfModel::load(put("damaged.yaml", bad));
            if (!model.ok())
                continue;
            ++used;
            (*model)->locate(faces_[1].picture, faces_[1].detection);
        }
        qInfo("%d of 24 damaged files could be used", used);
    }
};

QTEST_GUILESS_MAIN(LbfModelTest)
#include "lbf_model_test.moc"
