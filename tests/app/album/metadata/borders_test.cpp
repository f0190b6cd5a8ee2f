// SPDX-License-Identifier: Apache-2.0
// What still counts as the same, as inside, as a number, and what no longer does: faces, recordings, two
// versions.
#include "app/album/metadata/face_regions.hpp"
#include "app/album/metadata/merge.hpp"
#include "app/album/metadata/number_text.hpp"
#include "app/album/metadata/tag_list.hpp"
#include "app/album/metadata/xmp_names.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace borders_test {

using namespace tp;

namespace {

XmpValue structure(const std::vector<std::pair<XmpName, std::string>>& fields) {
    XmpValue value;
    value.form = XmpValue::Form::structure;
    for (const auto& [name, text] : fields)
        value.set_field(name, XmpValue::of(text));
    return value;
}

XmpValue area(double x, double y, double width, double height, const std::string& unit = "normalized") {
    return structure({{xmp::area_x, number_text(x)},
                      {xmp::area_y, number_text(y)},
                      {xmp::area_width, number_text(width)},
                      {xmp::area_height, number_text(height)},
                      {xmp::area_unit, unit}});
}

/// Regions of faces with these areas, marked on a picture of that size; 0: nothing is said of it.
XmpValue regions(const std::vector<XmpValue>& areas, int width = 0, int height = 0) {
    XmpValue list;
    list.form = XmpValue::Form::bag;
    for (const XmpValue& one : areas) {
        XmpValue region = structure({{xmp::region_name, "Anna"}, {xmp::region_type, "Face"}});
        region.set_field(xmp::region_area, one);
        list.items.push_back(region);
    }
    XmpValue all;
    all.form = XmpValue::Form::structure;
    all.set_field(xmp::region_list, list);
    if (width > 0)
        all.set_field(xmp::applied_to, structure({{xmp::dimensions_width, std::to_string(width)},
                                                  {xmp::dimensions_height, std::to_string(height)},
                                                  {xmp::dimensions_unit, "pixel"}}));
    return all;
}

std::vector<FaceRegion> faces(const XmpValue& from, const PictureShape& shape = {4000, 3000, 1},
                              std::vector<std::string>* problems = nullptr) {
    std::vector<std::string> said;
    std::vector<FaceRegion> found = faces_from_mwg(from, shape, problems != nullptr ? *problems : said);
    return found;
}

bool near(double a, double b) { return std::abs(a - b) < 1e-12; }

} // namespace

class BordersTest : public QObject {
    Q_OBJECT
private slots:
    /// A hundredth is how programs round; what lies farther out is a slip and no face.
    void a_face_may_lie_a_hundredth_outside_and_is_brought_in() {
        for (const bool upright : {false, true}) {
            const auto at = [&](double place) {
                return upright ? area(0.5, place, 0.2, 0.3) : area(place, 0.5, 0.2, 0.3);
            };
            const auto found = faces(regions({at(-0.009), at(-0.011), at(1.009), at(1.011)}));
            QCOMPARE(found.size(), std::size_t{2});
            QCOMPARE(upright ? found[0].y : found[0].x, 0.0);
            QCOMPARE(upright ? found[1].y : found[1].x, 1.0);
        }
        const auto sized = faces(regions({area(0.5, 0.5, 0.0, 0.0), area(0.5, 0.5, 1.5, 2.5)}));
        QCOMPARE(sized.size(), std::size_t{2}); // a point, and one beyond the picture
        QVERIFY(sized[0].width == 0.0 && sized[1].width == 1.0 && sized[1].height == 1.0);
        QVERIFY(faces(regions({area(0.5, 0.5, -0.1, 0.1), area(0.5, 0.5, 0.1, -0.1)})).empty());
    }

    /// Which way the picture was turned when somebody marked a face on it: EXIF 5 to 8.
    void faces_marked_on_the_turned_picture_are_turned_back() {
        const XmpValue turned = regions({area(0.1, 0.3, 0.2, 0.4)}, 3000, 4000);
        for (const auto& [orientation, x, y] :
             {std::tuple{5, 0.3, 0.1}, {6, 0.3, 0.9}, {7, 0.7, 0.9}, {8, 0.7, 0.1}}) {
            const auto found = faces(turned, {4000, 3000, orientation});
            QCOMPARE(found.size(), std::size_t{1});
            QVERIFY(near(found[0].x, x) && near(found[0].y, y));
            QVERIFY(near(found[0].width, 0.4) && near(found[0].height, 0.2));
        }
        for (const int orientation :
             {1, 2, 3, 4}) { // upright or upside down: no other shape, so another picture
            std::vector<std::string> problems;
            const auto found = faces(turned, {4000, 3000, orientation}, &problems);
            QVERIFY(near(found.at(0).x, 0.1) && near(found[0].width, 0.2));
            QCOMPARE(problems.size(), std::size_t{1});
        }
    }

