// SPDX-License-Identifier: Apache-2.0
// Who is before the camera, by the eye's own look at frames of a simulated camera.
#include "app/capture/frames/photo_view.hpp"
#include "app/capture/seeing/aim_eye.hpp"
#include "app/capture/seeing/face_namer.hpp"
#include "faces/extract/quick_faces.hpp"
#include "known_by.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace face_namer_test {

using namespace tp;

namespace {

std::vector<cv::Mat> strangers(std::size_t count) {
    std::vector<cv::Mat> pictures;
    for (const auto& portrait : portraits::held_out())
        if (pictures.size() < count)
            pictures.push_back(*read_picture(portrait.photo));
    return pictures;
}

struct Bench {
    std::shared_ptr<KnownPeople> people = std::make_shared<KnownPeople>();
    AimEye eye;
    double time_s = 0.0;

    Bench() {
        eye.name_by([namer = std::make_shared<FaceNamer>(people)](const cv::Mat& frame, const Face& face) {
            return namer->name(frame, face);
        });
    }
    /// Whom the eye sees before a portrait as large as a person, its face about 20 cm high.
    std::string seen(const cv::Mat& photo, const HeldPose& pose = {}) {
        CameraFrame frame;
        frame.pixels = view_of(photo, {0.6, 1.0, {0.5, 0.45}}, pose, {}, {}, {});
        frame.time_s = time_s += 2.0 * AimEye::name_every_s;
        const AimFrame look = eye.see(frame);
        return look.faces.empty() ? "(no face)" : look.faces[0].name;
    }
};

} // namespace

class FaceNamerTest : public QObject {
    Q_OBJECT
private slots:
    void who_has_a_name_is_known_wherever_in_the_frame() {
        NEEDS_PORTRAITS();
        constexpr std::size_t count = 4;
        const std::vector<cv::Mat> pictures = strangers(count);
        Bench bench;
        std::vector<NamedFaces> family;
        for (std::size_t i = 0; i < count; ++i)
            family.push_back(test::known_by("person " + std::to_string(i), pictures[i]));
        bench.people->know(family);
        for (std::size_t i = 0; i < count; ++i)
            for (const HeldPose& pose :
                 {HeldPose{}, HeldPose{.pan_deg = 12.0, .roll_deg = 15.0}, HeldPose{.forward_m = -1.0}})
                QCOMPARE(bench.seen(pictures[i], pose), family[i].name);
    }
    void nobody_is_named_by_a_face_that_leaves_the_picture() {
        NEEDS_PORTRAITS();
        const cv::Mat picture = strangers(1)[0];
        const auto people = std::make_shared<KnownPeople>();
        people->know({test::known_by("Anna", picture)});
        QuickFaces faces;
        FaceNamer namer(people);
        const Face face = *faces.face_at(picture, faces.find(picture).at(0));
        QCOMPARE(namer.name(picture, face), std::string("Anna"));
        const int without_chin = static_cast<int>(face.box.min.y + 0.85 * face.box.height());
        QCOMPARE(namer.name(picture.rowRange(0, without_chin), face), std::string());
    }
    void a_stranger_has_none() {
        NEEDS_PORTRAITS();
        const std::vector<cv::Mat> pictures = strangers(3);
        Bench bench;
        bench.people->know({test::known_by("Anna", pictures[0])});
        QCOMPARE(bench.seen(pictures[0]), std::string("Anna"));
        QCOMPARE(bench.seen(pictures[1]), std::string());
        QCOMPARE(bench.seen(pictures[2]), std::string());
    }
    void who_is_forgotten_is_known_no_more() {
        NEEDS_PORTRAITS();
        const cv::Mat picture = strangers(1)[0];
        Bench bench;
        QCOMPARE(bench.seen(picture), std::string());
        bench.people->know({test::known_by("Anna", picture)});
        QCOMPARE(bench.seen(picture), std::string("Anna"));
        bench.people->know({});
        QCOMPARE(bench.seen(picture), std::string());
    }
};

} // namespace face_namer_test

TP_TEST(face_namer_test, FaceNamerTest, nothing)
#include "face_namer_test.moc"
