// SPDX-License-Identifier: Apache-2.0
// A photograph that was just taken is looked at and told.
#include "app/capture/frames/photo_view.hpp"
#include "app/capture/shutter/taken_look.hpp"
#include "app/photo/words/description.hpp"
#include "faces/evaluation/closed_eyes.hpp"
#include "known_by.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace taken_look_test {

using namespace tp;

namespace {

cv::Mat anna() { return *read_picture(test::in_source("resources/samples/anna_smiling.jpg")); }

cv::Mat view(const cv::Mat& photo, const HeldPose& pose = {}, double exposure = 1.0) {
    FrameTaking taking;
    taking.exposure = exposure;
    return view_of(photo, {0.6, 1.0, {0.5, 0.45}}, pose, {}, {}, taking);
}

QString told(const TakenSight& sight) {
    return taken_words(taken_view(sight, QLocale::English), QLocale::English);
}
QString told(const SeenPhoto& seen, const std::vector<NamedFace>& known) {
    return told(TakenSight{seen, known});
}

} // namespace

class TakenLookTest : public QObject {
    Q_OBJECT
private slots:
    void who_is_known_is_named_where_they_are() {
        TakenLook look;
        const SeenPhoto seen = look.see(view(anna(), {.pan_deg = -14.0})).seen;
        QCOMPARE(seen.width, 1280);
        QCOMPARE(seen.faces.size(), std::size_t{1});
        const NamedFace known{seen.faces[0].part, "Anna"};
        QVERIFY2(told(seen, {known}).startsWith("Taken: Anna at the right, smiling"),
                 qPrintable(told(seen, {known})));
        QVERIFY(told(seen, {}).startsWith("Taken: one person at the right"));
        QVERIFY(told(seen, {{seen.faces[0].part, ""}}).startsWith("Taken: one person at the right"));
        QVERIFY(!told(seen, {{turned_back(seen.faces[0].part), "Tom"}}).contains("Tom at the right"));
    }

    void two_who_are_known_are_both_named() {
        TakenLook look;
        const SeenPhoto seen =
            look.see(*read_picture(test::in_source("resources/samples/ben_and_clara.jpg"))).seen;
        QCOMPARE(seen.faces.size(), std::size_t{2});
        const bool ben_first = seen.faces[0].part.min.x < seen.faces[1].part.min.x;
        const NamedFace ben{seen.faces[ben_first ? 0 : 1].part, "Ben"},
            clara{seen.faces[ben_first ? 1 : 0].part, "Clara"};
        const QString both = told(seen, {ben, clara});
        QVERIFY2(both.startsWith("Taken: Ben at the left") && both.contains("; Clara at the right"),
                 qPrintable(both));
        const QString one = told(seen, {clara});
        QVERIFY2(one.startsWith("Taken: two people: one at the left") && one.contains("; Clara at the right"),
                 qPrintable(one));
    }

    void the_album_names_everybody_whom_it_knows() {
        NEEDS_PORTRAITS();
        const auto portraits = portraits::held_out();
        cv::Mat both;
        std::vector<cv::Mat> halves;
        const auto people = std::make_shared<KnownPeople>();
        std::vector<NamedFaces> known;
        for (std::size_t i = 0; i < 2; ++i) {
            const cv::Mat portrait = *read_picture(portraits[i].photo);
            known.push_back(test::known_by(i == 0 ? "Mother" : "Aunt", portrait));
            halves.push_back(view(portrait).colRange(320, 960).clone());
        }
        people->know(known);
        cv::hconcat(halves, both);
        TakenLook look(people);
        const QString words = told(look.see(both));
        QVERIFY2(words.startsWith("Taken: Mother at the left") && words.contains("; Aunt at the right"),
                 qPrintable(words));
    }

    void whom_the_album_knows_is_named_and_nobody_else() {
        NEEDS_PORTRAITS();
        const auto portraits = portraits::held_out();
        const cv::Mat mother = *read_picture(portraits[0].photo),
                      stranger = *read_picture(portraits[1].photo);
        const auto people = std::make_shared<KnownPeople>();
        TakenLook look(people);
        QVERIFY(told(look.see(view(mother))).startsWith("Taken: one person"));
        people->know(
            {test::known_by("Mother", mother), test::known_by("Aunt", *read_picture(portraits[2].photo))});
        const QString named = told(look.see(view(mother, {.pan_deg = 5.0, .roll_deg = 8.0})));
        QVERIFY2(named.startsWith("Taken: Mother"), qPrintable(named));
        QVERIFY(told(look.see(view(stranger))).startsWith("Taken: one person"));
    }

    void a_mirrored_face_is_on_the_other_side() {
        const Rect back = turned_back({{0.1, 0.2}, {0.3, 0.6}});
        QVERIFY(length(back.min - Vec2(0.7, 0.2)) < 1e-12 && length(back.max - Vec2(0.9, 0.6)) < 1e-12);
    }

    void a_dark_picture_is_told() {
        TakenLook look;
        QVERIFY(!told(look.see(view(anna()))).contains("dark"));
        const QString dark = told(look.see(view(anna(), {}, 0.25)));
        QVERIFY2(dark.endsWith("A little dark."), qPrintable(dark));
    }

    void eyes_are_told() {
        NEEDS_PORTRAITS();
        TakenLook look;
        const auto people = portraits::held_out();
        const cv::Mat open = *read_picture(people[0].photo);
        const QString seen = told(look.see(view(open)));
        QVERIFY2(seen.contains("in the middle") && seen.contains("eyes open"), qPrintable(seen));
        const QString shut = told(look.see(view(with_closed_eyes(open, people[0].truth, 1.0, 1).picture)));
        QVERIFY2(shut.contains("shut") && !shut.contains("eyes open"), qPrintable(shut));
    }

    void what_is_no_picture_has_no_size() {
        TakenLook look;
        QCOMPARE(look.see({}).seen.width, 0);
        QCOMPARE(look.see(cv::Mat(20, 20, CV_8UC1)).seen.width, 0);
        const TakenSight plain = look.see(cv::Mat(90, 160, CV_8UC3, cv::Scalar(120, 120, 120)));
        QVERIFY(told(plain).startsWith("Taken: no faces."));
    }
};

} // namespace taken_look_test

TP_TEST(taken_look_test, TakenLookTest, nothing)
#include "taken_look_test.moc"