    /// Two hundredths of the logarithm of the aspect ratio are still one picture, scaled.
    void a_scaled_picture_is_the_same_and_a_cropped_one_is_said() {
        for (const auto& [width, cropped] :
             {std::pair{4000, false}, {4070, false}, {3930, false}, {4100, true}, {3900, true}}) {
            std::vector<std::string> problems;
            QCOMPARE(
                faces(regions({area(0.5, 0.5, 0.1, 0.1)}, width, 3000), {4000, 3000, 1}, &problems).size(),
                std::size_t{1});
            QCOMPARE(problems.size(), cropped ? std::size_t{1} : std::size_t{0});
            problems.clear(); // and of one that is turned
            faces(regions({area(0.5, 0.5, 0.1, 0.1)}, 3000, width), {4000, 3000, 6}, &problems);
            QCOMPARE(problems.size(), cropped ? std::size_t{1} : std::size_t{0});
        }
        std::vector<std::string> none;
        QVERIFY(faces(regions({}, 1000, 3000), {4000, 3000, 1}, &none).empty() && none.empty());
    }

    void circles_and_pixels_become_shares_of_the_picture() {
        XmpValue circle = area(0.5, 0.5, 0.0, 0.0);
        circle.set_field(xmp::area_diameter, XmpValue::of("0.3"));
        const auto round = faces(regions({circle}));
        QVERIFY(near(round.at(0).width, 0.225) && near(round[0].height, 0.3)); // of the shorter side
        const auto pixels = faces(regions({area(1000, 1500, 400, 600, "pixel")}));
        QVERIFY(near(pixels.at(0).x, 0.25) && near(pixels[0].y, 0.5) && near(pixels[0].width, 0.1) &&
                near(pixels[0].height, 0.2));
        const auto applied = faces(regions({area(500, 750, 200, 300, "pixel")}, 2000, 1500));
        QVERIFY(near(applied.at(0).x, 0.25) && near(applied[0].height, 0.2));
        QVERIFY(faces(regions({area(1000, 1500, 400, 600, "pixel")}), {0, 0, 1}).empty()); // of what?
        circle.set_field(xmp::area_unit, XmpValue::of("pixel"));
        circle.set_field(xmp::area_x, XmpValue::of("2000"));
        circle.set_field(xmp::area_y, XmpValue::of("1500"));
        circle.set_field(xmp::area_diameter, XmpValue::of("600"));
        const auto both = faces(regions({circle}));
        QVERIFY(near(both.at(0).width, 0.15) && near(both[0].height, 0.2));
    }

    /// What another program said of a region stays with the face that is still there, by its place, then its
    /// name.
    void a_region_is_known_again_within_a_thousandth() {
        XmpValue before = regions({area(0.5, 0.5, 0.2, 0.2)}, 4000, 3000);
        const XmpName theirs{"http://example.org/", "note"};
        XmpValue list = *before.field(xmp::region_list);
        list.items[0].set_field(theirs, XmpValue::of("kept"));
        before.set_field(xmp::region_list, list);
        const auto keeps = [&](const FaceRegion& face) {
            const XmpValue after = mwg_from_faces({face}, before, {4000, 3000, 1});
            return after.field(xmp::region_list)->items.at(0).field(theirs) != nullptr;
        };
        for (const double off : {0.0009, -0.0009, 0.0011, -0.0011}) {
            const bool near = std::abs(off) < 1e-3;
            QCOMPARE(keeps({0.5 + off, 0.5, 0.2, 0.2, "Tom"}), near);
            QCOMPARE(keeps({0.5, 0.5 + off, 0.2, 0.2, "Tom"}), near);
            QCOMPARE(keeps({0.5, 0.5, 0.2 + off, 0.2, "Tom"}), near);
            QCOMPARE(keeps({0.5, 0.5, 0.2, 0.2 + off, "Tom"}), near);
        }
        QVERIFY(keeps({0.9, 0.1, 0.1, 0.1, "Anna"})); // by her name
        QVERIFY(!keeps({0.9, 0.1, 0.1, 0.1, ""}));
    }

