// SPDX-License-Identifier: Apache-2.0
// Every verb that can take more than two seconds, at work on something large: it says how far it is, and
// Ctrl-C ends it with nothing half-written.
#include "lab_process.hpp"
#include "places.hpp"

#include <QDir>
#include <QDirIterator>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <random>
#include <set>
#include <unistd.h>

namespace {

/// An answer takes a fraction of a second; so long is waited for it, however busy the machine is.
constexpr int longest_answer_ms = 30'000;
constexpr int longest_silence_ms = 120'000;

/// Long lines through each other, which no index likes.
QByteArray tangle() {
    std::mt19937 random(1);
    const auto place = [&random](unsigned below) {
        return QByteArray::number(0.1 * static_cast<double>(random() % (10 * below)));
    };
    QByteArray path = "M 0 0";
    for (int i = 0; i < 100'000; ++i)
        path += " L " + place(260) + ' ' + place(160);
    return "<svg xmlns='http://www.w3.org/2000/svg' width='260mm' height='160mm' viewBox='0 0 260 160'><path "
           "id='tangle' d='" +
           path + "'/></svg>";
}

/// Noise of many megapixels, in which a face is looked for long.
void write_large_photograph(const QString& file) {
    QImage picture(14'000, 12'500, QImage::Format_Grayscale8);
    std::mt19937 random(7);
    QByteArray row(picture.width(), '\0');
    for (int y = 0; y < picture.height(); ++y) {
        if (y % 10 == 0)
            for (qsizetype x = 0; x < row.size(); ++x)
                row[x] = x % 10 == 0 ? static_cast<char>(random()) : row[x - 1];
        std::copy(row.begin(), row.end(), picture.scanLine(y));
    }
    if (!picture.save(file, "jpg", 80))
        qFatal("cannot write %s", qPrintable(file));
}

/// Two gigabytes of silence, most of which take no place on the disk.
void write_long_sound(const QString& file) {
    constexpr quint32 bytes = 2'000'000'000;
    const auto number = [](quint32 value) {
        return QByteArray(reinterpret_cast<const char*>(&value), 4); // of a machine that WAV was made for
    };
    written(file, "RIFF" + number(36 + bytes) + "WAVEfmt " + number(16) + QByteArray("\1\0\1\0", 4) +
                      number(48'000) + number(96'000) + QByteArray("\2\0\20\0", 4) + "data" + number(bytes));
    QFile(file).resize(44 + qint64{bytes});
}

} // namespace

class LongWorkTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }
    std::set<QString> files() const {
        std::set<QString> found;
        for (QDirIterator all(folder_.path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
             all.hasNext();)
            found.insert(QDir(folder_.path()).relativeFilePath(all.next()));
        return found;
    }

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        written(path("tangle.svg"), tangle());
        write_large_photograph(path("large.jpg"));
        write_long_sound(path("long.wav"));
        const QString portrait = tp::test::in_source("resources/samples/anna_smiling.jpg");
        QVERIFY(QFile::copy(portrait, path("one.jpg")));
        QVERIFY(QDir().mkpath(path("album")) && QDir().mkpath(path("empty")) && QDir().mkpath(path("heavy")));
        for (int i = 0; i < 200; ++i) // gigabytes that take no place on the disk
            QCOMPARE(::link(qPrintable(path("large.jpg")),
                            qPrintable(path(QStringLiteral("heavy/%1.jpg").arg(i)))),
                     0);
        for (int i = 0; i < 8'000; ++i)
            QCOMPARE(
                ::link(qPrintable(path("one.jpg")), qPrintable(path(QStringLiteral("album/%1.jpg").arg(i)))),
                0);
        QCOMPARE(lab({"devices", "record", path("short.rec"), "--seconds", "0.1"}).code, 0);
    }

    void ctrl_c_ends_it_with_nothing_half_written_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QString>("leaves"); ///< what it may leave, whole
        const auto row = [this](const char* name, const char* words, const char* leaves = "") {
            QStringList list = QString(words).split(' ');
            for (QString& word : list)
                if (word.startsWith('@'))
                    word = path(word.mid(1));
            QTest::newRow(name) << list << leaves;
        };
        const char* const index = "cache/.*";
        row("field", "field --scene @tangle.svg --out @field.png");
        row("friction", "friction --scene @tangle.svg --out @friction.png");
        row("force", "force --scene @tangle.svg");
        row("trace", "trace --scene @tangle.svg --out @trace");
        row("devices record a scene", "devices record @tangle.rec --scene @tangle.svg");
        row("devices record", "devices record @long.rec --seconds 1000", "long.rec");
        row("devices replay", "devices replay @short.rec --scene @tangle.svg");
        row("devices test", "devices test simulated --seconds 1000");
        row("servo", "servo --seconds 1000");
        row("aim", "aim simulate --people 100000 --out @aim");
        row("stability", "stability --out @stability");
        row("bench guidance", "bench guidance --json @bench.json");
        row("bench accuracy", "bench accuracy --out @accuracy");
        row("bench touch", "bench touch --people 10000 --out @touch");
        row("bench faces --wild", "bench faces --wild @album --out @wild", "wild/[a-z_]+[.](csv|png|svg)");
        row("scene", "scene @large.jpg --out @scene.svg");
        row("tactile", "tactile @large.jpg @tactile.pdf");
        row("correction", "correction @large.jpg --out @correction.png");
        row("expressions", "expressions @large.jpg --out @expressions");
        row("faces", "faces @large.jpg --json --svg @svg --overlay @overlay");
        row("models fetch", "models fetch mesh --yes --from @long.wav");
        row("album scan", "album scan @album --cache @cache/scan", index);
        row("album rebuild", "album rebuild @album --cache @cache/rebuild", index);
        row("album list", "album list @album --cache @cache/list", index);
        row("album search", "album search @album Anna --cache @cache/search", index);
        row("album person list", "album person list @album --cache @cache/people", index);
        row("album person rename", "album person rename @album Anna Tom --cache @cache/rename", index);
        row("album person record", "album person record @empty Anna --from @long.wav");
        row("album tag add", "album tag add @one.jpg --from @long.wav");
        row("album check", "album check @album");
        row("album export", "album export @heavy --to @all.touchphoto");
        row("album import", "album import @empty @album --cache @cache/import",
            "cache/.*|empty/[0-9]+[.]jpg|empty/[.]touchphoto/import/[^/]+");
    }

    void ctrl_c_ends_it_with_nothing_half_written() {
        QFETCH(QStringList, words);
        QFETCH(QString, leaves);
        const std::set<QString> before = files();
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("TOUCHPHOTO_MODELS", path("models"));
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral(TP_LAB), words);
        QByteArray told;
        process.setReadChannel(QProcess::StandardError);
        while (!told.contains('\n') && process.waitForReadyRead(longest_silence_ms))
            told += process.readAllStandardError();
        QVERIFY2(process.state() == QProcess::Running, told.constData());
        QVERIFY2(told.contains('\n'), "it said nothing");

        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(longest_answer_ms));
        told += process.readAllStandardError();
        QVERIFY2(process.exitStatus() == QProcess::NormalExit, told.constData());
        QVERIFY2(process.exitCode() == 130, told.constData());
        const QRegularExpression whole(QRegularExpression::anchoredPattern(leaves));
        for (const QString& file : files())
            QVERIFY2(before.contains(file) || whole.match(file).hasMatch(), qPrintable(file));
    }

    void a_recording_that_was_stopped_is_whole() {
        const Run replayed = lab({"devices", "replay", path("long.rec")});
        QCOMPARE(replayed.code, 0);
        QCOMPARE(replayed.err, QByteArray());
    }
};

QTEST_GUILESS_MAIN(LongWorkTest)
#include "long_work_test.moc"
