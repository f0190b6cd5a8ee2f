// SPDX-License-Identifier: Apache-2.0
#include "places.hpp"

#include <QColor>
#include <QImage>
#include <QProcess>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

namespace {

struct Run {
    int code = -1;
    QString output;
};

Run run(const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(tp::test::in_build("bin/touchphoto"), arguments);
    process.waitForFinished(120000);
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAll())};
}

int count_near(const QImage& picture, QColor colour) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor there = picture.pixelColor(x, y);
            const int away = std::abs(there.red() - colour.red()) + std::abs(there.green() - colour.green()) +
                             std::abs(there.blue() - colour.blue());
            count += away < 12 ? 1 : 0;
        }
    return count;
}

} // namespace

class ProgramTest : public QObject {
    Q_OBJECT
private slots:
    void it_takes_a_picture_of_a_finger_at_an_eye() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("page.png");
        const Run done = run({"--screenshot", file, tp::test::in_source("resources/samples/anna_smiling.jpg")});
        QVERIFY2(done.code == 0, qPrintable(done.output));
        const QImage picture(file);
        QVERIFY(picture.width() >= 800);
        QSet<QRgb> colours;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                colours << picture.pixel(x, y);
        QVERIFY(colours.size() > 2000);                        // a photograph
        QVERIFY(count_near(picture, QColor("#ff9eb0")) > 100); // the finger
        QVERIFY(count_near(picture, QColor("#8fdcff")) > 500); // the lines
    }
    void a_picture_without_a_photograph_that_can_be_read_is_taken_too() {
        const QTemporaryDir folder;
        const Run done = run({"--screenshot", folder.filePath("page.png"), "/nowhere/face.jpg"});
        QVERIFY2(done.code == 0, qPrintable(done.output));
        QVERIFY(!QImage(folder.filePath("page.png")).isNull());
    }
    void a_picture_that_cannot_be_written_is_an_error() {
        const Run done = run({"--screenshot", "/nowhere/at/all.png"});
        QCOMPARE(done.code, 1);
        QVERIFY(done.output.contains("/nowhere/at/all.png"));
    }
    void help_and_version() {
        QVERIFY(run({"--help"}).output.contains("--screenshot"));
        QVERIFY(run({"--version"}).output.contains("touchphoto 0."));
    }
    void a_wrong_option_says_so() {
        QVERIFY(run({"--voice", "perhaps"}).code == 2);
        QVERIFY(run({"--louder"}).code != 0);
    }
};

QTEST_GUILESS_MAIN(ProgramTest)
#include "program_test.moc"
