// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/flatten.hpp"
#include "drawn_pictures.hpp"
#include "effort.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/extract/face_extractor.hpp"
#include "places.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QSize>
#include <QTemporaryDir>
#include <QTest>

#include <opencv2/imgcodecs.hpp>

#include <algorithm>

namespace face_extractor_test {

using namespace tp;

namespace {

constexpr const char* no_face = "No face was found in this picture.";
constexpr const char* names[] = {feature::left_eye, feature::right_eye, feature::outer_lip,
                                 feature::inner_lip, feature::outline};

FaceExtractor extractor(const ExtractorChoice& choice = {}) {
    auto made = FaceExtractor::create(choice);
    if (!made)
        qFatal("%s", made.error().c_str());
    return std::move(made).value();
}

std::vector<Contour> moved(const std::vector<Contour>& contours, Vec2 scale, Vec2 offset) {
    std::vector<Contour> result;
    for (const Contour& contour : contours)
        result.push_back(mapped(contour, [&](Vec2 p) { return p * scale + offset; }));
    return result;
}

/// Largest of the five errors of `found` against `truth`, percent of the outer inter-ocular distance.
double largest_error(const std::vector<Contour>& truth, const std::vector<Contour>& found) {
    double largest = 0.0;
    for (const char* name : names)
        largest = std::max(largest, contour_error_percent(truth, found, name).value_or(1e9));
    return largest;
}

/// `portrait` shrunk until its face is `face_px` wide, on a calm background.
cv::Mat with_face_of(const cv::Mat& portrait, double face_width, int face_px, cv::Size size) {
    const double scale = face_px / face_width;
    cv::Mat small, picture(size, CV_8UC3, cv::Scalar(180, 170, 160));
    cv::resize(portrait, small, {}, scale, scale, cv::INTER_AREA);
    small.copyTo(picture(
        cv::Rect((size.width - small.cols) / 3, (size.height - small.rows) / 3, small.cols, small.rows)));
    return picture;
}

bool same(const Extraction& a, const Extraction& b) {
    if (a.faces.size() != b.faces.size() || a.problem != b.problem)
        return false;
    for (std::size_t f = 0; f < a.faces.size(); ++f)
        for (std::size_t c = 0; c < a.faces[f].contours.size(); ++c) {
            const auto& one = a.faces[f].contours[c].pieces;
            const auto& other = b.faces[f].contours[c].pieces;
            if (one.size() != other.size())
                return false;
            for (std::size_t i = 0; i < one.size(); ++i)
                for (double t : {0.0, 0.3, 1.0})
                    if (point_at(one[i], t) != point_at(other[i], t))
                        return false;
        }
    return true;
}

} // namespace

class FaceExtractorTest : public QObject {
    Q_OBJECT

private slots:
    void contours_are_well_formed() {
        NEEDS_PORTRAITS();
        const Extraction found = extractor().extract(portraits::one());
        QCOMPARE(found.faces.size(), std::size_t{1});
        const Face& face = found.faces[0];
        QCOMPARE(face.contours.size(), std::size_t{5});
        QVERIFY(face.score > 0.0 && face.score <= 1.0);
        for (std::size_t i = 0; i < 5; ++i) {
            const Contour& contour = face.contours[i];
            QCOMPARE(contour.name, std::string(names[i]));
            QCOMPARE(contour.closed, contour.name != feature::outline);
            for (std::size_t p = 0; p < contour.pieces.size(); ++p) {
                QVERIFY(is_finite(contour.pieces[p]));
                QVERIFY(!std::holds_alternative<Cubic>(contour.pieces[p]));
                if (p > 0)
                    QCOMPARE(start_of(contour.pieces[p]), end_of(contour.pieces[p - 1]));
            }
        }
        const auto centre = [&](const char* name) {
            return bounds_of(flatten(*contour_named(face.contours, name)).points).centre();
        };
        QVERIFY(centre(feature::right_eye).x <
                centre(feature::left_eye).x); // the person's own right is at our left
        QVERIFY(centre(feature::outer_lip).y > centre(feature::left_eye).y);
        QVERIFY(face.box.contains(centre(feature::outer_lip)));
    }

