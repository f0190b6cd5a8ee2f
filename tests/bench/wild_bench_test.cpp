// SPDX-License-Identifier: Apache-2.0
// Photographs without truth: what is found, compared, counted and drawn. No time is asserted.
#include "app/figures/bench/wild_bench.hpp"
#include "places.hpp"

#include <QColor>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace tp;

namespace {

/// A face whose eyes are 100 px apart from outer corner to outer corner, in a box of 200 px: each contour is
/// a line, which lies `off` px below its place (the outline, which is upright, to the right).
Face line_face(Vec2 place, double off = 0.0) {
    const auto level = [&](const char* name, double from, double to, double y) {
        return contour_through(name, {place + Vec2(from, y), place + Vec2(to, y)}, false);
    };
    Face face;
    face.box = {place - Vec2(50.0, 60.0), place + Vec2(150.0, 140.0)};
    face.contours = {
        level(feature::right_eye, 0.0, 20.0, 0.0), level(feature::left_eye, 80.0, 100.0, 0.0),
        level(feature::outer_lip, 30.0, 70.0, 80.0 + off), level(feature::inner_lip, 35.0, 65.0, 80.0),
        contour_through(feature::outline, {place + Vec2(off, 0.0), place + Vec2(off, 120.0)}, false)};
    face.quality.resize(face.contours.size());
    return face;
}

Extraction extraction(std::vector<Face> faces) {
    Extraction found;
    found.width = found.height = 1000;
    found.faces = std::move(faces);
    return found;
}

/// A photograph as run_wild_bench makes it.
WildPhoto photo(const std::string& name, const Extraction& ours, const Extraction& mesh) {
    WildPhoto photo = compared(ours, mesh);
    photo.name = name;
    photo.file = "/folder/" + name;
    return photo;
}

Extraction covered(std::size_t contour, const char* reason = "may be covered") {
    Face face = line_face({300.0, 300.0});
    face.quality[contour].reasons = {"turned to the side", reason};
    face.problem = "The face is only 31 pixels wide.";
    return extraction({face});
}

bool nearly(const std::optional<double>& value, double expected) {
    return value && std::abs(*value - expected) < 1e-6;
}

QByteArray bytes_of(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool shows(const QImage& image, const QColor& colour) {
    for (int y = 120; y < image.height(); ++y) // below the legend
        for (int x = 0; x < image.width(); ++x)
            if (image.pixelColor(x, y) == colour)
                return true;
    return false;
}

} // namespace

class WildBenchTest : public QObject {
    Q_OBJECT
private slots:
    void labels_are_a_name_and_words() {
        const auto labels = WildLabels::from_text("# a comment\n"
                                                  "a.jpg\n"
                                                  "  summer 1999.at sea.jpg  left_eye_covered\tglasses\r\n"
                                                  "\n"
                                                  "b.jpg no_face");
        QVERIFY2(labels.ok(), labels.error().c_str());
        QVERIFY(labels->of("/any/folder/a.jpg") && labels->of("a.jpg")->empty());
        QVERIFY(labels->says("summer 1999.at sea.jpg", "left_eye_covered"));
        QVERIFY(labels->says("summer 1999.at sea.jpg", "glasses"));
        QVERIFY(!labels->says("summer 1999.at sea.jpg", "no_face") && labels->says("b.jpg", "no_face"));
        QVERIFY(!labels->of("c.jpg") && !labels->says("c.jpg", "no_face"));
        QCOMPARE(WildLabels::from_text("a.jpg\nb.jpg left_eye_coverd\n").error(),
                 std::string("Line 2 of the labels has the word \"left_eye_coverd\", which is not known."));
        QCOMPARE(WildLabels::from_text("glasses\n").error(),
                 std::string("Line 1 of the labels does not begin with a file's name."));
        QCOMPARE(WildLabels::from_text("a.jpg\na.jpg hat\n").error(),
                 std::string("Line 2 of the labels is the second one about a.jpg."));
    }

