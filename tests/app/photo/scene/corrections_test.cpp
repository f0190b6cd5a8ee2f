// SPDX-License-Identifier: Apache-2.0
#include "app/photo/scene/corrections.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace corrections_test {

using namespace tp;

namespace {

Contour box_contour(const char* name, Vec2 at, double side) {
    return contour_through(name, {at, at + Vec2(side, 0), at + Vec2(side, side), at + Vec2(0, side)}, true);
}

Face face_at(double x, double y, double size) {
    Face face;
    face.box = {{x, y}, {x + size, y + size}};
    face.score = 0.9;
    face.contours = {box_contour(feature::left_eye, {x + 0.6 * size, y + 0.3 * size}, 0.2 * size),
                     box_contour(feature::outer_lip, {x + 0.3 * size, y + 0.7 * size}, 0.3 * size)};
    face.problem = "The face is too small.";
    return face;
}

Extraction photo(std::vector<Face> faces) {
    Extraction extraction;
    extraction.width = 1000;
    extraction.height = 800;
    extraction.faces = std::move(faces);
    extraction.problem =
        extraction.faces.empty() ? "No face was found in this picture." : extraction.faces.front().problem;
    return extraction;
}

Vec2 start_of_contour(const Face& face, const std::string& name) {
    for (const Contour& contour : face.contours)
        if (contour.name == name)
            return start_of(contour.pieces.front());
    return {-1.0, -1.0};
}

ContourSheet sheet_with(std::vector<Contour> contours, double width = 1000, double height = 800) {
    return {width, height, ContourSheet::Unit::pixel, std::move(contours)};
}

} // namespace

class CorrectionsTest : public QObject {
    Q_OBJECT
private slots:
    void what_was_mended_takes_the_place_of_what_was_found() {
        const Extraction found = photo({face_at(100, 100, 400)});
        const auto mended = corrected(found, sheet_with({box_contour("left_eye", {350, 230}, 60)}));
        QVERIFY(mended.ok());
        const Face& face = mended->faces.front();
        QVERIFY(start_of_contour(face, "left_eye") == Vec2(350, 230));
        QVERIFY(start_of_contour(face, "outer_lip") == start_of_contour(found.faces.front(), "outer_lip"));
        QCOMPARE(face.mended, std::vector<std::string>{"left_eye"});
        QVERIFY(!face.problem.empty()); // nobody has looked at the lips
    }

    void a_face_mended_whole_is_beyond_doubt() {
        const auto mended = corrected(
            photo({face_at(100, 100, 400)}),
            sheet_with({box_contour("left_eye", {350, 230}, 60), box_contour("outer_lip", {240, 380}, 90)}));
        QVERIFY(mended->faces.front().problem.empty() && mended->problem.empty());
    }

    void faces_are_matched_by_place_whatever_their_order() {
        const Extraction before = photo({face_at(50, 100, 300), face_at(550, 150, 280)});
        ContourSheet sheet = sheet_of(before);
        for (Contour& contour : sheet.contours)
            for (Piece& piece : contour.pieces)
                std::get<Line>(piece).a += Vec2(3.0, 0.0), std::get<Line>(piece).b += Vec2(3.0, 0.0);
        const Extraction other_order = photo({face_at(552, 148, 310), face_at(48, 98, 290)});
        const auto mended = corrected(other_order, sheet);
        QVERIFY(mended.ok());
        QCOMPARE(mended->faces.size(), std::size_t(2));
        QVERIFY(std::abs(start_of_contour(mended->faces[0], "left_eye").x - (550 + 0.6 * 280 + 3)) < 1e-9);
        QVERIFY(std::abs(start_of_contour(mended->faces[1], "left_eye").x - (50 + 0.6 * 300 + 3)) < 1e-9);
    }

    void what_a_person_took_away_is_gone() {
        Extraction found = photo({face_at(100, 100, 400)});
        found.faces.front().quality = {{1.0, {}}, {2.0, {}}};
        const Contour dot = contour_through(removed_name("left_eye"), {{360, 240}}, false);
        const auto read = sheet_from_svg(sheet_to_svg(sheet_with({dot})), ContourSheet::Unit::pixel);
        QVERIFY(read.ok());
        const auto mended = corrected(found, *read);
        const Face& face = mended->faces.front();
        QCOMPARE(face.contours.size(), std::size_t(1));
        QCOMPARE(face.contours.front().name, std::string("outer_lip"));
        QCOMPARE(face.quality.size(), std::size_t(1));
        QCOMPARE(face.quality.front().expected_error_percent, 2.0);
        QCOMPARE(face.mended, std::vector<std::string>{"left_eye"});
        QVERIFY(corrected(photo({}), *read)->faces.empty()); // nothing is left of a face that is not there
    }

    void a_face_that_only_a_person_saw_is_added() {
        const auto mended = corrected(photo({}), sheet_with({box_contour("outline", {200, 100}, 300)}));
        QCOMPARE(mended->faces.size(), std::size_t(1));
        QVERIFY(mended->problem.empty());
        const auto second = corrected(photo({face_at(50, 100, 300)}),
                                      sheet_with({box_contour("face 2 outline", {700, 100}, 100)}));
        QCOMPARE(second->faces.size(), std::size_t(2));
        QCOMPARE(second->faces[1].contours.front().name, std::string("outline"));
        QVERIFY(second->faces[0].mended.empty());
    }

    void a_scaled_photograph_keeps_its_corrections_and_another_shape_is_refused() {
        const auto half = corrected(photo({face_at(100, 100, 400)}),
                                    sheet_with({box_contour("left_eye", {175, 115}, 30)}, 500, 400));
        QVERIFY(start_of_contour(half->faces.front(), "left_eye") == Vec2(350, 230));
        const auto other = corrected(photo({face_at(100, 100, 400)}),
                                     sheet_with({box_contour("left_eye", {1, 1}, 3)}, 800, 1000));
        QVERIFY(other.error().find("800 × 1000") != std::string::npos);
    }

    void extraction_and_sheet_and_back_is_the_same() {
        const Extraction found = photo({face_at(50, 100, 300), face_at(550, 150, 280)});
        const auto same = corrected(found, sheet_of(found));
        for (std::size_t i = 0; i < 2; ++i)
            for (const Contour& contour : found.faces[i].contours)
                QVERIFY(start_of_contour(same->faces[i], contour.name) == start_of(contour.pieces.front()));
    }

    void files_beside_the_photograph_are_read_and_bad_ones_said() {
        const QTemporaryDir folder;
        const std::filesystem::path picture = folder.filePath("IMG 1.jpg").toStdString();
        const Extraction found = photo({face_at(100, 100, 400)});
        QVERIFY(with_corrections(found, picture).faces.front().mended.empty());

        QVERIFY(write_sheet(correction_file(picture), sheet_with({box_contour("left_eye", {350, 230}, 60)}))
                    .ok());
        QVERIFY(start_of_contour(with_corrections(found, picture).faces.front(), "left_eye") ==
                Vec2(350, 230));

        QFile broken(folder.filePath("IMG 1.jpg.contours.svg"));
        QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("<svg") == 4);
        broken.close();
        const Extraction kept = with_corrections(found, picture);
        QVERIFY(kept.faces.front().mended.empty());
        QVERIFY(kept.problem.find("IMG 1.jpg.contours.svg") != std::string::npos &&
                kept.problem.ends_with('.'));
    }
};

} // namespace corrections_test

TP_TEST(corrections_test, CorrectionsTest, nothing)
#include "corrections_test.moc"