    void several_faces_come_largest_first() {
        NEEDS_PORTRAITS();
        FaceExtractor faces = extractor();
        const cv::Mat one = portraits::one(), other = portraits::one("london/011_08.jpg");
        cv::Mat small, both(one.rows, one.cols * 2, CV_8UC3, cv::Scalar(200, 200, 200));
        cv::resize(other, small, {}, 0.5, 0.5, cv::INTER_AREA);
        one.copyTo(both(cv::Rect(one.cols, 0, one.cols, one.rows)));
        small.copyTo(both(cv::Rect(100, 150, small.cols, small.rows)));
        const Extraction found = faces.extract(both);
        QCOMPARE(found.faces.size(), std::size_t{2});
        QVERIFY(found.problem.empty());
        const auto alone = faces.extract(one), other_alone = faces.extract(other);
        QVERIFY(largest_error(moved(alone.faces[0].contours, Vec2(1.0), Vec2(one.cols, 0)),
                              found.faces[0].contours) < 1.5);
        QVERIFY(largest_error(moved(other_alone.faces[0].contours, Vec2(0.5), Vec2(100, 150)),
                              found.faces[1].contours) < 1.5);
    }

    void grey_photographs_give_the_same_contours() {
        NEEDS_PORTRAITS();
        FaceExtractor faces = extractor();
        cv::Mat grey, wide;
        cv::cvtColor(portraits::one(), grey, cv::COLOR_BGR2GRAY);
        cv::cvtColor(grey, wide, cv::COLOR_GRAY2BGR);
        const Extraction found = faces.extract(wide);
        QCOMPARE(found.problem, std::string());
        const double error =
            largest_error(faces.extract(portraits::one()).faces[0].contours, found.faces[0].contours);
        QVERIFY2(error < 2.0, qPrintable(QString::number(error)));
    }

    void mirrored_pictures_give_mirrored_contours() {
        NEEDS_PORTRAITS();
        FaceExtractor faces = extractor();
        const auto people = portraits::held_out();
        double largest = 0.0;
        for (std::size_t i = 0; i < tp::test::tried_of(people.size()); i += 4) {
            const cv::Mat picture = *read_picture(people[i].photo);
            cv::Mat mirrored;
            cv::flip(picture, mirrored, 1);
            auto back =
                moved(faces.extract(mirrored).faces.at(0).contours, Vec2(-1.0, 1.0), Vec2(picture.cols, 0.0));
            for (Contour& contour : back)
                if (contour.name == feature::left_eye)
                    contour.name = feature::right_eye;
                else if (contour.name == feature::right_eye)
                    contour.name = feature::left_eye;
            largest = std::max(largest, largest_error(faces.extract(picture).faces.at(0).contours, back));
        }
        qInfo("largest difference to the mirrored pictures' contours: %.2f %%", largest);
        QVERIFY2(largest < 0.3, qPrintable(QString::number(largest)));
    }

    void large_pictures_give_the_same_contours_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("2.4 megapixel") << QSize(1350, 1800);
        QTest::newRow("50 megapixel") << QSize(6124, 8165);
    }
    void large_pictures_give_the_same_contours() {
        NEEDS_PORTRAITS();
        QFETCH(QSize, size);
        FaceExtractor faces = extractor();
        const cv::Mat whole = portraits::one();
        const cv::Mat picture = whole(cv::Rect(whole.cols / 8, 0, whole.cols * 3 / 4, whole.rows));
        cv::Mat large;
        cv::resize(picture, large, {size.width(), size.height()}, 0, 0, cv::INTER_CUBIC);
        faces.extract(large); // the nets allocate
        const Extraction found = faces.extract(large);
        QCOMPARE(found.problem, std::string());
        QCOMPARE(found.faces.size(), std::size_t{1});
        const Vec2 scale(static_cast<double>(large.cols) / picture.cols,
                         static_cast<double>(large.rows) / picture.rows);
        const double error = largest_error(
            moved(faces.extract(picture).faces.at(0).contours, scale, Vec2(0.0)), found.faces[0].contours);
        qInfo("%d × %d px: detect %.1f ms, landmarks %.1f ms, contours %.2f ms; %.2f %% from the small "
              "picture's contours",
              large.cols, large.rows, found.milliseconds.detect, found.milliseconds.landmarks,
              found.milliseconds.contours, error);
        QVERIFY2(error < 1.0, qPrintable(QString::number(error)));
    }

