// SPDX-License-Identifier: Apache-2.0
// How wide eyes are under a finger, on the surface and within what each kind of device reaches.
#include "app/photo/scene/scene_builder.hpp"
#include "core/geometry/flatten.hpp"
#include "core/svg/contour_sheet.hpp"
#include "device/haply_2diy/pantograph.hpp"
#include "device/hid_pid/pid_joystick.hpp"
#include "faces/evaluation/placed_truth.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace scene_reach_test {

using namespace tp;

namespace {

struct Reach {
    const char* name;
    std::vector<Vec2> polygon; ///< mm, surface frame; empty: the whole surface
    bool whole_faces;          ///< it allows eyes of 25 mm in a face that is felt whole
    bool both_eyes = true;     ///< and where both eyes are felt, whoever's they are
};

std::vector<Vec2> circle(double radius) {
    std::vector<Vec2> corners;
    for (int i = 0; i < 16; ++i)
        corners.push_back(radius *
                          Vec2(std::cos(i * std::numbers::pi / 8.0), std::sin(i * std::numbers::pi / 8.0)));
    return corners;
}

std::vector<Vec2> rectangle(double width, double height) {
    const Vec2 half(0.5 * width, 0.5 * height);
    return {-half, {half.x, -half.y}, half, {-half.x, half.y}};
}

/// As a device without calibration lies: the middle of its reach on the middle of the surface.
std::vector<Vec2> in_the_middle(std::vector<Vec2> corners) {
    const Vec2 middle = bounds_of(corners).centre();
    for (Vec2& corner : corners)
        corner -= middle;
    return corners;
}

const std::vector<Reach>& reaches() {
    static const std::vector<Reach> all{
        {"mouse", {}, true},
        {"force pad on a tablet", rectangle(200, 150), true},
        {"small force pad", rectangle(120, 90), false},
        {"2diy, first", in_the_middle(Pantograph(HaplyGeneration::first).workspace()), false},
        {"2diy, third", in_the_middle(Pantograph(HaplyGeneration::third).workspace()), false},
        {"Falcon", circle(50.0), false, false},
        {"stick", rectangle(2.0 * PidJoystick::lever_mm, 2.0 * PidJoystick::lever_mm), false}};
    return all;
}

SurfaceSize surface_of(const Reach& reach) {
    SurfaceSize surface;
    surface.reach = reach.polygon;
    return surface;
}

bool is_in(const std::vector<Vec2>& polygon, Vec2 p) {
    double turned = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p;
        turned += std::atan2(cross(a, b), glm::dot(a, b));
    }
    return std::abs(turned) > std::numbers::pi;
}

/// Inside the surface's margin of 8 mm, and 4 mm inside the reach.
bool is_room_for(const Rect& rect, const std::vector<Vec2>& reach) {
    if (rect.min.x < -92.0 || rect.min.y < -67.0 || rect.max.x > 92.0 || rect.max.y > 67.0)
        return false;
    const Rect more{rect.min - 4.0, rect.max + 4.0};
    for (int i = 0; i <= 20 && !reach.empty(); ++i)
        for (int k = 0; k <= 20; ++k)
            if (!is_in(reach, glm::mix(more.min, more.max, 0.05 * Vec2(i, k))))
                return false;
    return true;
}

Extraction photo_of(std::vector<Contour> contours) {
    Extraction photo;
    photo.width = photo.height = 1000;
    photo.faces.emplace_back();
    photo.faces[0].contours = std::move(contours);
    return photo;
}

/// Nothing, or what of a face is not reached or too narrow.
QString complaint(const Extraction& photo, std::size_t face, const Reach& reach) {
    const auto about = [&](const char* what, double width) {
        return QString("%1, %2: %3 %4 mm").arg(reach.name, QString::number(face)).arg(what).arg(width);
    };
    for (const FacePart part : {FacePart::whole, FacePart::eyes, FacePart::left_eye, FacePart::mouth}) {
        const auto built = build_scene(photo, surface_of(reach), Subject{face, part});
        if (!built)
            return QString::fromStdString(built.error());
        const double width = narrowest_eye_mm(*built).value_or(0.0);
        if (part == FacePart::whole && reach.whole_faces && width < least_eye_mm)
            return about("whole", width);
        if (((part == FacePart::eyes && reach.both_eyes) || part == FacePart::left_eye) &&
            width < least_eye_mm)
            return about("eyes", width);
        std::vector<Vec2> points;
        for (const Contour& contour : built->scene.contours)
            for (const Vec2 p : flatten(contour).points)
                points.push_back(p);
        const Rect extent = bounds_of(points);
        const Vec2 half = 0.525 * (extent.max - extent.min);
        if (is_room_for({extent.centre() - half, extent.centre() + half}, reach.polygon))
            return about("could be larger", extent.width());
        for (const Vec2 p : points) {
            if (!reach.polygon.empty() && !is_in(reach.polygon, p))
                return about("not reached", length(p));
            if (std::abs(p.x) > 92.1 || std::abs(p.y) > 67.1)
                return about("beyond the margin", length(p));
        }
    }
    return {};
}

