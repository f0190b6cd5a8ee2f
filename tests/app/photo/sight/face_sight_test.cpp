// SPDX-License-Identifier: Apache-2.0
#include "app/photo/seen/seen_names.hpp"
#include "app/photo/sight/face_sight.hpp"
#include "app/photo/sight/look.hpp"
#include "app/photo/sight/photo_look.hpp"
#include "faces/extract/face_extractor.hpp"
#include "portraits.hpp"

#include <QTest>

#include <filesystem>
#include <limits>
#include <string>

using namespace tp;
namespace fs = std::filesystem;

namespace {

/// A frontal, open-eyed face of which everything is sure.
FaceMeasures plain_face() {
    FaceMeasures measures;
    measures.eye_openness = 0.3;
    measures.eyes_sure = measures.mouth_sure = true;
    return measures;
}

FaceMeasures face_with(double smile, double opening, double turn = 0.0) {
    FaceMeasures measures = plain_face();
    measures.smile = smile;
    measures.mouth_opening = opening;
    measures.turn = turn;
    return measures;
}

SeenPhoto seen_on(const char* sample) {
    return photo_look()(fs::path(tp::test::in_source("resources/samples")) / sample, Marks::no, {}).seen;
}

/// The face moved and enlarged.
Face moved(Face face, Vec2 by, double times) {
    for (Contour& contour : face.contours)
        contour = mapped(contour, [&](Vec2 point) { return times * point + by; });
    return face;
}

} // namespace

class FaceSightTest : public QObject {
    Q_OBJECT
private slots:
    void a_smile_is_said_with_as_much_doubt_as_there_is() {
        QCOMPARE(mien_of(face_with(1.4, 0.0)), Mien::unknown);
        QCOMPARE(mien_of(face_with(1.6, 0.0)), Mien::perhaps_smiling);
        QCOMPARE(mien_of(face_with(3.1, 0.0)), Mien::smiling);
        QCOMPARE(mien_of(face_with(6.0, 5.0)), Mien::smiling);
        QCOMPARE(mien_of(face_with(6.0, 15.0)), Mien::smiling_broadly);
        QCOMPARE(mien_of(face_with(6.0, 20.0)), Mien::perhaps_laughing);
        QCOMPARE(mien_of(face_with(1.0, 20.0)), Mien::unknown); // who speaks does not laugh
        QCOMPARE(mien_of(face_with(6.0, 15.0, 0.7)), Mien::perhaps_smiling);
        QCOMPARE(mien_of(face_with(6.0, 15.0, -0.7)), Mien::perhaps_smiling);
    }

    void what_is_covered_or_not_exact_is_not_guessed() {
        FaceMeasures measures = face_with(6.0, 15.0);
        measures.mouth_sure = false;
        QCOMPARE(mien_of(measures), Mien::unknown);
        measures = plain_face();
        measures.eye_openness = 0.0;
        QCOMPARE(eyes_of(measures), Eyes::shut);
        measures.eyes_sure = false;
        QCOMPARE(eyes_of(measures), Eyes::unknown);
    }

    void eyes_that_a_smile_narrows_are_not_shut() {
        FaceMeasures measures = plain_face();
        QCOMPARE(eyes_of(measures), Eyes::open);
        measures.eye_openness = 0.17;
        QCOMPARE(eyes_of(measures), Eyes::unknown);
        measures.eye_openness = 0.1;
        QCOMPARE(eyes_of(measures), Eyes::perhaps_shut);
    }

    void a_face_is_turned_to_where_less_of_it_is_seen() {
        QCOMPARE(facing_of(face_with(0.0, 0.0, 0.1)), Facing::camera);
        QCOMPARE(facing_of(face_with(0.0, 0.0, -0.29)), Facing::camera);
        QCOMPARE(facing_of(face_with(0.0, 0.0, 0.5)), Facing::unknown);
        QCOMPARE(facing_of(face_with(0.0, 0.0, 0.7)), Facing::left);
        QCOMPARE(facing_of(face_with(0.0, 0.0, -0.7)), Facing::right);
    }

    /// Much of the face is seen at the picture's right: it is turned to the left. And the mirror image.
    void left_and_right_are_those_of_the_picture() {
        const auto face_with_ends = [](double left_end, double right_end) {
            const auto around = [](double x, double y, double wide, double high) {
                return std::vector<Vec2>{{x - wide, y}, {x, y - high}, {x + wide, y}, {x, y + high}};
            };
            Face face;
            face.contours = {contour_through(feature::right_eye, around(40.0, 50.0, 6.0, 2.0), true),
                             contour_through(feature::left_eye, around(70.0, 50.0, 6.0, 2.0), true),
                             contour_through(feature::outer_lip, around(55.0, 80.0, 12.0, 5.0), true),
                             contour_through(feature::inner_lip, around(55.0, 80.0, 9.0, 1.0), true),
                             contour_through(feature::outline,
                                             {{left_end, 40.0}, {55.0, 110.0}, {right_end, 40.0}}, false)};
            return measures_of(face);
        };
        const auto left = face_with_ends(32.0, 110.0), right = face_with_ends(0.0, 78.0);
        QVERIFY(left && right);
        QCOMPARE(facing_of(*left), Facing::left);
        QCOMPARE(facing_of(*right), Facing::right);
    }

