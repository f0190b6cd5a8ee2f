// SPDX-License-Identifier: Apache-2.0
#include "app/photo/picture/colour_map.hpp"
#include "app/photo/picture/field_picture.hpp"
#include "app/photo/picture/overlay.hpp"
#include "app/photo/picture/picture_file.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace tp;

class PictureTest : public QObject {
    Q_OBJECT
private slots:
    void colours_grow_lighter_with_the_force() {
        int last = -1;
        for (double share = 0.0; share <= 1.0; share += 0.05) {
            const int lightness = qGray(field_colour(share).rgb());
            QVERIFY(lightness > last);
            last = lightness;
        }
        QCOMPARE(field_colour(std::nan("")), field_colour(0.0));
        QCOMPARE(field_colour(7.0), field_colour(1.0));
    }

    void the_field_is_brightest_at_the_range_and_dark_far_away() {
        const Scene scene{100.0, 60.0, {contour_through("line", {{-40, 0}, {40, 0}}, false)}};
        const auto haptic = make_haptic_scene(scene);
        const QImage image = draw_force_field(**haptic, scene.surface(), 4.0);
        QCOMPARE(image.width(), 400);
        QVERIFY(image.height() > 240);
        // The mean over the row of a height in mm, so that arrows, drawn on a grid, do not decide.
        const auto row = [&](double y) {
            double sum = 0.0;
            for (int x = 60; x < 340; ++x)
                sum += qGray(image.pixel(x, static_cast<int>((30.0 - y) * 4.0)));
            return sum / 280.0;
        };
        QVERIFY(row(4.0) > row(2.0) + 20.0);
        QVERIFY(row(4.0) > row(6.5) + 20.0);
        QVERIFY(row(20.0) < 40.0);
    }

    void a_field_that_nobody_wants_any_more_is_given_up() {
        const Scene scene{100.0, 60.0, {contour_through("line", {{-40, 0}, {40, 0}}, false)}};
        const auto haptic = make_haptic_scene(scene);
        std::stop_source wish;
        QVERIFY(!draw_force_field(**haptic, scene.surface(), 1.0, {}, wish.get_token()).isNull());
        wish.request_stop();
        QVERIFY(draw_force_field(**haptic, scene.surface(), 1.0, {}, wish.get_token()).isNull());
    }

    void the_overlay_marks_the_contour_and_leaves_the_rest() {
        const cv::Mat grey(200, 300, CV_8UC3, cv::Scalar(90, 90, 90));
        Extraction found;
        found.faces.emplace_back();
        found.faces[0].contours = {contour_through("left_eye", {{100, 50}, {200, 50}, {200, 150}}, true)};
        const QImage image = draw_overlay(grey, found);
        QCOMPARE(image.size(), QSize(300, 200));
        QVERIFY(image.pixel(150, 50) != qRgb(90, 90, 90));
        QCOMPARE(image.pixel(20, 180), qRgb(90, 90, 90));
        QVERIFY(draw_overlay(cv::Mat(), found).isNull());
        QCOMPARE(draw_overlay(cv::Mat(1000, 4000, CV_8UC3, cv::Scalar(0)), found).width(), 1600);
    }

    void a_picture_is_written_whole_or_not_at_all() {
        const QTemporaryDir folder;
        const std::string file = folder.filePath("a.png").toStdString();
        QVERIFY(write_image(file, QImage(4, 4, QImage::Format_RGB32)).ok());
        QCOMPARE(QImage(QString::fromStdString(file)).size(), QSize(4, 4));
        QVERIFY(!write_image(folder.filePath("no/such/folder/a.png").toStdString(),
                             QImage(4, 4, QImage::Format_RGB32))
                     .ok());
        QVERIFY(
            !write_image(folder.filePath("a.text").toStdString(), QImage(4, 4, QImage::Format_RGB32)).ok());
        QVERIFY(!QFile::exists(folder.filePath("a.text")));
    }
};

QTEST_MAIN(PictureTest)
#include "picture_test.moc"