    void microsoft_s_rectangles_begin_at_their_corner() {
        const auto read = [](const char* rectangle) {
            XmpValue list;
            list.form = XmpValue::Form::bag;
            list.items.push_back(
                structure({{xmp::microsoft_name, "Anna"}, {xmp::microsoft_rectangle, rectangle}}));
            XmpValue info;
            info.form = XmpValue::Form::structure;
            info.set_field(xmp::microsoft_list, list);
            std::vector<std::string> problems;
            auto found = faces_from_microsoft(info, problems);
            return std::pair{found, problems.size()};
        };
        const auto [found, none] = read("0.1, 0.2, 0.4, 0.6");
        QVERIFY(near(found.at(0).x, 0.3) && near(found[0].y, 0.5) && near(found[0].width, 0.4) &&
                near(found[0].height, 0.6));
        QCOMPARE(none, std::size_t{0});
        for (const char* broken :
             {"0.1, 0.2, 0.4", "0.1, 0.2, 0.4, 0.6, 0.8", "0.1, 0.2, 0.4, x", "0.1 0.2 0.4 0.6", ","}) {
            QVERIFY2(read(broken).first.empty(), broken);
            QCOMPARE(read(broken).second, std::size_t{1});
        }
        QVERIFY(read("").first.empty() && read("").second == 0); // a person without a place
    }

    /// As far apart as two people may mark one face.
    void two_machines_marked_one_face_within_a_twentieth() {
        RecordParts ours;
        RecordParts theirs;
        ours.faces = std::vector<FaceRegion>{{0.5, 0.5, 0.2, 0.2, ""}};
        for (const double off : {0.049, -0.049, 0.051, -0.051})
            for (const bool upright : {false, true}) {
                theirs.faces = std::vector<FaceRegion>{
                    {upright ? 0.5 : 0.5 + off, upright ? 0.5 + off : 0.5, 0.2, 0.2, "Anna"}};
                const Merge both = merged(ours, theirs, false);
                QVERIFY(both.changes.faces.has_value());
                QCOMPARE(both.changes.faces->size(), std::abs(off) < 0.05 ? std::size_t{1} : std::size_t{2});
                QCOMPARE(both.changes.faces->at(0).name, std::string("Anna")); // named ones first
            }
    }

    void of_two_labels_the_newer_counts_and_a_number_that_is_there() {
        const Tag ours{"a.flac", {RecordingKind::memo, "Anna", "", "de", "", ""}, 2.0, 0.0, 1};
        const Tag theirs{"a.flac", {RecordingKind::story, "Tom", "Eva", "", "", ""}, 3.0, -4.0, 0};
        for (const bool newer : {false, true}) {
            RecordParts a;
            RecordParts b;
            a.tags = std::vector<Tag>{ours};
            b.tags = std::vector<Tag>{theirs};
            const Merge both = merged(a, b, newer);
            const Tag& tag = both.changes.tags->at(0);
            QCOMPARE(tag.label.kind, newer ? RecordingKind::story : RecordingKind::memo);
            QCOMPARE(tag.label.person, std::string(newer ? "Tom" : "Anna"));
            QCOMPARE(tag.label.speaker, std::string("Eva"));
            QCOMPARE(tag.label.language, std::string("de"));
            QCOMPARE(tag.duration_s, newer ? 3.0 : 2.0);
            QCOMPARE(tag.gain_db, -4.0);
            QCOMPARE(tag.order, 1);
            QCOMPARE(both.told.size(), std::size_t{2}); // the kind and the person
        }
        RecordParts same;
        same.tags = std::vector<Tag>{ours};
        QVERIFY(merged(same, same, true).told.empty() && !merged(same, same, true).changes.tags);
    }

    void a_place_in_a_person_s_order_is_1_to_a_million() {
        const auto order = [](const std::string& text) {
            XmpValue list;
            list.form = XmpValue::Form::seq;
            list.items.push_back(
                structure({{xmp::tag_file, "a.flac"}, {xmp::tag_order, text}, {xmp::tag_duration, "-3"}}));
            std::vector<std::string> problems;
            const std::vector<Tag> tags = tags_from(list, problems);
            return tags.at(0).duration_s == 0.0 ? tags[0].order : -1;
        };
        for (const auto& [text, number] : {std::pair{"1", 1},
                                           {"0.9", 0},
                                           {"0", 0},
                                           {"-1", 0},
                                           {"1000000", 1'000'000},
                                           {"1000001", 0},
                                           {"2.7", 2},
                                           {"x", 0}})
            QCOMPARE(order(text), number);
    }

    void a_name_that_leads_out_of_its_folder_is_none() {
        for (const char* name : {"a", "...", ".a", "a b.flac"})
            QVERIFY2(is_file_name(name), name);
        for (const std::string& name : {std::string(), std::string("."), std::string(".."),
                                        std::string("a/b"), std::string("a\\b"), std::string("a\0b", 3)})
            QVERIFY2(!is_file_name(name), name.c_str());
    }
};

} // namespace borders_test

TP_TEST(borders_test, BordersTest, event_loop)
#include "borders_test.moc"
