// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/contour_nets.hpp"
#include "faces/decode/picture.hpp"
#include "faces/detect/embedded_detector.hpp"
#include "faces/extract/face_search.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <cmath>

namespace face_search_test {

using namespace tp;

namespace {

Detection face_at(Vec2 corner, double size, double score) {
    const auto inside = [&](double x, double y) { return corner + size * Vec2(x, y); };
    return {{corner, corner + Vec2(size)}, inside(0.3, 0.4), inside(0.7, 0.4), score};
}

/// Sees what it is told to see.
class Told : public Detector {
public:
    explicit Told(std::vector<Detection> faces) : faces_(std::move(faces)) {}
    using Detector::detect;
    std::vector<Detection> detect(const cv::Mat&, Effort, Looks&, const std::stop_token&) override {
        return faces_;
    }

private:
    std::vector<Detection> faces_;
};

/// Confirms faces of one size, and remembers of which sizes it was asked.
class OneSize : public LandmarkModel {
public:
    OneSize(double size, double confidence) : size_(size), confidence_(confidence) {}
    std::optional<Landmarks> locate(const cv::Mat&, const Detection& face) override {
        asked.push_back(std::round(face.size()));
        if (std::abs(face.size() - size_) > 0.01)
            return std::nullopt;
        Landmarks points;
        points.right_eye.assign(16, face.right_eye);
        points.left_eye.assign(16, face.left_eye);
        points.outer_lip.assign(20, face.box.centre());
        points.confidence = confidence_;
        return points;
    }
    std::vector<double> asked;

private:
    double size_, confidence_;
};

using Sizes = std::vector<double>;

/// Of the faces that a search without a second opinion is told of, those at which the landmarks look closer.
Sizes looked_at(std::vector<Detection> told, double confirmed, double confidence) {
    OneSize landmarks(confirmed, confidence);
    FaceSearch search(std::make_unique<Told>(std::move(told)), landmarks, nullptr);
    SearchTimes times;
    search.upright(cv::Mat::zeros(400, 400, CV_8UC3), Effort::usual, times, {});
    return landmarks.asked;
}

/// A real face beside what is none, of which the landmarks say that it is one, and that the real face is none.
struct BesideAnother {
    cv::Mat picture = cv::Mat(500, 900, CV_8UC3, cv::Scalar::all(128));
    Detection real;

    BesideAnother() {
        const cv::Mat portrait = read_picture(tp::test::in_source("resources/samples/anna_sad.jpg")).value();
        cv::Mat small;
        cv::resize(portrait, small, {}, 200.0 / portrait.cols, 200.0 / portrait.cols, cv::INTER_AREA);
        small.copyTo(picture(cv::Rect({0, 0}, small.size())));
        real = EmbeddedDetector().detect(picture, Effort::usual).at(0);
    }
    /// The number of faces that are found where the real one is seen with that score.
    std::size_t found(double score, double other_size, double other_confidence) const {
        Detection here = real;
        here.score = score;
        OneSize landmarks(other_size, other_confidence);
        ContourNets nets;
        SecondOpinion mesh(nets);
        FaceSearch search(std::make_unique<Told>(std::vector{here, face_at({420.0, 10.0}, other_size, 1.0)}),
                          landmarks, &mesh);
        SearchTimes times;
        return search.upright(picture, Effort::usual, times, {}).size();
    }
};

} // namespace

class FaceSearchTest : public QObject {
    Q_OBJECT

private slots:
    /// Windows, leaves and cloth in a portrait look faintly like small faces.
    void what_is_hardly_seen_beside_a_large_face_is_not_looked_at() {
        const std::vector<Detection> told{face_at({10.0, 10.0}, 200.0, 0.9),
                                          face_at({300.0, 10.0}, 90.0, 0.4),
                                          face_at({300.0, 210.0}, 80.0, 0.6)};
        QCOMPARE(looked_at(told, 200.0, 0.99), (Sizes{200.0, 80.0}));
    }
    void beside_a_face_as_large_it_is() {
        const std::vector<Detection> told{face_at({10.0, 10.0}, 170.0, 0.9),
                                          face_at({300.0, 10.0}, 90.0, 0.4)};
        QCOMPARE(looked_at(told, 170.0, 0.99), (Sizes{170.0, 90.0}));
    }
    void beside_what_may_be_none_it_is() {
        const std::vector<Detection> told{face_at({10.0, 10.0}, 200.0, 0.9),
                                          face_at({300.0, 10.0}, 90.0, 0.4)};
        QCOMPARE(looked_at(told, 200.0, 0.9), (Sizes{200.0, 90.0}));
    }

    /// A face that the mesh alone sees is one; in a portrait the detector must see a small one well.
    void the_mesh_alone_confirms_small_faces_of_a_portrait_that_are_seen_well() {
        const BesideAnother face;
        const double larger = 2.1 * face.real.size(), as_large = 1.9 * face.real.size();
        QCOMPARE(face.found(0.8, larger, 0.99), std::size_t{2});
        QCOMPARE(face.found(0.7, larger, 0.99), std::size_t{1});
        QCOMPARE(face.found(0.6, as_large, 0.99), std::size_t{2});
        QCOMPARE(face.found(0.6, larger, 0.9), std::size_t{2});
        QCOMPARE(face.found(0.45, as_large, 0.99), std::size_t{1});
    }
};

} // namespace face_search_test

TP_TEST(face_search_test, FaceSearchTest, nothing)
#include "face_search_test.moc"