    void drawn_people_smile_where_they_were_drawn_so() {
        for (const char* sample : {"anna_smiling.jpg", "ben_smiling.jpg"}) {
            const SeenPhoto seen = seen_on(sample);
            QCOMPARE(seen.faces.size(), std::size_t(1));
            QVERIFY2(seen.faces[0].mien != Mien::unknown, sample);
            QCOMPARE(seen.faces[0].facing, Facing::camera);
            QVERIFY(!seen.faces[0].cut_off);
        }
        for (const char* sample : {"anna_sad.jpg", "ben_angry.jpg", "clara_sad.jpg", "anna_angry.jpg"})
            QCOMPARE(std::string(name_of(seen_on(sample).faces[0].mien)), std::string("unknown"));
        QCOMPARE(seen_on("ben_and_clara.jpg").faces.size(), std::size_t(2));
    }

    void measures_do_not_depend_on_place_and_size() {
        Result<FaceExtractor> extractor = FaceExtractor::create();
        const Extraction found =
            extractor->extract(fs::path(tp::test::in_source("resources/samples/anna_smiling.jpg")));
        const auto here = measures_of(found.faces.at(0));
        const auto there = measures_of(moved(found.faces.at(0), Vec2(-400.0, 900.0), 3.0));
        QVERIFY(here && there);
        QVERIFY(std::abs(here->smile - there->smile) < 0.05);
        QVERIFY(std::abs(here->turn - there->turn) < 1e-3);
        QVERIFY(std::abs(here->eye_openness - there->eye_openness) < 1e-3);
    }

    void a_face_without_contours_says_nothing_and_may_be_cut_off() {
        Extraction found;
        found.width = 100;
        found.height = 100;
        Face face;
        face.box = {Vec2(-10.0, 20.0), Vec2(40.0, 70.0)};
        found.faces = {face};
        const SeenPhoto seen = look_at(cv::Mat(100, 100, CV_8UC3, cv::Scalar::all(128)), found);
        QVERIFY(seen.faces.at(0).cut_off);
        QCOMPARE(seen.faces[0].mien, Mien::unknown);
        QCOMPARE(seen.faces[0].eyes, Eyes::unknown);
        QVERIFY(!measures_of(face));
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        Contour line;
        line.name = feature::right_eye;
        face.contours = {line};
        face.box = {Vec2(nan), Vec2(nan)};
        QVERIFY(!measures_of(face));
    }

    void what_cannot_be_read_has_no_size() {
        const SeenPhoto seen = photo_look()("/nowhere/at all.jpg", Marks::yes, {}).seen;
        QCOMPARE(seen.width, 0);
        QVERIFY(seen.faces.empty());
    }

    /// Neutral and smiling portraits of 68 people, from whom the smile was learned; what is told must hold for them.
    void portraits_of_people() {
        NEEDS_PORTRAITS();
        Result<FaceExtractor> extractor = FaceExtractor::create();
        std::size_t neutral = 0, smiling = 0, said = 0;
        for (const fs::directory_entry& entry :
             fs::directory_iterator(portraits::folder() / "photos/london")) {
            const std::string name = entry.path().filename().string();
            const bool smiles = name.ends_with("_08.jpg");
            if (!smiles && !name.ends_with("_03.jpg"))
                continue;
            const Extraction found = extractor->extract(entry.path());
            QVERIFY2(!found.faces.empty(), name.c_str());
            const auto measures = measures_of(found.faces[0]);
            QVERIFY(measures);
            const Mien mien = mien_of(*measures);
            ++(smiles ? smiling : neutral);
            if (smiles)
                said += mien == Mien::unknown ? 0 : 1;
            else
                QVERIFY2(mien == Mien::unknown, name.c_str());
            QVERIFY2(eyes_of(*measures) == Eyes::open || eyes_of(*measures) == Eyes::unknown, name.c_str());
            QVERIFY2(facing_of(*measures) == Facing::camera, name.c_str());
        }
        QVERIFY(neutral >= 60 && smiling >= 60);
        QVERIFY2(said * 2 >= smiling,
                 qPrintable(QString("a smile is said of %1 of %2").arg(said).arg(smiling)));
    }
};

QTEST_APPLESS_MAIN(FaceSightTest)
#include "face_sight_test.moc"
