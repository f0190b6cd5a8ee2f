// SPDX-License-Identifier: Apache-2.0
#include "app/photo/picture/friction_map.hpp"
#include "app/photo/picture/picture_file.hpp"
#include "scenes.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <limits>

using namespace tp;
using namespace tp::testing;

namespace {

const Rect surface{{-100, -100}, {100, 100}};

QImage map_of(const FlatScene& scene, const FrictionChoices& choices, const Rect& where, double dots) {
    const auto drawn = draw_friction_map(scene, choices, where, dots);
    return drawn ? *drawn : QImage();
}

} // namespace

class FrictionMapTest : public QObject {
    Q_OBJECT
private slots:
    /// Told again from the distance to each line, without an index.
    void each_dot_is_what_the_law_says_there() {
        const FlatScene face = face_scene(60);
        FrictionChoices choices;
        choices.strength = 0.9;
        choices.width_mm = 3.0;
        const QImage map = map_of(face, choices, surface, 2.5);
        QVERIFY(map.width() == 500 && map.height() == 500 && map.format() == QImage::Format_Grayscale8);
        int on_ridges = 0;
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x) {
                const Vec2 place(-100.0 + (x + 0.5) / 2.5, 100.0 - (y + 0.5) / 2.5);
                double distance = 1e9;
                for (const Polyline& line : face.lines)
                    distance = std::min(distance, distance_to(line, place));
                const double share = std::max(0.0, 1.0 - distance / 1.5);
                const double level = 0.9 * (3.0 * share * share - 2.0 * share * share * share);
                QVERIFY(std::abs(map.constScanLine(y)[x] - 255.0 * level) <= 0.5 + 1e-9);
                on_ridges += level > 0.0 ? 1 : 0;
            }
        QVERIFY(on_ridges > 5000);
    }

    void stripes_fill_the_textured_features_alone() {
        const FlatScene face = face_scene(60);
        FrictionChoices choices;
        choices.textured = {"outer_lip", "inner_lip"};
        choices.texture = 0.6;
        choices.texture_mm = 4.0;
        choices.width_mm = 1.0;
        const QImage map = map_of(face, choices, surface, 4.0);
        const auto grey = [&](double x, double y) {
            return map.constScanLine(int((100.0 - y) * 4.0))[int((x + 100.0) * 4.0)];
        };
        QVERIFY(grey(0.0, -40.0) > 145);                          // in the upper lip, on a stripe
        QVERIFY(grey(2.0, -40.0) < 10);                           // between two
        QVERIFY(grey(0.0, -45.0) == 0 && grey(-32.0, 30.0) == 0); // in the mouth, in an eye
    }

    void it_is_true_to_scale_in_the_file_too() {
        QTemporaryDir folder;
        const Rect card{{-42.8, -27.0}, {42.8, 27.0}}; // 85.6 × 54 mm
        const QImage map = map_of(face_scene(30), {}, card, 11.811);
        QVERIFY(map.width() == 1012 && map.height() == 638); // 1011.02 and 637.79 dots
        QVERIFY(map.dotsPerMeterX() == 11811 && map.dotsPerMeterY() == 11811);
        const std::string file = folder.filePath("map.png").toStdString();
        QVERIFY(write_image(file, map).ok());
        QFile bytes(QString::fromStdString(file));
        QVERIFY(bytes.open(QIODevice::ReadOnly));
        // the chunk pHYs: 11811 = 0x2e23 along x and y, per metre
        QVERIFY(bytes.readAll().contains(QByteArray("pHYs\0\0\x2e\x23\0\0\x2e\x23\1", 13)));
        const QImage read(QString::fromStdString(file));
        QVERIFY(read.format() == QImage::Format_Grayscale8 && read == map);
        QCOMPARE(map_of(face_scene(30), {}, {{0, 0}, {30, 20}}, 10.0).size(), QSize(300, 200));
    }

    void what_cannot_be_is_said_in_a_sentence() {
        const FlatScene face = face_scene(30);
        FrictionChoices bad;
        bad.width_mm = -1.0;
        QVERIFY(draw_friction_map(face, bad, surface, 5.0).error().ends_with('.'));
        for (const double dots : {0.0, -1.0, 1001.0, std::nan(""), std::numeric_limits<double>::infinity()})
            QVERIFY(draw_friction_map(face, {}, surface, dots).error().find("1000 dots") !=
                    std::string::npos);
        QVERIFY(draw_friction_map(face, {}, surface, 101.0).error().find("fewer dots") != std::string::npos);
        QVERIFY(draw_friction_map(face, {}, surface, 0.9).error().find("narrower than two dots") !=
                std::string::npos);
        QVERIFY(draw_friction_map(face, {}, surface, 1.0).ok());
    }

    void it_can_be_stopped() {
        std::stop_source stop;
        int reports = 0;
        const auto drawn =
            draw_friction_map(face_scene(30), {}, surface, 5.0, stop.get_token(), [&](double share) {
                QVERIFY(share >= 0.0 && share < 1.0);
                if (++reports == 10)
                    stop.request_stop();
            });
        QVERIFY(drawn.ok() && drawn->isNull() && reports == 10);
    }
};

QTEST_APPLESS_MAIN(FrictionMapTest)
#include "friction_map_test.moc"
