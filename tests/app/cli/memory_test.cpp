// SPDX-License-Identifier: Apache-2.0
// How much memory touchphoto-lab takes for the largest photographs of today's cameras.
#include "lab_process.hpp"
#include "places.hpp"

#include <QSize>
#include <QTemporaryDir>
#include <QTest>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace {

constexpr double most_bytes = 250e6; ///< of a program that looks at 50 megapixel
constexpr double most_bytes_with_a_face = 90e6;

/// The largest resident set so far of a program that runs, bytes; 0 where the system does not tell.
double peak_bytes(qint64 program) {
    QFile status(QStringLiteral("/proc/%1/status").arg(program));
    if (!status.open(QIODevice::ReadOnly))
        return 0.0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmHWM:"))
            return 1024.0 * line.mid(6).chopped(2).trimmed().toDouble();
    return 0.0;
}

/// Runs touchphoto-lab; the largest that it became, bytes.
double peak_of(QProcess& process, const QStringList& words) {
    process.start(tp::test::in_build("bin/touchphoto-lab"), words);
    double most = 0.0;
    while (process.state() != QProcess::NotRunning) {
        most = std::max(most, peak_bytes(process.processId()));
        process.waitForFinished(10);
    }
    return most;
}

/// Noise in which there is no face, or a drawn portrait.
void write_photograph(const QString& file, QSize size, bool has_face) {
    cv::Mat small(size.height() / 10, size.width() / 10, CV_8UC3), large;
    if (has_face)
        small = cv::imread(tp::test::in_source("resources/samples/anna_smiling.jpg"));
    else
        cv::RNG(7).fill(small, cv::RNG::UNIFORM, 0, 255);
    cv::resize(small, large, {size.width(), size.height()}, 0, 0, cv::INTER_CUBIC);
    if (!cv::imwrite(file.toStdString(), large))
        qFatal("cannot write %s", qPrintable(file));
}

} // namespace

class MemoryTest : public QObject {
    Q_OBJECT
private slots:
    void fifty_megapixel_take_no_more_than_they_may_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("has_face");
        QTest::newRow("3:2, no face") << QSize(8660, 5773) << false;
        QTest::newRow("4:3, no face") << QSize(8160, 6120) << false;
        QTest::newRow("a face as large as the picture") << QSize(6396, 7817) << true;
    }
    /// A face as large as that is seen in a sixteenth of the pixels; without one every look is taken, and those at the
    /// turned picture.
    void fifty_megapixel_take_no_more_than_they_may() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("a sanitizer takes memory of its own");
#endif
        QFETCH(QSize, size);
        QFETCH(bool, has_face);
        const QTemporaryDir folder;
        const QString file = folder.filePath("large.jpg");
        write_photograph(file, size, has_face);
        QProcess process;
        const double most = peak_of(process, {"faces", file});
        QCOMPARE(process.exitCode(), has_face ? 0 : 1);
        QVERIFY(process.readAllStandardOutput().contains(has_face ? "1 face" : "0 faces"));
        qInfo("%.1f MB", most / 1e6);
        const double read = 3.0 * size.width() * size.height() / (has_face ? 16.0 : 1.0);
        QVERIFY(most > read); // the picture itself was seen in it
        QVERIFY2(most <= (has_face ? most_bytes_with_a_face : most_bytes), qPrintable(QString::number(most)));
    }

    void two_gigabytes_that_are_no_picture_are_not_read() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("a sanitizer takes memory of its own");
#endif
        const QTemporaryDir folder;
        const QString file = folder.filePath("zeros.jpg");
        QVERIFY(QFile(file).open(QIODevice::WriteOnly) &&
                QFile::resize(file, (qint64{2} << 30) - 1)); // sparse
        QProcess process;
        const double most = peak_of(process, {"faces", file});
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(process.readAllStandardError().contains("is not a picture of a kind that can be read."));
        QVERIFY2(most <= most_bytes_with_a_face, qPrintable(QString::number(most)));
    }
};

QTEST_GUILESS_MAIN(MemoryTest)
#include "memory_test.moc"