    void the_labels_of_the_project_can_be_read() {
        QFile file(tp::test::in_source("tests/faces/wild_labels.txt"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto labels = WildLabels::from_text(file.readAll().toStdString());
        QVERIFY2(labels.ok(), labels.error().c_str());
        QVERIFY(labels->of("staff_fa481ded.jpg"));
    }

    void the_largest_face_is_compared_with_the_one_at_its_place() {
        const Face elsewhere = line_face({700.0, 100.0});
        const WildPhoto same = compared(extraction({line_face({300.0, 300.0}, 3.0), elsewhere}),
                                        extraction({elsewhere, line_face({300.0, 300.0})}));
        QVERIFY(same.was_read() && same.face && same.mesh_face);
        QCOMPARE(same.faces, 2);
        QCOMPARE(same.common_faces, 2);
        QVERIFY(nearly(same.off_percent[0], 0.0) && nearly(same.off_percent[1], 0.0));
        QVERIFY(nearly(same.off_percent[2], 3.0) && nearly(same.off_percent[3], 0.0));
        QVERIFY(nearly(same.off_percent[4], 3.0));
        QCOMPARE(same.worst_percent(), *same.off_percent[4]);
    }

    void faces_of_both_are_the_same_within_two_fifths_of_their_size() {
        for (const double apart : {79.0, 81.0}) { // of 200 px
            const WildPhoto one = compared(extraction({line_face({300.0, 300.0})}),
                                           extraction({line_face({300.0, 300.0 - apart})}));
            QCOMPARE(one.mesh_face.has_value(), apart < 80.0);
            QCOMPARE(one.off_percent[4].has_value(), apart < 80.0);
            QCOMPARE(one.common_faces, apart < 80.0 ? 1 : 0);
        }
    }

    void a_face_of_the_mesh_is_one_of_ours_only_once() {
        const WildPhoto doubled = compared(extraction({line_face({300.0, 300.0}), line_face({304.0, 300.0})}),
                                           extraction({line_face({300.0, 300.0})}));
        QCOMPARE(doubled.faces, 2);
        QCOMPARE(doubled.common_faces, 1);
    }

    void places_in_pictures_turned_differently_are_not_compared() {
        Extraction turned = extraction({line_face({300.0, 300.0})});
        turned.turned_degrees = 90;
        const WildPhoto one = compared(turned, extraction({line_face({300.0, 300.0})}));
        QVERIFY(one.face && !one.mesh_face && !one.off_percent[0]);
        QCOMPARE(one.turned_degrees, 90);
        const WildPhoto other = compared(extraction({}), turned);
        QVERIFY(!other.face && other.mesh_face);
        QCOMPARE(other.turned_degrees, 90);
    }

    void a_set_is_summed_up() {
        const Extraction nobody = extraction({}), somebody = extraction({line_face({300.0, 300.0})});
        Extraction unreadable;
        unreadable.problem = "The file is empty.";
        std::vector<WildPhoto> photos{photo("none.jpg", nobody, nobody),
                                      photo("missed.jpg", nobody, somebody),
                                      photo("apart.jpg", somebody, extraction({line_face({600.0, 300.0})})),
                                      photo("bad.jpg", unreadable, {}),
                                      photo("eye.jpg", covered(1), somebody),
                                      photo("faint.jpg", covered(2, "its edge is faint"), somebody)};
        for (const double off : {1.0, 2.0, 7.5})
            photos.push_back(photo("off.jpg", extraction({line_face({300.0, 300.0}, off)}), somebody));
        for (std::size_t i = 0; i < photos.size(); ++i)
            photos[i].milliseconds = {1.0 * static_cast<double>(i), 10.0, 20.0, 3.0, 0.5};

        const WildSummary all = summary_of(photos, nullptr);
        QCOMPARE(all.photos, 9);
        QCOMPARE(all.read(), 8);
        QCOMPARE(all.unread, std::vector<std::string>{"bad.jpg"});
        QCOMPARE(all.not_found, (std::vector<std::string>{"none.jpg", "missed.jpg"}));
        QCOMPARE(all.not_found_by_mesh, std::vector<std::string>{"none.jpg"});
        QCOMPARE(all.apart, std::vector<std::string>{"apart.jpg"});
        QCOMPARE(all.faces, 6);
        QCOMPARE(all.largest_faces, 6);
        QCOMPARE(all.mesh_faces, 7);
        QCOMPARE(all.common_faces, 5);
        QCOMPARE(all.agreement[0].contours, 10); // two eyes a face
        const WildAgreement& outer = all.agreement[1];
        QCOMPARE(outer.contours, 5);
        QVERIFY(nearly(outer.mean_percent, 10.5 / 5.0));
        QCOMPARE(outer.much_off, 1);
        QVERIFY(outer.p95_percent > 2.0 && outer.p95_percent <= 7.5);
        QVERIFY(std::is_sorted(outer.off_percent.begin(), outer.off_percent.end()));
        QCOMPARE(all.agreement[2].much_off, 0);
        QCOMPARE(all.agreement[3].much_off, 1);
        QCOMPARE(all.reasons.at("may be covered"), (std::array{0, 1, 0, 0, 0}));
        QCOMPARE(all.reasons.at("its edge is faint"), (std::array{0, 0, 1, 0, 0}));
        QCOMPARE(all.reasons.at("turned to the side"), (std::array{0, 1, 1, 0, 0}));
        QCOMPARE(all.sentences.size(), std::size_t(1));
        QCOMPARE(all.sentences.at("The face is only N pixels wide.").largest, 2);
        QVERIFY(nearly(all.rest_ms, 33.5));
        QVERIFY(all.decode_ms < all.decode_p95_ms);
        QVERIFY(!all.covers);
    }

    void what_is_said_stands_beside_the_labels() {
        const Extraction somebody = extraction({line_face({300.0, 300.0})});
        const std::vector<WildPhoto> photos{
            photo("false.jpg", covered(0), somebody),  photo("mouth.jpg", covered(3), somebody),
            photo("true.jpg", covered(1), somebody),   photo("unsaid.jpg", somebody, somebody),
            photo("empty.jpg", covered(0), somebody),  photo("nobody.jpg", extraction({}), extraction({})),
            photo("unknown.jpg", covered(0), somebody)};
        const auto labels = WildLabels::from_text("false.jpg\nmouth.jpg glasses\ntrue.jpg left_eye_covered\n"
                                                  "unsaid.jpg left_eye_covered\nempty.jpg no_face\n"
                                                  "nobody.jpg\n");
        QVERIFY(labels.ok());
        const WildSummary all = summary_of(photos, &*labels);
        QVERIFY(all.covers);
        const WildCovers& covers = *all.covers;
        QCOMPARE(covers.photos, 4);
        QCOMPARE(covers.clear_eyes.all, 6);
        QCOMPARE(covers.clear_eyes.said, 1);
        QCOMPARE(covers.clear_mouths.all, 4);
        QCOMPARE(covers.clear_mouths.said, 1);
        QCOMPARE(covers.covered_eyes.all, 2);
        QCOMPARE(covers.covered_eyes.said, 1);
        QCOMPARE(covers.covered_mouths.all, 0);
        QCOMPARE(covers.photos_falsely, 2);
        QCOMPARE(covers.falsely, (std::vector<std::string>{"false.jpg: right eye", "mouth.jpg: mouth"}));
        QCOMPARE(covers.without_face.all, 1);
        QCOMPARE(covers.without_face.said, 1);
        QCOMPARE(covers.unlabelled, 1);
        QCOMPARE(all.reasons.at("may be covered"), (std::array{2, 1, 0, 1, 0})); // empty.jpg counts apart
        QCOMPARE(all.not_found, std::vector<std::string>{"nobody.jpg"});
        QCOMPARE(all.agreement[3].contours, 5);
    }

    void the_worst_are_those_not_found_then_those_far_off() {
        const Extraction nobody = extraction({}), somebody = extraction({line_face({300.0, 300.0})});
        std::vector<WildPhoto> photos{
            photo("landscape.jpg", nobody, nobody),
            photo("near.jpg", extraction({line_face({300.0, 300.0}, 1.0)}), somebody),
            photo("apart.jpg", somebody, extraction({line_face({600.0, 300.0})})),
            photo("far.jpg", extraction({line_face({300.0, 300.0}, 9.0)}), somebody),
            photo("missed.jpg", nobody, somebody)};
        using Order = std::vector<std::size_t>;
        QCOMPARE(worst_of(photos, nullptr, 20), (Order{4, 2, 0, 3, 1}));
        QCOMPARE(worst_of(photos, nullptr, 4), (Order{4, 2, 3, 1})); // half of the room each
        QCOMPARE(worst_of(photos, nullptr, 0), Order{});
        const auto labels = WildLabels::from_text("landscape.jpg no_face\n");
        QCOMPARE(worst_of(photos, &*labels, 20), (Order{4, 2, 3, 1}));
        photos.resize(1);
        QCOMPARE(worst_of(photos, nullptr, 20), Order{0});
        photos[0].problem = "The file is empty.";
        QCOMPARE(worst_of(photos, nullptr, 20), Order{});
    }

    void a_line_a_photograph_says_all_of_it() {
        const Extraction somebody = extraction({line_face({300.0, 300.0})});
        const auto labels = WildLabels::from_text("eye, shut.jpg hat left_eye_covered\n");
        QVERIFY(labels.ok());
        WildPhoto eye = photo("eye, shut.jpg", covered(1), somebody);
        eye.off_percent[2] = 0.25;
        eye.milliseconds = {1.5, 2.0, 3.0, 4.0, 5.0};
        const QTemporaryDir results;
        const std::filesystem::path out = results.path().toStdString();
        QVERIFY(write_wild_table(out, {eye, photo("none.jpg", extraction({}), somebody)}, &*labels).ok());
        QCOMPARE(
            bytes_of(results.filePath("wild.csv")),
            QByteArray(
                "photo,problem,faces,mesh_faces,common_faces,face_px,right_eye_off_percent,"
                "left_eye_off_percent,outer_lip_off_percent,inner_lip_off_percent,outline_off_percent,said,"
                "right_eye_reasons,left_eye_reasons,outer_lip_reasons,inner_lip_reasons,outline_reasons,"
                "decode_ms,detect_ms,landmarks_ms,edges_ms,contours_ms,labels\n"
                "\"eye, shut.jpg\",,1,1,1,200,0,0,0.25,0,0,The face is only 31 pixels wide.,"
                ",turned to the side; may be covered,,,,1.5,2,3,4,5,hat left_eye_covered\n"
                "none.jpg,,0,1,0,,,,,,,,,,,,,0,0,0,0,0,\n"));

        QVERIFY(plot_wild(out, summary_of({eye, photo("far.jpg", extraction({line_face({300.0, 300.0}, 8.0)}),
                                                      somebody)},
                                          nullptr))
                    .ok());
        const QByteArray plot = bytes_of(results.filePath("wild.svg"));
        QVERIFY(plot.contains(">2 photographs: ") && plot.contains(">eyes: 0 of 4 over 5 %<") &&
                plot.contains(">outer lip: 1 of 2 over 5 %<"));
    }

    void photographs_are_measured_and_shown() {
        const QTemporaryDir folder;
        const std::filesystem::path place = folder.path().toStdString();
        QVERIFY(QDir(folder.path()).mkpath("2019"));
        QVERIFY(QFile::copy(tp::test::in_source("resources/samples/anna_smiling.jpg"),
                            folder.filePath("2019/anna.jpg")));
        QVERIFY(QFile::copy(tp::test::in_source("resources/samples/ben_and_clara.jpg"),
                            folder.filePath("both.jpg")));
        QFile damaged(folder.filePath("damaged.jpg"));
        QVERIFY(damaged.open(QIODevice::WriteOnly) && damaged.write("no picture") > 0);
        damaged.close();
        QImage noise(200, 160, QImage::Format_RGB32);
        QRandomGenerator random(7);
        for (int y = 0; y < noise.height(); ++y)
            for (int x = 0; x < noise.width(); ++x)
                noise.setPixel(x, y, random.generate() | 0xff000000U);
        QVERIFY(noise.save(folder.filePath("noise.png")));
        const std::vector<std::filesystem::path> files{place / "2019/anna.jpg", place / "both.jpg",
                                                       place / "damaged.jpg", place / "noise.png"};
        std::vector<WildPhoto> photos;
        QCOMPARE(run_wild_bench(files, place, [&](WildPhoto one) { photos.push_back(std::move(one)); }),
                 std::string());
        QCOMPARE(photos.size(), std::size_t(4));
        for (std::size_t i = 0; i < files.size(); ++i)
            QVERIFY(photos[i].file == files[i]);
        QCOMPARE(photos[0].name, std::string("2019/anna.jpg"));
        for (std::size_t i = 0; i < 2; ++i) {
            const WildPhoto& one = photos[i];
            QVERIFY(one.face && one.mesh_face);
            QCOMPARE(one.faces, i == 0 ? 1 : 2);
            QCOMPARE(one.common_faces, one.faces);
            QVERIFY(one.worst_percent() > 0.0 && one.worst_percent() < 15.0); // drawn, not photographed
            QVERIFY(one.milliseconds.landmarks > 0.0 && one.milliseconds.edges > 0.0);
        }
        QVERIFY(photos[2].problem.ends_with('.') && !photos[2].was_read());
        QVERIFY(photos[3].was_read() && !photos[3].face && photos[3].faces == 0);

        const WildSummary summary = summary_of(photos, nullptr);
        const QTemporaryDir results;
        const std::filesystem::path out = results.path().toStdString();
        QVERIFY(write_wild_table(out, photos, nullptr).ok() && write_wild_summary(out, summary).ok());
        QVERIFY(plot_wild(out, summary).ok());
        const QList<QByteArray> lines = bytes_of(results.filePath("wild.csv")).trimmed().split('\n');
        QCOMPARE(lines.size(), qsizetype(5));
        QVERIFY(lines[2].startsWith("both.jpg,,2,2,2,"));
        const QByteArray figures = bytes_of(results.filePath("wild_summary.csv"));
        QVERIFY(figures.contains("\nno face found,ours,1,photographs\n") &&
                figures.contains("\nfaces,both,3,faces\n"));
        QVERIFY(!QImage(results.filePath("wild.png")).isNull() &&
                QFile::exists(results.filePath("wild.svg")));

        QVERIFY(write_wild_sheet(out, photos, worst_of(photos, nullptr, 20)).ok());
        const QImage sheet(results.filePath("worst.png"));
        QVERIFY(sheet.width() > 3 * 320 && sheet.width() < 4 * 360); // three tiles in a row
        QVERIFY(shows(sheet, QColor(255, 222, 40)) && shows(sheet, QColor(0, 200, 255)));
        QVERIFY(write_wild_sheet(out, photos, {3}).ok()); // without a face: no contour
        const QImage empty(results.filePath("worst.png"));
        QVERIFY(!shows(empty, QColor(255, 222, 40)) && !shows(empty, QColor(0, 200, 255)));
        QVERIFY(!write_wild_table("/no/such/folder", photos, nullptr).ok());
        QVERIFY(!write_wild_sheet("/no/such/folder", photos, {}).ok());
    }

    void nothing_is_a_set_too() {
        const QTemporaryDir results;
        const std::filesystem::path out = results.path().toStdString();
        const WildSummary summary = summary_of({}, nullptr);
        QCOMPARE(summary.read(), 0);
        QVERIFY(std::isnan(summary.agreement[0].mean_percent));
        QVERIFY(write_wild_table(out, {}, nullptr).ok() && write_wild_summary(out, summary).ok());
        QVERIFY(plot_wild(out, summary).ok() && write_wild_sheet(out, {}, {}).ok());
    }
};

QTEST_MAIN(WildBenchTest)
#include "wild_bench_test.moc"
