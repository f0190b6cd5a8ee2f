// SPDX-License-Identifier: Apache-2.0
// touchphoto-lab as a shell sees it.
#include "core/files/file_words.hpp"
#include "core/guidance/exact_law.hpp"
#include "core/svg/contour_sheet.hpp"
#include "lab_process.hpp"
#include "places.hpp"

#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace tp;

namespace {

const QString sample = QString(tp::test::in_source("resources/samples/anna_smiling.jpg"));
const QString two_people = QString(tp::test::in_source("resources/samples/ben_and_clara.jpg"));

} // namespace

class LabTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }

    QString write(const QString& name, const QByteArray& bytes) const { return written(path(name), bytes); }

    QString scene() const {
        return write(
            "scene.svg",
            "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60'>"
            "<path id='line' d='M 10 30 L 90 30'/><circle id='ring' cx='50' cy='30' r='20'/></svg>");
    }

    QString hostile_scene() const {
        return write(
            "hostile.svg",
            "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60'>"
            "<path id='l&#x9b;31m&#x202e;x' d='M 10 30 L 90 30'/>"
            "<path id='m&#x9b;&#x2066;' d='M 10 33 L 90 33'/></svg>");
    }

private slots:
    void initTestCase() { QVERIFY(folder_.isValid()); }

    /// A name that clears the screen, colours it in another way, turns the direction of writing and ends the line.
    static QString hostile_name() {
        return QString::fromUtf8("a\x1b[2Jb\xc2\x9b"
                                 "31mc\xe2\x80\xae"
                                 "d\xe2\x81\xa6.jpg");
    }
    static bool obeys_nobody(const QByteArray& shown) {
        for (const QChar unit : QString::fromUtf8(shown))
            if (unit != '\n' && unit != '\t' && tp::is_unwelcome(unit.unicode()))
                return false;
        return true;
    }

    void what_strangers_wrote_does_not_reach_the_terminal_data() {
        QTest::addColumn<QStringList>("words");
        const QString name = path(hostile_name());
        QTest::newRow("verb") << QStringList{hostile_name()};
        QTest::newRow("option") << QStringList{"faces", "--" + hostile_name()};
        QTest::newRow("too many") << QStringList{"field", "--scene", scene(), hostile_name()};
        QTest::newRow("faces") << QStringList{"faces", name};
        QTest::newRow("faces as JSON") << QStringList{"faces", "--json", name};
        QTest::newRow("expressions") << QStringList{"expressions", name};
        QTest::newRow("expressions as JSON") << QStringList{"expressions", "--json", name};
        QTest::newRow("correction") << QStringList{"correction", name};
        QTest::newRow("scene") << QStringList{"scene", name, "--out", path("hostile.svg")};
        QTest::newRow("scene, written")
            << QStringList{"scene", sample, "--out", path("none/" + hostile_name())};
        QTest::newRow("tactile") << QStringList{"tactile", name, path("hostile.pdf")};
        QTest::newRow("tactile, written") << QStringList{"tactile", sample, path("none/" + hostile_name())};
        for (const char* verb : {"field", "friction", "force", "trace"})
            QTest::newRow(verb) << QStringList{verb, "--scene", path("none/" + hostile_name()), "--out",
                                               path("o.png")};
        QTest::newRow("force") << QStringList{"force", "--scene", hostile_scene()};
        for (const char* verb : {"show", "list", "check", "scan"})
            QTest::newRow(qPrintable(QString("album ") + verb)) << QStringList{"album", verb, name};
        QTest::newRow("a verb of the album") << QStringList{"album", hostile_name()};
        QTest::newRow("an import") << QStringList{"album", "import", folder_.filePath("hostile"), name};
        QTest::newRow("a study") << QStringList{"study", "check", name};
        QTest::newRow("an experiment") << QStringList{"study", "plan", hostile_name(), "--participant", "1"};
        QTest::newRow("a device") << QStringList{"devices", "test", hostile_name()};
        QTest::newRow("a detector") << QStringList{"faces", "--detector", hostile_name(), sample};
        QTest::newRow("a model") << QStringList{"faces", "--model", hostile_name(), sample};
    }
    void what_strangers_wrote_does_not_reach_the_terminal() {
        QFETCH(QStringList, words);
        QVERIFY(QDir(folder_.path()).mkpath("hostile"));
        if (!QFile::exists(path(hostile_name())))
            QVERIFY(QFile::copy(sample, path(hostile_name())));
        const Run run = lab(words, "1 2\n");
        QVERIFY2(obeys_nobody(run.out), run.out.toPercentEncoding());
        QVERIFY2(obeys_nobody(run.err), run.err.toPercentEncoding());
    }

    void nothing_of_a_hostile_name_is_lost_in_json() {
        if (!QFile::exists(path(hostile_name())))
            QVERIFY(QFile::copy(sample, path(hostile_name())));
        const Run run = lab({"faces", "--json", path(hostile_name())});
        QCOMPARE(run.code, 0);
        QCOMPARE(QJsonDocument::fromJson(run.out).object()["photo"].toString(), path(hostile_name()));
    }

    void usage_is_code_2_with_a_sentence_data() {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("nothing") << QStringList{};
        QTest::newRow("no such verb") << QStringList{"fly"};
        QTest::newRow("no such option") << QStringList{"faces", "--wings", "a.jpg"};
        QTest::newRow("no photograph") << QStringList{"faces"};
        QTest::newRow("no scene") << QStringList{"force"};
        QTest::newRow("no such law") << QStringList{"force", "--scene", "a.svg", "--law", "magnetic"};
        QTest::newRow("no number") << QStringList{"force", "--scene", "a.svg", "--stiffness", "soft"};
        QTest::newRow("below zero") << QStringList{"force", "--scene", "a.svg", "--range", "-4"};
        QTest::newRow("blended by nothing") << QStringList{"force", "--scene", "a.svg", "--blend", "0"};
        QTest::newRow("no output") << QStringList{"scene", "a.jpg"};
        QTest::newRow("two photographs") << QStringList{"scene", "a.jpg", "b.jpg", "--out", "c.svg"};
        QTest::newRow("no folder") << QStringList{"trace", "--scene", "a.svg"};
        QTest::newRow("surface of nothing")
            << QStringList{"scene", "a.jpg", "--out", "c.svg", "--width", "10"};
        QTest::newRow("surface of a kilometre")
            << QStringList{"scene", "a.jpg", "--out", "c.svg", "--height", "1e6"};
        QTest::newRow("face zero") << QStringList{"scene", "a.jpg", "--out", "c.svg", "--face", "0"};
    }
    void usage_is_code_2_with_a_sentence() {
        QFETCH(QStringList, words);
        const Run run = lab(words);
        QCOMPARE(run.code, 2);
        QVERIFY(run.out.isEmpty());
        QVERIFY(!run.err.isEmpty());
    }

    void input_without_an_end_of_line_is_not_kept() {
        const Run run = lab({"force", "--scene", scene()}, "1 2\n" + QByteArray(1 << 20, '1'));
        QCOMPARE(run.code, 1);
        QCOMPARE(run.out.count('\n'), 1);
        QCOMPARE(run.err, QByteArray("Line 2 of the input is longer than two numbers can be.\n"));
    }

    void help_is_there_for_every_verb_data() {
        QTest::addColumn<QString>("verb");
        for (const char* verb : {"expressions", "faces", "scene", "force", "field", "trace"})
            QTest::newRow(verb) << verb;
    }
    void help_is_there_for_every_verb() {
        QFETCH(QString, verb);
        const Run run = lab({verb, "--help"});
        QCOMPARE(run.code, 0);
        QVERIFY(run.out.startsWith("Usage: touchphoto-lab " + verb.toUtf8()));
        QVERIFY(run.err.isEmpty());
        QVERIFY(lab({"--help"}).out.contains(verb.toUtf8()));
    }

    void faces_as_json() {
        const Run run = lab({"faces", "--json", sample, two_people});
        QCOMPARE(run.code, 0);
        const QList<QByteArray> lines = run.out.trimmed().split('\n');
        QCOMPARE(lines.size(), 2);
        QVERIFY(run.err.contains("1 of 2"));
        const QJsonObject one = QJsonDocument::fromJson(lines[0]).object();
        QCOMPARE(one["photo"].toString(), sample);
        QCOMPARE(one["width"].toInt(), 900);
        QCOMPARE(one["height"].toInt(), 1100);
        QVERIFY(one["problem"].isNull());
        for (const char* step : {"decode", "detect", "landmarks", "edges", "contours"})
            QVERIFY(one["milliseconds"][step].isDouble());
        QCOMPARE(one["faces"].toArray().size(), 1);
        const QJsonObject face = one["faces"].toArray()[0].toObject();
        QCOMPARE(face["box"].toArray().size(), 4);
        QVERIFY(face["score"].toDouble() > 0.3 && face["score"].toDouble() <= 1.0);
        for (const char* name : {"left_eye", "right_eye", "outer_lip", "inner_lip", "outline"}) {
            const QJsonArray points = face["contours"][name].toArray();
            QVERIFY(points.size() >= 30);
            QVERIFY(points.first() != points.last());
            const QJsonObject quality = face["quality"][name].toObject();
            const double expected = quality["expected_error_percent"].toDouble();
            QVERIFY2(expected > 0.1 && expected < 3.0, name);
            QVERIFY2(quality["reasons"].isArray() && quality["reasons"].toArray().isEmpty(), name);
        }
        for (const char* name : {"left_brow", "right_brow", "nose", "left_iris", "right_iris"})
            QVERIFY2(face["extras"][name].toArray().size() >= 12, name);
        QCOMPARE(QJsonDocument::fromJson(lines[1])["faces"].toArray().size(), 2);
    }

    void eyes_are_wide_enough_for_a_finger_data() {
        QTest::addColumn<QString>("photo");
        for (const char* photo : {"anna_smiling.jpg", "ben_angry.jpg", "clara_sad.jpg"})
            QTest::newRow(photo) << photo;
    }
    void eyes_are_wide_enough_for_a_finger() {
        QFETCH(QString, photo);
        const QString file = path("eyes.svg");
        QCOMPARE(lab({"scene", tp::test::in_source("resources/samples/") + photo, "--out", file}).code, 0);
        const auto sheet = read_sheet(file.toStdString(), ContourSheet::Unit::millimetre);
        for (const Contour& contour : sheet->contours)
            if (contour.name == "left_eye" || contour.name == "right_eye") {
                const double width = bounds_of(flatten(contour).points).width();
                QVERIFY2(width >= 25.0, qPrintable(QString::number(width)));
            }
    }

    void narrow_eyes_are_said_with_the_spacing() {
        const QString file = path("narrow.svg");
        const Run wide = lab({"scene", sample, "--out", file, "--spacing"});
        QVERIFY2(!wide.err.contains("finger wants"), wide.err.constData());
        const Run narrow =
            lab({"scene", sample, "--out", file, "--spacing", "--width", "90", "--height", "70"});
        QCOMPARE(narrow.code, 0);
        QVERIFY2(narrow.err.contains(" mm wide here, and a finger wants 25 mm"), narrow.err.constData());
        QVERIFY(!lab({"scene", sample, "--out", file, "--width", "90", "--height", "70"})
                     .err.contains("finger wants"));
    }

    void features_are_added_where_they_are_asked_for() {
        const QString file = path("with_nose.svg");
        QCOMPARE(lab({"scene", sample, "--out", file, "--with", "nose,brows"}).code, 0);
        const auto sheet = read_sheet(file.toStdString(), ContourSheet::Unit::millimetre);
        QVERIFY(sheet.ok());
        QCOMPARE(sheet->contours.size(), std::size_t(8));
        QCOMPARE(sheet->contours[7].name, std::string("nose"));
        const QString out = path("with_irises");
        QCOMPARE(lab({"faces", "--svg", out, "--with", "irises", sample}).code, 0);
        QCOMPARE(read_sheet((out + "/anna_smiling.jpg.contours.svg").toStdString(), ContourSheet::Unit::pixel)
                     ->contours.size(),
                 std::size_t(7));
        for (const char* verb : {"faces", "scene"}) {
            const Run wrong = lab({verb, sample, "--out", file, "--with", "ears"});
            QCOMPARE(wrong.code, 2);
            QVERIFY(!wrong.err.isEmpty());
        }
    }

    void one_bad_photograph_does_not_cost_the_others() {
        const QString text = write("letter.jpg", "Dear Anna, here is the picture.");
        const Run run = lab({"faces", "--json", path("missing.jpg"), sample, text, folder_.path()});
        QCOMPARE(run.code, 1);
        const QList<QByteArray> lines = run.out.trimmed().split('\n');
        QCOMPARE(lines.size(), 4);
        QCOMPARE(QJsonDocument::fromJson(lines[1])["faces"].toArray().size(), 1);
        for (const int bad : {0, 2, 3}) {
            const QJsonObject line = QJsonDocument::fromJson(lines[bad]).object();
            QVERIFY(line["problem"].toString().endsWith('.'));
            QCOMPARE(line["faces"].toArray().size(), 0);
        }
        for (const QString& photo : {path("missing.jpg"), text, folder_.path()})
            QVERIFY(run.err.contains(photo.toUtf8() + ": "));
    }

    void bad_photographs_end_in_one_sentence_data() {
        QTest::addColumn<QString>("photo");
        QFile file(sample);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray whole = file.readAll();
        QTest::newRow("missing") << path("nowhere.jpg");
        QTest::newRow("folder") << folder_.path();
        QTest::newRow("empty") << write("empty.jpg", "");
        QTest::newRow("text") << write("text.jpg", "This is not a picture at all.");
        QTest::newRow("truncated") << write("truncated.jpg", whole.left(whole.size() / 2));
        QTest::newRow("only a header") << write("header.jpg", whole.left(200));
        QImage small(40, 30, QImage::Format_RGB32);
        small.fill(Qt::blue);
        QVERIFY(small.save(path("cut.bmp")));
        QFile bitmap(path("cut.bmp"));
        QVERIFY(bitmap.open(QIODevice::ReadWrite) && bitmap.resize(bitmap.size() / 2));
        QTest::newRow("half a bitmap") << path("cut.bmp");
        QImage dot(1, 1, QImage::Format_RGB32);
        dot.fill(Qt::red);
        QVERIFY(dot.save(path("dot.png")));
        QTest::newRow("one pixel") << path("dot.png");
        QImage plain(640, 480, QImage::Format_RGB32);
        plain.fill(Qt::gray);
        QVERIFY(plain.save(path("plain.png")));
        QTest::newRow("no face") << path("plain.png");
    }
    void bad_photographs_end_in_one_sentence() {
        QFETCH(QString, photo);
        for (const QStringList& words : {QStringList{"faces", "--json", photo},
                                         QStringList{"scene", photo, "--out", path("none.svg")}}) {
            const Run run = lab(words);
            QCOMPARE(run.code, 1);
            QVERIFY2(is_one_sentence(run.err), run.err.constData());
        }
        QVERIFY(!QFile::exists(path("none.svg")));
    }

    void contours_and_overlay_are_written_for_each_photograph() {
        const QString out = path("results");
        const Run run = lab({"faces", "--svg", out, "--overlay", out, sample, two_people});
        QCOMPARE(run.code, 0);
        const auto sheet =
            read_sheet((out + "/ben_and_clara.jpg.contours.svg").toStdString(), ContourSheet::Unit::pixel);
        QVERIFY(sheet.ok());
        QCOMPARE(sheet->contours.size(), std::size_t(10));
        QCOMPARE(sheet->width, 900.0);
        QCOMPARE(QImage(out + "/anna_smiling.jpg.overlay.png").size(), QSize(900, 1100));
    }

    void force_answers_each_line() {
        const Run run = lab({"force", "--scene", scene()}, "-40 2\n0,\t0\n\n0 -22\r\n0 200\n");
        QCOMPARE(run.err, QByteArray());
        QCOMPARE(run.code, 0);
        const QList<QByteArray> lines = run.out.trimmed().split('\n');
        QCOMPARE(lines.size(), 4);
        QCOMPARE(lines[0], QByteArray("0 -0.4 2 line"));
        QCOMPARE(lines[1], QByteArray("0 0 0 line"));
        const QList<QByteArray> ring = lines[2].split(' ');
        QCOMPARE(ring[3], QByteArray("ring"));
        QVERIFY(std::abs(ring[1].toDouble() - 0.4) < 0.003);
        QVERIFY(std::abs(ring[2].toDouble() - 2.0) < 0.011);
        QVERIFY(lines[3].startsWith("0 0 180"));
    }

    void force_obeys_law_and_parameters() {
        QCOMPARE(
            lab({"force", "--scene", scene(), "--stiffness", "0.5", "--range", "2"}, "-40 1\n-40 3\n-40 5")
                .out,
            QByteArray("0 -0.5 1 line\n0 -0.5 3 line\n0 0 5 line\n"));
        QVERIFY(lab({"force", "--scene", scene(), "--law", "published"}, "-39 2\n").code == 0);
        const Run softened =
            lab({"force", "--scene", scene(), "--blend", "0.5", "--corner-cue"}, "-40 2\n0 10\n0 9.9\n");
        QCOMPARE(softened.code, 0);
        const QList<QByteArray> lines = softened.out.trimmed().split('\n');
        QVERIFY(std::abs(lines[0].split(' ')[1].toDouble() + 0.4) < 1e-9); // beside a line nothing changes
        // Half-way between line and ring, 10 mm from both, there is no force for either to lose.
        QCOMPARE(lines[1].split(' ')[0], QByteArray("0"));
    }

    void two_answers_to_one_jump_are_refused() {
        const Run both =
            lab({"trace", "--scene", scene(), "--out", path("both"), "--hold", "0.4", "--blend", "0.4"});
        QCOMPARE(both.code, 1);
        QVERIFY(both.err.contains("choose one"));
        QCOMPARE(
            lab({"field", "--scene", scene(), "--out", path("f.png"), "--law", "published", "--corner-cue"})
                .code,
            1);
        const Run held = lab({"trace", "--scene", scene(), "--out", path("held"), "--hold", "0.4",
                              "--corner-cue", "--seconds", "5"});
        QVERIFY2(held.code == 0, held.err.constData());
    }

    void measuring_needs_to_know_what_and_where() {
        QCOMPARE(lab({"bench"}).code, 2);
        QCOMPARE(lab({"bench", "patience"}).code, 2);
        QCOMPARE(lab({"bench", "accuracy"}).code, 2);
        QCOMPARE(lab({"bench", "accuracy", "--out", sample + "/folder"}).code, 1);
        QCOMPARE(lab({"bench", "faces", "--photos", folder_.path()}).code, 2);
        const Run no_truth = lab({"bench", "faces", "--photos", folder_.path(), "--truth", path("none.json"),
                                  "--out", path("faces")});
        QCOMPARE(no_truth.code, 1);
        QVERIFY2(is_one_sentence(no_truth.err), no_truth.err.constData());
        QVERIFY(lab({"bench", "--help"}).out.contains("bench accuracy --out DIR"));
    }

    void force_says_which_line_it_cannot_read() {
        QCOMPARE(lab({"force", "--scene", scene()}, "1 +-2\n").code, 1);
        const Run run = lab({"force", "--scene", scene()}, "1 2\n3 four\n5 6\n");
        QCOMPARE(run.code, 1);
        QVERIFY(run.err.contains("Line 2"));
        QCOMPARE(run.out.count('\n'), 1);
        QCOMPARE(lab({"force", "--scene", path("none.svg")}, "1 2\n").code, 1);
        QCOMPARE(lab({"force", "--scene", write("bad.svg", "<svg")}, "1 2\n").code, 1);
        QVERIFY(is_one_sentence(lab({"force", "--scene", write("bad.svg", "<svg")}, "1 2\n").err));
    }

    void scene_fits_the_surface_and_field_and_trace_use_it() {
        const QString file = path("anna.svg");
        QCOMPARE(lab({"scene", sample, "--out", file, "--width", "120", "--height", "160"}).code, 0);
        const auto sheet = read_sheet(file.toStdString());
        QVERIFY(sheet.ok());
        QCOMPARE(sheet->width, 120.0);
        QCOMPARE(sheet->height, 160.0);
        QCOMPARE(sheet->contours.size(), std::size_t(5));
        const Scene anna = scene_from_sheet(*sheet);
        for (const Polyline& line : flatten(anna).lines)
            for (const Vec2 p : line.points)
                QVERIFY(anna.surface().contains(p));

        QCOMPARE(lab({"field", "--scene", file, "--out", path("field.png")}).code, 0);
        QCOMPARE(QImage(path("field.png")).width(), 600);

        QCOMPARE(lab({"trace", "--scene", file, "--out", path("traced"), "--seconds", "20"}).code, 0);
        QFile csv(path("traced/trace.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QList<QByteArray> rows = csv.readAll().trimmed().split('\n');
        QCOMPARE(rows[0], QByteArray("t,x,y,fx,fy,distance,contour"));
        QVERIFY(rows.size() > 1900 && rows.size() < 2100);
        QVERIFY(!QImage(path("traced/trace.png")).isNull());

        // The force in the trace is the law's own, up to the damping of a slow finger.
        const ExactLaw law(flatten(anna), {});
        double worst = 0.0;
        for (qsizetype i = 200; i < rows.size(); ++i) { // after the gain has ramped up
            const QList<QByteArray> cells = rows[i].split(',');
            QCOMPARE(cells.size(), 7);
            const Vec2 finger(cells[1].toDouble(), cells[2].toDouble());
            worst = std::max(worst,
                             length(Vec2(cells[3].toDouble(), cells[4].toDouble()) - law.at(finger).force));
        }
        qInfo("largest difference between the trace and the law: %.3f N", worst);
        QVERIFY(worst < 0.45);
    }

    void a_file_of_another_s_is_written_over_by_force_alone() {
        const QString svg = scene();
        const auto draws = [&](const QString& file, bool force = false) {
            QStringList words{"field", "--scene", svg, "--out", file, "--scale", "1"};
            return lab(force ? words << "--force" : words);
        };
        const auto bytes = [](const QString& file) {
            QFile opened(file);
            return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
        };
        QVERIFY(QFile::copy(sample, path("taken.jpg")));
        QProcess exiftool; // as Capture writes it
        exiftool.start("exiftool", {"-q", "-overwrite_original", "-Software=TouchPhoto", path("taken.jpg")});
        QVERIFY(exiftool.waitForFinished(-1) && exiftool.exitCode() == 0);
        QVERIFY(QFile::copy(sample, path("other.png")));
        for (const QString& photo : {path("taken.jpg"), path("other.png")}) {
            const QByteArray before = bytes(photo);
            const Run run = draws(photo);
            QCOMPARE(run.code, 1);
            QVERIFY2(run.err.contains("--force"), run.err);
            QCOMPARE(bytes(photo), before);
            QCOMPARE(draws(photo, true).code, 0);
            QVERIFY(bytes(photo) != before);
            QCOMPARE(draws(photo).code, 0); // ours now
        }
        write("empty.png", {});
        QCOMPARE(draws(path("empty.png")).code, 0);
        for (const char* const sheet : {"sheet.svg", "sheet.pdf", "scene"})
            for (int i = 0; i < 2; ++i)
                QCOMPARE(lab(QString(sheet).startsWith("sheet")
                                 ? QStringList{"tactile", sample, path(sheet)}
                                 : QStringList{"scene", sample, "--out", path("made.svg")})
                             .code,
                         0);
        QVERIFY(QFile::copy(sample, path("mended.jpg")) &&
                QFile::copy(path("made.svg"), path("mended.jpg.contours.svg")));
        const Run refused = lab({"scene", sample, "--out", path("mended.jpg.contours.svg")});
        QCOMPARE(refused.code, 1);
        QVERIFY2(refused.err.contains("mended"), refused.err);
    }
};

QTEST_GUILESS_MAIN(LabTest)
#include "lab_test.moc"