    void a_large_file_gives_the_contours_of_the_whole_picture_data() {
        QTest::addColumn<double>("scale");
        QTest::addColumn<int>("face_px");
        QTest::addColumn<bool>("sooner"); // from fewer pixels
        QTest::newRow("large") << 4.0 << 0 << true;
        QTest::newRow("just large enough") << 3.6 << 0 << true;
        QTest::newRow("50 megapixel") << 7.8 << 0 << true;
        QTest::newRow("small face in a large picture") << 0.0 << 120 << false;
        QTest::newRow("no face") << 0.0 << 0 << false;
    }
    void a_large_file_gives_the_contours_of_the_whole_picture() {
        NEEDS_PORTRAITS();
        QFETCH(double, scale);
        QFETCH(int, face_px);
        QFETCH(bool, sooner);
        QTemporaryDir folder;
        const std::filesystem::path file = (folder.path() + "/large.jpg").toStdString();
        FaceExtractor faces = extractor();
        const cv::Mat portrait = portraits::one();
        cv::Mat large(2400, 3200, CV_8UC3, cv::Scalar(180, 170, 160));
        if (scale > 0.0)
            cv::resize(portrait, large, {}, scale, scale, cv::INTER_CUBIC);
        else if (face_px > 0)
            large = with_face_of(portrait, faces.extract(portrait).faces.at(0).box.width(), face_px, large.size());
        cv::imwrite(file.string(), large, {cv::IMWRITE_JPEG_QUALITY, 97});
        const Extraction whole = faces.extract(*read_picture(file));
        const Extraction found = faces.extract(file);
        QCOMPARE(found.width, large.cols);
        QCOMPARE(found.height, large.rows);
        QCOMPARE(found.problem, whole.problem);
        QCOMPARE(found.faces.size(), whole.faces.size());
        QCOMPARE(same(found, whole), !sooner); // the same bits where all pixels were looked at
        if (!sooner)
            return;
        const Face &a = found.faces.at(0), &b = whole.faces.at(0);
        const double error = largest_error(b.contours, a.contours);
        qInfo("%d × %d px: %.2f %% from the whole picture's contours; decode %.0f, detect %.0f, landmarks %.0f, edges "
              "%.0f ms, of all its pixels detect %.0f, landmarks %.0f, edges %.0f ms",
              large.cols, large.rows, error, found.milliseconds.decode, found.milliseconds.detect,
              found.milliseconds.landmarks, found.milliseconds.edges, whole.milliseconds.detect,
              whole.milliseconds.landmarks, whole.milliseconds.edges);
        QVERIFY2(error < 0.3, qPrintable(QString::number(error)));
        QVERIFY(std::abs(a.box.width() - b.box.width()) < 0.03 * b.box.width());
        QCOMPARE(a.extras.size(), b.extras.size());
    }

    void small_faces_are_found_or_said_to_be_too_small_data() {
        QTest::addColumn<int>("face_px");
        for (int px : {80, 40, 25, 20})
            QTest::addRow("%d px", px) << px;
    }
    void small_faces_are_found_or_said_to_be_too_small() {
        NEEDS_PORTRAITS();
        QFETCH(int, face_px);
        FaceExtractor faces = extractor();
        const cv::Mat portrait = portraits::one();
        const double width = faces.extract(portrait).faces.at(0).box.width();
        const Extraction found = faces.extract(with_face_of(portrait, width, face_px, {1600, 1200}));
        QCOMPARE(found.faces.size(), std::size_t{1});
        QVERIFY(std::abs(found.faces[0].box.width() - face_px) < 0.25 * face_px);
        QCOMPARE(found.faces[0].problem, found.problem);
        if (face_px >= 40)
            QCOMPARE(found.problem, std::string());
        else
            QVERIFY2(found.problem.find("too small for its contours to be exact") != std::string::npos,
                     found.problem.c_str());
    }

    void faces_cut_by_the_border_say_where_data() {
        QTest::addColumn<QString>("edge");
        for (const char* edge : {"left", "right", "top", "bottom"})
            QTest::newRow(edge) << edge;
    }
    void faces_cut_by_the_border_say_where() {
        NEEDS_PORTRAITS();
        QFETCH(QString, edge);
        FaceExtractor faces = extractor();
        const cv::Mat picture = portraits::one();
        const Rect box = faces.extract(picture).faces.at(0).box;
        const auto px = [](double v) { return static_cast<int>(v); };
        const double part = 0.2 * box.width();
        cv::Rect kept(0, 0, picture.cols, picture.rows);
        if (edge == "left")
            kept = {px(box.min.x + part), 0, picture.cols - px(box.min.x + part), picture.rows};
        else if (edge == "right")
            kept.width = px(box.max.x - part);
        else if (edge == "top") // below the forehead, through the brows
            kept = {0, px(box.min.y + 1.6 * part), picture.cols, picture.rows - px(box.min.y + 1.6 * part)};
        else
            kept.height = px(box.max.y - part);
        const Extraction found = faces.extract(picture(kept));
        QCOMPARE(QString::fromStdString(found.problem),
                 "The face is cut off at the " + edge + " edge of the picture.");
    }

