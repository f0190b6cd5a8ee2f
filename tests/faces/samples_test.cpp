// SPDX-License-Identifier: Apache-2.0
#include "core/svg/contour_sheet.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/face_extractor.hpp"

#include <QTest>

#include <algorithm>

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

private slots:
    void contours_lie_on_the_painted_ones_data() {
        QTest::addColumn<QString>("stem");
        for (const auto& entry : fs::directory_iterator(TP_SOURCE_DIR "/resources/samples"))
            if (entry.path().extension() == ".jpg")
                QTest::newRow(entry.path().stem().c_str())
                    << QString::fromStdString(entry.path().stem().string());
    }
    void contours_lie_on_the_painted_ones() {
        QFETCH(QString, stem);
        const fs::path folder(TP_SOURCE_DIR "/resources/samples");
        const auto truth =
            read_sheet(folder / (stem.toStdString() + ".truth.svg"), ContourSheet::Unit::pixel);
        QVERIFY2(truth.ok(), truth.error().c_str());
        Extraction found = FaceExtractor::create().value().extract(folder / (stem.toStdString() + ".jpg"));
        QVERIFY2(found.problem.empty(), found.problem.c_str());
        std::sort(found.faces.begin(), found.faces.end(),
                  [](const Face& a, const Face& b) { return a.box.min.x < b.box.min.x; });

        // Percent of the outer inter-ocular distance.
        const std::vector<std::pair<const char*, double>> limits{{feature::right_eye, 2.0},
                                                                 {feature::left_eye, 2.0},
                                                                 {feature::outer_lip, 2.0},
                                                                 {feature::inner_lip, 2.0},
                                                                 {feature::outline, 3.5}};
        int people = 0;
        for (auto painted = person(*truth, 1); !painted.empty(); painted = person(*truth, ++people + 1)) {
            QVERIFY(found.faces.size() > static_cast<std::size_t>(people));
            const auto& contours = found.faces[static_cast<std::size_t>(people)].contours;
            QString line;
            for (const auto& [name, most] : limits) {
                const auto error = contour_error_percent(painted, contours, name);
                QVERIFY2(error.has_value(), name);
                line += QString(" %1 %2").arg(name).arg(*error, 0, 'f', 2);
                QVERIFY2(*error <= most, qPrintable(line));
            }
            qInfo("%s person %d:%s (%%)", qPrintable(stem), people + 1, qPrintable(line));
        }
        QCOMPARE(static_cast<int>(found.faces.size()), people);
    }
};

QTEST_GUILESS_MAIN(SamplesTest)
#include "samples_test.moc"
