// SPDX-License-Identifier: Apache-2.0
#include "core/svg/contour_sheet.hpp"
#include "faces/decode/picture.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/extract/face_extractor.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <map>

namespace samples_test {

using namespace tp;
namespace fs = std::filesystem;

/// The portraits that come with the program, against the curves that were painted.
class SamplesTest : public QObject {
    Q_OBJECT

    /// The contours of person `number` (1 …) of a sheet: all, or those named "face_N.…", without that.
    static std::vector<Contour> person(const ContourSheet& sheet, int number) {
        const std::string prefix = "face_" + std::to_string(number) + ".";
        std::vector<Contour> found;
        for (Contour contour : sheet.contours)
            if (contour.name.starts_with(prefix)) {
                contour.name.erase(0, prefix.size());
                found.push_back(std::move(contour));
            }
        return found.empty() && number == 1 ? sheet.contours : found;
    }

    static std::vector<fs::path> photos() {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(tp::test::in_source("resources/samples")))
            if (entry.path().extension() == ".jpg")
                found.push_back(entry.path());
        std::sort(found.begin(), found.end());
        return found;
    }
    static ContourSheet painted_curves(const fs::path& photo) {
        auto sheet = read_sheet(fs::path(photo).replace_extension(".truth.svg"), ContourSheet::Unit::pixel);
        if (!sheet.ok())
            qFatal("%s", sheet.error().c_str());
        return *sheet;
    }
    static Extraction left_to_right(Extraction found) {
        std::sort(found.faces.begin(), found.faces.end(),
                  [](const Face& a, const Face& b) { return a.box.min.x < b.box.min.x; });
        return found;
    }

private slots:
    void contours_lie_on_the_painted_ones_data() {
        QTest::addColumn<QString>("photo");
        for (const fs::path& photo : photos())
            QTest::newRow(photo.stem().c_str()) << QString::fromStdString(photo.string());
    }
    void contours_lie_on_the_painted_ones() {
        QFETCH(QString, photo);
        const ContourSheet truth = painted_curves(photo.toStdString());
        const Extraction found =
            left_to_right(FaceExtractor::create().value().extract(fs::path(photo.toStdString())));
        QVERIFY2(found.problem.empty(), found.problem.c_str());

        // Percent of the outer inter-ocular distance.
        const std::vector<std::pair<const char*, double>> limits{{feature::right_eye, 2.0},
                                                                 {feature::left_eye, 2.0},
                                                                 {feature::outer_lip, 2.0},
                                                                 {feature::inner_lip, 1.0},
                                                                 {feature::outline, 3.5}};
        int people = 0;
        for (auto painted = person(truth, 1); !painted.empty(); painted = person(truth, ++people + 1)) {
            QVERIFY(found.faces.size() > static_cast<std::size_t>(people));
            const auto& contours = found.faces[static_cast<std::size_t>(people)].contours;
            QString line;
            for (const auto& [name, most] : limits) {
                const auto error = contour_error_percent(painted, contours, name);
                QVERIFY2(error.has_value(), name);
                line += QString(" %1 %2").arg(name).arg(*error, 0, 'f', 2);
                QVERIFY2(*error <= most, qPrintable(line));
            }
            qInfo("%s person %d:%s (%%)", fs::path(photo.toStdString()).stem().c_str(), people + 1,
                  qPrintable(line));
        }
        QCOMPARE(static_cast<int>(found.faces.size()), people);
    }

    void edges_bring_lips_to_the_painted_ones_data() {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("blur");
        QTest::addColumn<double>("noise");
        for (double scale : {2.0, 1.0, 0.5, 0.25})
            for (double blur : {0.0, 1.5})
                for (double noise : {0.0, 12.0})
                    QTest::addRow("scale %.2f, blur %.1f px, noise %.0f", scale, blur * scale, noise)
                        << scale << blur * scale << noise;
    }
    /// All portraits enlarged or shrunk, blurred, with a camera's noise. The painted upper lid is the lower
    /// edge of its lashes, where people who place lines by hand choose the middle: lids may not gain, but not
    /// lose either.
    void edges_bring_lips_to_the_painted_ones() {
        QFETCH(double, scale);
        QFETCH(double, blur);
        QFETCH(double, noise);
        FaceExtractor without =
            std::move(FaceExtractor::create({"embedded", "embedded", RefinementStage::close_looks})).value();
        FaceExtractor with = std::move(FaceExtractor::create()).value();
        const char* names[] = {feature::right_eye, feature::left_eye, feature::outer_lip, feature::inner_lip};
        std::map<std::string, double> before, after;
        int people = 0;
        for (const fs::path& photo : photos()) {
            const ContourSheet sheet = painted_curves(photo);
            cv::Mat picture;
            cv::resize(*read_picture(photo), picture, {}, scale, scale,
                       scale > 1.0 ? cv::INTER_CUBIC : cv::INTER_AREA);
            if (blur > 0.0)
                cv::GaussianBlur(picture, picture, {}, blur);
            cv::RNG random(1);
            cv::Mat grain(picture.size(), CV_16SC3);
            random.fill(grain, cv::RNG::NORMAL, 0.0, noise);
            cv::add(picture, grain, picture, cv::noArray(), CV_8U);
            const Extraction plain = left_to_right(without.extract(picture));
            const Extraction moved = left_to_right(with.extract(picture));
            for (int number = 1;; ++number) {
                std::vector<Contour> truth;
                for (const Contour& contour : person(sheet, number))
                    truth.push_back(mapped(contour, [&](Vec2 p) { return p * scale; }));
                if (truth.empty())
                    break;
                ++people;
                const auto index = static_cast<std::size_t>(number - 1);
                QVERIFY(index < plain.faces.size() && index < moved.faces.size());
                for (const char* name : names) {
                    before[name] += *contour_error_percent(truth, plain.faces[index].contours, name);
                    after[name] += *contour_error_percent(truth, moved.faces[index].contours, name);
                }
            }
        }
        for (const char* name : names) {
            qInfo("%-9s %.2f -> %.2f %%", name, before[name] / people, after[name] / people);
            QVERIFY2(after[name] <= before[name] + 0.05 * people, name);
        }
        QVERIFY(after[feature::inner_lip] < 0.8 * before[feature::inner_lip]);
        QVERIFY(after[feature::outer_lip] < before[feature::outer_lip]);
    }
};

} // namespace samples_test

TP_TEST(samples_test, SamplesTest, event_loop)
#include "samples_test.moc"
