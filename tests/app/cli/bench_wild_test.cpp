// SPDX-License-Identifier: Apache-2.0
// touchphoto-lab bench faces --wild: photographs without truth, as a shell sees it.
#include "lab_process.hpp"
#include "places.hpp"

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

namespace {

QString sample(const char* name) { return QString(tp::test::in_source("resources/samples/")) + "/" + name; }

} // namespace

class BenchWildTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }
    /// Words that measure what `where` names into `out`.
    QStringList wild(const QString& where, const QString& out, const QStringList& more = {}) const {
        return QStringList{"bench", "faces", "--wild", where, "--out", path(out)} + more;
    }

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        QVERIFY(QDir(folder_.path()).mkpath("family/1999"));
        QVERIFY(QFile::copy(sample("anna_smiling.jpg"), path("family/1999/anna.jpg")));
        QVERIFY(QFile::copy(sample("ben_angry.jpg"), path("family/ben.JPG")));
        written(path("family/letter.txt"), "not a photograph");
        written(path("family/torn.jpg"), "not a photograph either");
        QImage flat(160, 120, QImage::Format_RGB32);
        flat.fill(Qt::darkGreen);
        QVERIFY(flat.save(path("family/meadow.png")));
    }

    void a_folder_is_measured_and_what_cannot_be_read_is_named() {
        const Run run = lab(wild(path("family"), "out"));
        QCOMPARE(run.code, 1); // for torn.jpg
        QVERIFY2(run.out.contains("photographs: 4\ncould not be read: 1:\n  torn.jpg\n"
                                  "no face found by ours: 1:\n  meadow.png\n"),
                 run.out.constData());
        QVERIFY2(run.out.contains("faces: 2 by ours, 2 by the mesh, 2 by both"), run.out.constData());
        QVERIFY(run.out.contains("detection to contours") && !run.out.contains("labels"));
        QVERIFY2(run.err.contains("torn.jpg: ") && run.err.contains("1 of 4: 1999/anna.jpg"),
                 run.err.constData());
        for (const char* name : {"wild.csv", "wild_summary.csv", "wild.png", "wild.svg", "worst.png"})
            QVERIFY2(QFile::exists(path("out") + "/" + name), name);
    }

    void only_those_named_beside_their_labels() {
        const QString names = written(path("names"), "# two\nmeadow.png\nanna.jpg\nnobody.jpg\n");
        const QString labels = written(path("labels"), "# seen\nanna.jpg laughing\nmeadow.png no_face\n");
        const Run run = lab(wild(path("family"), "labelled", {"--only", names, "--labels", labels}));
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY(run.err.startsWith("1 of the 3 names in "));
        QVERIFY(run.out.startsWith("photographs: 2\n") && run.out.contains("no face found by ours: 0\n"));
        QVERIFY2(
            run.out.contains("the largest face of each labelled photograph, 1 in all; said falsely in 0"),
            run.out.constData());
        QVERIFY(run.out.contains(
            "labelled as without a face of 40 px, not counted above: 1; a face found in 0\n"));
    }

    void a_single_photograph_will_do() {
        const Run run = lab(wild(sample("anna_smiling.jpg"), "one"));
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY(run.out.startsWith("photographs: 1\n"));
        QCOMPARE(run.err, QByteArray("1 of 1: anna_smiling.jpg\n"));
    }

    void what_cannot_be_used_is_one_sentence_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QByteArray>("says");
        QVERIFY(QDir(folder_.path()).mkpath("bare/.hidden"));
        QVERIFY(QFile::copy(sample("anna_smiling.jpg"), path("bare/.hidden/anna.jpg")));
        const QString family = path("family");
        QTest::newRow("no such folder") << wild(path("nowhere"), "x") << QByteArray("There is no folder ");
        QTest::newRow("no photograph") << wild(path("bare"), "x") << QByteArray("There is no photograph in ");
        QTest::newRow("no list") << wild(family, "x", {"--only", path("nowhere")})
                                 << QByteArray("The list of photographs cannot be read: ");
        QTest::newRow("a list without an end") << wild(family, "x", {"--only", "/dev/zero"})
                                               << QByteArray("The list of photographs cannot be read: ");
        QTest::newRow("none of the list") << wild(family, "x", {"--only", written(path("others"), "x.jpg\n")})
                                          << QByteArray("None of the photographs in ");
        QTest::newRow("no labels") << wild(family, "x", {"--labels", path("nowhere")})
                                   << QByteArray("There is no file ");
        QTest::newRow("a label that is not known")
            << wild(family, "x", {"--labels", written(path("wrong"), "anna.jpg laughs\n")})
            << QByteArray("Line 1 of the labels has the word \"laughs\"");
        QTest::newRow("no place for results")
            << wild(family, "family/letter.txt/out") << QByteArray("The folder ");
    }
    void what_cannot_be_used_is_one_sentence() {
        QFETCH(QStringList, words);
        QFETCH(QByteArray, says);
        const Run run = lab(words);
        QCOMPARE(run.code, 1);
        QVERIFY2(is_one_sentence(run.err) && run.err.startsWith(says), run.err.constData());
        QVERIFY(run.out.isEmpty() && !QFile::exists(path("x")));
    }

    void options_that_do_not_go_together_are_wrong_usage() {
        const QString family = path("family");
        QCOMPARE(lab({"bench", "faces", "--wild", family}).code, 2);
        QCOMPARE(lab(wild(family, "x", {"--photos", family})).code, 2);
        QCOMPARE(lab(wild(family, "x", {"--harder"})).code, 2);
        QCOMPARE(lab({"bench", "faces", "--photos", family, "--truth", "t.json", "--out", path("x"), "--only",
                      "o"})
                     .code,
                 2);
        QCOMPARE(lab(wild(family, "x", {"loose word"})).code, 2);
        QVERIFY(!QFile::exists(path("x")));
        QVERIFY(lab({"bench", "faces", "--help"}).out.contains("--wild <DIR>"));
    }

    void an_interrupted_run_keeps_what_it_measured() {
        QVERIFY(QDir(folder_.path()).mkpath("many"));
        for (int i = 0; i < 200; ++i)
            QVERIFY(QFile::link(sample("anna_smiling.jpg"), path("many/%1.jpg").arg(i, 3, 10, QChar('0'))));
        QProcess process;
        process.setReadChannel(QProcess::StandardError);
        process.start(tp::test::in_build("bin/touchphoto-lab"), wild(path("many"), "stopped"));
        QByteArray err;
        while (!err.contains("3 of 200") && process.waitForReadyRead(60'000))
            err += process.readAllStandardError();
        QVERIFY2(err.contains("3 of 200") && process.processId() > 0, err.constData());
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        const Run run = ended(process);
        QCOMPARE(run.code, 130);
        QVERIFY2(run.err.contains(" of 200; the figures are of these.\n"), run.err.constData());
        QFile table(path("stopped/wild.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const auto done = table.readAll().count('\n') - 1;
        QVERIFY2(done >= 3 && done < 200 &&
                     run.out.startsWith("photographs: " + QByteArray::number(done) + '\n') &&
                     run.err.contains("Stopped after " + QByteArray::number(done) + " of 200; "),
                 run.out.constData());
        for (const char* name : {"wild_summary.csv", "wild.png", "wild.svg"})
            QVERIFY2(QFile::exists(path("stopped") + "/" + name), name);
    }
};

QTEST_GUILESS_MAIN(BenchWildTest)
#include "bench_wild_test.moc"
