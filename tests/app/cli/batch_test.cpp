// SPDX-License-Identifier: Apache-2.0
// Archives through touchphoto-lab faces: many photographs, stopped anywhere and gone on with.
#include "app/cli/results_file.hpp"
#include "lab_process.hpp"
#include "places.hpp"

#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using namespace tp;

namespace {

/// What a line says, without how long it took.
QJsonObject told(const QByteArray& line) {
    QJsonObject object = QJsonDocument::fromJson(line).object();
    object.remove("milliseconds");
    return object;
}

QList<QJsonObject> told_lines(const QByteArray& lines) {
    QList<QJsonObject> list;
    for (const QByteArray& line : lines.split('\n'))
        if (!line.isEmpty())
            list.append(told(line));
    return list;
}

QByteArray bytes_of(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class BatchTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QStringList photos_; ///< portraits, and in between two files that are none
    QByteArray whole_;   ///< the lines of an uninterrupted run

    QString path(const QString& name) const { return folder_.filePath(name); }
    void put(const QString& name, const QByteArray& bytes) const {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    QStringList batch(const QString& results, const QStringList& options = {}) const {
        return QStringList{"faces", "--json", "--resume", path(results)} + options + photos_;
    }
    /// A batch whose third photograph is done, and many of whose are not.
    void start(QProcess& process, const QString& results) const {
        process.start(tp::test::in_build("bin/touchphoto-lab"), batch(results, {"--jobs", "2"}));
        QByteArray err;
        while (!err.contains("\n3 of ")) {
            QVERIFY2(process.waitForReadyRead(240'000) || process.bytesAvailable() > 0, err.constData());
            err += process.readAllStandardOutput();
        }
    }
    void goes_on(const QString& results, qsizetype held) const {
        const Run run = lab(batch(results, {"--jobs", "0"}));
        QVERIFY2(run.err.contains(QStringLiteral("Skipped %1 photograph").arg(held).toUtf8()),
                 run.err.constData());
        QCOMPARE(run.out, QByteArray());
        QCOMPARE(told_lines(bytes_of(path(results))), told_lines(whole_));
    }

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        QImage portrait(QString(tp::test::in_source("resources/samples/anna_smiling.jpg")));
        QVERIFY(!portrait.isNull());
        for (int i = 0; i < 10; ++i) {
            if (i == 1)
                photos_ << path("missing.jpg");
            if (i == 5) {
                put("letter.jpg", "Dear Anna, here is the picture.");
                photos_ << path("letter.jpg");
            }
            const QString photo = path(QStringLiteral("%1.jpg").arg(i));
            QVERIFY(portrait.scaledToHeight(260 + 22 * i, Qt::SmoothTransformation).save(photo));
            photos_ << photo;
        }
        const Run run = lab(QStringList{"faces", "--json"} + photos_);
        QCOMPARE(run.code, 1);
        whole_ = run.out;
        const QList<QJsonObject> lines = told_lines(whole_);
        QCOMPARE(lines.size(), photos_.size());
        for (qsizetype i = 0; i < photos_.size(); ++i) {
            QCOMPARE(lines[i]["photo"].toString(), photos_[i]);
            const bool is_portrait = i != 1 && i != 6;
            QCOMPARE(lines[i]["faces"].toArray().size(), is_portrait ? 1 : 0);
            QCOMPARE(lines[i]["problem"].isNull(), is_portrait);
        }
    }

    void any_number_of_jobs_gives_the_same_lines_in_the_same_order() {
        for (const char* jobs : {"3", "0", "100"}) {
            const Run run = lab(QStringList{"faces", "--json", "--jobs", jobs} + photos_);
            QCOMPARE(run.code, 1);
            QCOMPARE(told_lines(run.out), told_lines(whole_));
            QVERIFY(run.err.contains("12 of 12: " + photos_.last().toUtf8()));
        }
    }

    void goes_on_after_a_cut_line() {
        const qsizetype third = whole_.indexOf('\n', whole_.indexOf('\n') + 1) + 1;
        for (const qsizetype cut : {qsizetype(1), third - 1, third + 500, whole_.size() - 1}) {
            put("cut.jsonl", whole_.left(cut));
            const qsizetype held = whole_.left(cut).count('\n');
            if (held > 0)
                goes_on("cut.jsonl", held);
            else {
                QVERIFY(!lab(batch("cut.jsonl")).err.contains("Skipped"));
                QCOMPARE(told_lines(bytes_of(path("cut.jsonl"))), told_lines(whole_));
            }
        }
    }

    void goes_on_after_it_was_killed() {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        start(process, "killed.jsonl");
        process.kill();
        QVERIFY(process.waitForFinished());
        const qsizetype held = bytes_of(path("killed.jsonl")).count('\n');
        QVERIFY2(held >= 2 && held < photos_.size(), qPrintable(QString::number(held)));
        goes_on("killed.jsonl", held);
    }

    void ctrl_c_ends_in_good_order_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("Ctrl-C") << SIGINT;
        QTest::newRow("terminated") << SIGTERM;
    }
    void ctrl_c_ends_in_good_order() {
        QFETCH(int, signal);
        QFile::remove(path("stopped.jsonl"));
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        start(process, "stopped.jsonl");
        ::kill(static_cast<pid_t>(process.processId()), signal);
        const Run run = ended(process);
        QCOMPARE(run.code, 128 + signal);
        const QByteArray lines = bytes_of(path("stopped.jsonl"));
        QVERIFY(lines.endsWith('\n'));
        const qsizetype held = lines.count('\n');
        const QByteArray says = QStringLiteral("Stopped after %1 of 12. The same command").arg(held).toUtf8();
        QVERIFY2(run.out.contains(says), run.out.constData());
        goes_on("stopped.jsonl", held);
    }

    void what_is_done_is_not_touched_again() {
        put("done.jsonl", whole_);
        const Run run = lab(batch("done.jsonl"));
        QCOMPARE(run.code, 0);
        QVERIFY(run.err.startsWith("Skipped 12 photographs") && is_one_sentence(run.err));
        QCOMPARE(bytes_of(path("done.jsonl")), whole_);
    }

    void a_photograph_named_twice_has_one_line() {
        const Run run = lab({"faces", "--json", "--resume", path("twice.jsonl"), photos_[0], photos_[0]});
        QCOMPARE(run.code, 0);
        QCOMPARE(bytes_of(path("twice.jsonl")).count('\n'), 1);
    }

    void names_in_folders_do_not_depend_on_what_is_skipped() {
        QVERIFY(QDir(folder_.path()).mkpath("other"));
        QVERIFY(QFile::copy(photos_[0], path("other/0.jpg")));
        const QStringList words{"faces", "--json",         "--resume", path("named.jsonl"),
                                "--svg", path("contours"), photos_[0], path("other/0.jpg")};
        QCOMPARE(lab(words).code, 0);
        const QByteArray lines = bytes_of(path("named.jsonl"));
        put("named.jsonl", lines.left(lines.indexOf('\n') + 1));
        QVERIFY(QFile::remove(path("contours/0.jpg-2.contours.svg")));
        QCOMPARE(lab(words).code, 0);
        QVERIFY(QFile::exists(path("contours/0.jpg-2.contours.svg")));
    }

    void a_full_disk_ends_in_a_sentence_and_costs_nothing() {
        QProcess process;
        // Files of this shell's children end at 32 KiB, and writing beyond is an error instead of a signal.
        process.start("bash", QStringList{"-c", "trap '' XFSZ; ulimit -f 32; exec \"$@\"", "bash",
                                          tp::test::in_build("bin/touchphoto-lab")} +
                                  batch("full.jsonl"));
        const Run run = ended(process);
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("The results cannot be written"), run.err.constData());
        const qsizetype held = bytes_of(path("full.jsonl")).count('\n');
        QVERIFY(held > 0 && held < photos_.size());
        goes_on("full.jsonl", held);
    }

    void a_file_that_is_not_for_results_stays_as_it_was() {
        const QByteArray before = bytes_of(photos_[0]);
        const Run run = lab({"faces", "--json", "--resume", photos_[0], photos_[2]});
        QCOMPARE(run.code, 1);
        QVERIFY2(is_one_sentence(run.err), run.err.constData());
        QCOMPARE(bytes_of(photos_[0]), before);
        const auto other_batch = ResultsFile::open(path("theirs.jsonl").toStdString());
        QVERIFY(other_batch.ok());
        const Run second = lab(batch("theirs.jsonl"));
        QCOMPARE(second.code, 1);
        QVERIFY2(second.err.startsWith("Another batch"), second.err.constData());
        QCOMPARE(bytes_of(path("theirs.jsonl")), QByteArray());
    }

    void wrong_usage_is_said_data() {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("results of what?") << QStringList{"--resume", "x.jsonl"};
        for (const char* jobs : {"-1", "1.5", "many", "257", ""})
            QTest::addRow("%s jobs", jobs) << QStringList{"--jobs", jobs};
    }
    void wrong_usage_is_said() {
        QFETCH(QStringList, options);
        const Run run = lab(QStringList{"faces"} + options + QStringList{photos_[0]});
        QCOMPARE(run.code, 2);
        QVERIFY(run.out.isEmpty() && run.err.contains("faces --help"));
    }
};

QTEST_GUILESS_MAIN(BatchTest)
#include "batch_test.moc"