    void same_bytes_give_the_same_contours() {
        NEEDS_PORTRAITS();
        FaceExtractor faces = extractor();
        const cv::Mat picture = portraits::one();
        const Extraction first = faces.extract(picture);
        cv::RNG random(1);
        faces.extract(drawn::clouds(random, {500, 900}, 40));
        QVERIFY(same(first, faces.extract(picture)));
        QVERIFY(same(first, extractor().extract(picture)));
    }

    void files_give_the_same_contours_as_pictures() {
        NEEDS_PORTRAITS();
        QTemporaryDir folder;
        const std::string file = (folder.path() + "/portrait.png").toStdString();
        const cv::Mat picture = portraits::one();
        cv::imwrite(file, picture);
        FaceExtractor faces = extractor();
        const Extraction found = faces.extract(std::filesystem::path(file));
        QVERIFY(same(found, faces.extract(picture)));
        QCOMPARE(found.width, picture.cols);
        QCOMPARE(found.height, picture.rows);
        QVERIFY(found.milliseconds.decode > 0.0);
    }

    void pictures_without_a_face_say_so() {
        FaceExtractor faces = extractor();
        cv::RNG random(2);
        for (const cv::Mat& picture : drawn::without_faces(random, {640, 480})) {
            const Extraction found = faces.extract(picture);
            QVERIFY(found.faces.empty());
            QCOMPARE(found.problem, std::string(no_face));
        }
    }

    void strange_pictures_are_safe_data() {
        QTest::addColumn<cv::Mat>("picture");
        QTest::addColumn<QString>("problem");
        QTest::newRow("empty") << cv::Mat() << "The picture is empty.";
        QTest::newRow("1x1") << cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(9))
                             << "The picture is only 1 × 1 pixels, too small to show a face.";
        QTest::newRow("3x2000") << cv::Mat(3, 2000, CV_8UC3, cv::Scalar::all(9))
                                << "The picture is only 2000 × 3 pixels, too small to show a face.";
        QTest::newRow("2000x3") << cv::Mat(2000, 3, CV_8UC3, cv::Scalar::all(9))
                                << "The picture is only 3 × 2000 pixels, too small to show a face.";
        QTest::newRow("16x16") << cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(9)) << no_face;
        QTest::newRow("16x60000") << cv::Mat(16, 60000, CV_8UC3, cv::Scalar::all(9)) << no_face;
        QTest::newRow("black") << cv::Mat(600, 800, CV_8UC3, cv::Scalar::all(0)) << no_face;
        QTest::newRow("white") << cv::Mat(600, 800, CV_8UC3, cv::Scalar::all(255)) << no_face;
        QTest::newRow("grey") << cv::Mat(600, 800, CV_8UC1, cv::Scalar::all(90))
                              << "The picture is not in 8-bit colour.";
        QTest::newRow("floats") << cv::Mat(600, 800, CV_32FC3, cv::Scalar::all(NAN))
                                << "The picture is not in 8-bit colour.";
    }
    void strange_pictures_are_safe() {
        QFETCH(cv::Mat, picture);
        QFETCH(QString, problem);
        const Extraction found = extractor().extract(picture);
        QCOMPARE(QString::fromStdString(found.problem), problem);
        QVERIFY(found.faces.empty());
        QCOMPARE(found.width, picture.cols);
    }

    void a_search_that_is_asked_to_stop_ends_without_faces() {
        FaceExtractor faces = extractor();
        const cv::Mat picture = *read_picture(tp::test::in_source("resources/samples/anna_smiling.jpg"));
        std::stop_source stop;
        QCOMPARE(faces.extract(picture, stop.get_token()).faces.size(), std::size_t{1});
        stop.request_stop();
        const Extraction stopped = faces.extract(picture, stop.get_token());
        QCOMPARE(stopped.faces.size(), std::size_t{0});
        QCOMPARE(stopped.problem, std::string("The search for faces was stopped."));
        QCOMPARE(faces.extract(picture).faces.size(), std::size_t{1});
    }

    void unreadable_files_say_why() {
        const Extraction found = extractor().extract(std::filesystem::path("/nowhere/at/all.jpg"));
        QCOMPARE(found.problem, std::string("There is no such file."));
        QCOMPARE(found.width, 0);
    }
};

} // namespace face_extractor_test

TP_TEST(face_extractor_test, FaceExtractorTest, event_loop)
#include "face_extractor_test.moc"