void by_reach() {
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < reaches().size(); ++i)
        QTest::newRow(reaches()[i].name) << static_cast<int>(i);
}

double eye_mm(const Extraction& photo, const Reach& reach, const Subject& subject) {
    return narrowest_eye_mm(build_scene(photo, surface_of(reach), subject).value()).value();
}

} // namespace

class SceneReachTest : public QObject {
    Q_OBJECT
private slots:
    void drawn_faces_are_reached_and_their_eyes_wide_enough_data() { by_reach(); }
    void drawn_faces_are_reached_and_their_eyes_wide_enough() {
        QFETCH(int, index);
        const Reach& reach = reaches()[static_cast<std::size_t>(index)];
        double whole = 1e9, eyes = 1e9;
        for (const char* name : {"anna_angry", "anna_sad", "anna_smiling", "anna_surprised", "ben_angry",
                                 "ben_smiling", "clara_sad"}) {
            const auto sheet =
                read_sheet(tp::test::in_source("resources/samples/") + std::string(name) + ".truth.svg",
                           ContourSheet::Unit::pixel);
            QVERIFY2(sheet.ok(), name);
            const Extraction photo = photo_of(sheet->contours);
            QCOMPARE(complaint(photo, 0, reach), QString());
            whole = std::min(whole, eye_mm(photo, reach, {0, FacePart::whole}));
            eyes = std::min(eyes, eye_mm(photo, reach, {0, FacePart::eyes}));
        }
        qInfo("%s: narrowest eye of a whole face %.1f mm, of both eyes %.1f mm", reach.name, whole, eyes);
    }

    void portraits_are_reached_and_their_eyes_wide_enough_data() { by_reach(); }
    void portraits_are_reached_and_their_eyes_wide_enough() {
        QFETCH(int, index);
        const Reach& reach = reaches()[static_cast<std::size_t>(index)];
        const std::filesystem::path photos = std::filesystem::path(tp::test::in_shared("faces")) / "photos";
        const auto people = read_placed_truth(photos / "london_truth.json", photos);
        if (!people)
            QSKIP("needs ../shared/faces/photos/london_truth.json");
        double whole = 1e9, eyes = 1e9;
        for (const PlacedPortrait& person : *people) {
            const Extraction photo = photo_of(person.truth);
            QCOMPARE(complaint(photo, 0, reach), QString());
            whole = std::min(whole, eye_mm(photo, reach, {0, FacePart::whole}));
            eyes = std::min(eyes, eye_mm(photo, reach, {0, FacePart::eyes}));
        }
        qInfo("%s: narrowest eye of %zu whole faces %.1f mm, of both eyes %.1f mm", reach.name,
              people->size(), whole, eyes);
    }

    /// Each of several people is as wide alone as if there were no others.
    void a_face_among_others_is_wide_enough_when_it_is_zoomed_to() {
        const auto sheet = read_sheet(tp::test::in_source("resources/samples/anna_smiling.truth.svg"),
                                      ContourSheet::Unit::pixel);
        Extraction photo = photo_of(sheet->contours);
        for (int i = 1; i < 5; ++i) {
            photo.faces.push_back(photo.faces[0]);
            for (Contour& contour : photo.faces.back().contours)
                contour = mapped(contour, [&](Vec2 p) { return 0.3 * p + Vec2(900.0 * i, 100.0 * i); });
        }
        for (const Reach& reach : reaches()) {
            QVERIFY(eye_mm(photo, reach, {}) < 10.0);
            for (std::size_t face = 0; face < photo.faces.size(); ++face)
                QCOMPARE(complaint(photo, face, reach), QString());
        }
    }

    /// A device whose middle is no place of it, or that lies beside the surface: the surface is filled as
    /// without.
    void a_reach_that_makes_no_sense_is_none() {
        const auto sheet = read_sheet(tp::test::in_source("resources/samples/ben_angry.truth.svg"),
                                      ContourSheet::Unit::pixel);
        const Extraction photo = photo_of(sheet->contours);
        const double usual = eye_mm(photo, reaches()[0], {});
        std::vector<Vec2> beside = rectangle(50.0, 50.0);
        for (Vec2& corner : beside)
            corner += Vec2(500.0, 0.0);
        const std::vector<Vec2> hollow{{-90, -60}, {90, -60},  {90, 60},  {80, 60},
                                       {80, -50},  {-80, -50}, {-80, 60}, {-90, 60}};
        for (const auto& polygon :
             {beside, hollow, std::vector<Vec2>{{0, 0}}, std::vector<Vec2>{{0, 0}, {9, 9}}})
            QCOMPARE(eye_mm(photo, {"", polygon, false}, {}), usual);
    }

    void without_eyes_none_is_narrow() {
        const Extraction photo =
            photo_of({contour_through(feature::outline, {{0, 0}, {50, 100}, {100, 0}}, false)});
        QVERIFY(!narrowest_eye_mm(build_scene(photo).value()));
    }
};

} // namespace scene_reach_test

TP_TEST(scene_reach_test, SceneReachTest, nothing)
#include "scene_reach_test.moc"
