// SPDX-License-Identifier: Apache-2.0
// `touchphoto-lab study`: plans, checks, exports and reports, and what it refuses.
#include "core/experiment/experiment_file.hpp"
#include "core/files/whole_file.hpp"
#include "core/study_folder/path_file.hpp"
#include "core/study_folder/study_writer.hpp"
#include "lab_process.hpp"
#include "places.hpp"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <memory>
#include <string>
#include <vector>

namespace {

QString shipped(const char* name) {
    return QString::fromStdString(
        tp::test::in_source((std::string("resources/studies/") + name + ".study").c_str()));
}

void write(const QString& file, const QByteArray& bytes) {
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size());
}

} // namespace

class StudyVerbTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }

    /// Three people who have named shapes, as `plan` has planned it; radius 20 mm is hard. In training,
    /// whose lines are no answers, nobody was asked.
    void make_study(const QString& name) {
        QVERIFY(QDir(folder_.path()).mkpath(name));
        QVERIFY(QFile::copy(shipped("primitives"), path(name + "/protocol.study")));
        for (int participant = 1; participant <= 3; ++participant) {
            const Run plan =
                lab({"study", "plan", shipped("primitives"), "--participant", QString::number(participant)});
            QCOMPARE(plan.code, 0);
            QByteArray csv = "experiment,participant,trial,repetition,training,shape,radius,error_mm,time_s,"
                             "answer,correct,"
                             "repeated,seed\n";
            const QList<QByteArray> lines = plan.out.trimmed().split('\n');
            for (const QByteArray& line : lines.mid(1)) {
                const QList<QByteArray> cells =
                    line.split(','); // trial, repetition, training, shape, radius, seed
                const bool asked = cells[2] == "no";
                const bool hard = cells[4] == "20" && (cells[0].toInt() + participant) % 2 == 0;
                const QByteArray answer = !asked ? "" : hard ? "circle" : cells[3];
                csv += "primitives," + QByteArray::number(participant) + "," + cells[0] + "," + cells[1] +
                       "," + cells[2] + "," + cells[3] + "," + cells[4] + ",," +
                       QByteArray::number(8 + participant) + "." + cells[0] + "," + answer + "," +
                       (!asked               ? ""
                        : answer == cells[3] ? "yes"
                                             : "no") +
                       ",no," + cells[5] + "\n";
            }
            write(path(name + QString("/participant-00%1.csv").arg(participant)), csv);
        }
    }

    /// A study that a program of ours is running: one person has done 3 trials of it, with their paths.
    std::unique_ptr<tp::StudyWriter> run_study(const QString& name) {
        using namespace tp;
        const auto protocol = read_whole(shipped("primitives").toStdString(), most_experiment_bytes);
        auto writer = StudyWriter::open(path(name).toStdString(), read_experiment(*protocol).value(),
                                        {7, false}, {"2026-11-26", "touchphoto 0.1.0", "mouse", ""});
        if (!writer)
            qFatal("%s", writer.error().c_str());
        for (int i = 0; i < 3; ++i) {
            TrialRecord record = begun_record((*writer)->next(4).value(), 4);
            record.time_s = 2.0;
            std::vector<FingerSample> samples;
            for (int k = 0; k <= 200; ++k)
                samples.push_back({0.01 * k, 0.1 * k, 0.0, 0.5, 0.0});
            if (const std::string problem = (*writer)->keep(record, samples); !problem.empty())
                qFatal("%s", problem.c_str());
        }
        return std::move(writer).value();
    }

private slots:
    void initTestCase() { QVERIFY(folder_.isValid()); }

    void a_plan_has_every_trial_and_the_same_again() {
        const Run plan = lab({"study", "plan", shipped("tracking"), "--participant", "2", "--seed", "9"});
        QCOMPARE(plan.code, 0);
        QCOMPARE(plan.out.count('\n'), 1 + 3 + 150);
        QVERIFY(plan.out.startsWith("trial,repetition,training,stiffness,range,path,seed\n1,1,yes,"));
        QCOMPARE(lab({"study", "plan", shipped("tracking"), "--participant", "2", "--seed", "9"}).out,
                 plan.out);
        QVERIFY(lab({"study", "plan", shipped("tracking"), "--participant", "3", "--seed", "9"}).out !=
                plan.out);
    }
    void a_study_is_checked_and_reported() {
        make_study("one");
        const Run check = lab({"study", "check", path("one")});
        QCOMPARE(check.code, 1); // no fingers' paths are in it
        QVERIFY(check.out.startsWith("Participant 1: 45 trials of 45.\nParticipant 2:"));
        QVERIFY(check.out.contains("Participant 2: the finger's path is missing in these trials: 1–48.\n"));
        const Run run = lab({"study", "report", path("one"), "--out", path("out"), "--json"});
        QCOMPARE(run.err, QByteArray());
        QCOMPARE(run.code, 0);
        const QJsonObject report = QJsonDocument::fromJson(run.out).object();
        QCOMPARE(report["participants"].toInt(), 3);
        QCOMPARE(report["trials"].toInt(), 3 * 45);
        QCOMPARE(report["effects"].toArray().size(), 2 * 3);
        QVERIFY(report["effects"].toArray()[0].toObject()["f"].isDouble());
        double hard = 0.0, easy = 0.0;
        for (const QJsonValue& level : report["levels"].toArray())
            if (level["measure"] == "right" && level["factor"] == "radius")
                (level["level"] == "20 mm" ? hard : easy) = level["mean"].toDouble();
        QVERIFY(hard < 0.8 && easy == 1.0);
        for (const char* const name :
             {"effects.csv", "levels.csv", "pairs.csv", "confusion.csv", "report.html", "speed.svg"})
            QVERIFY2(QFile::exists(path(QString("out/") + name)), name);
        QVERIFY(!QImage(path("out/right.png")).isNull());
        const Run words = lab({"study", "report", path("one"), "--out", path("out")});
        QVERIFY(words.out.contains("radius 20 mm: ") &&
                words.out.contains("radius 80 mm: 100.0 % named rightly"));
    }
    void an_answer_where_nobody_was_asked_is_refused() {
        make_study("asked");
        const QString table = path("asked/participant-002.csv");
        QFile file(table);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray csv = file.readAll();
        file.close();
        const qsizetype training = csv.indexOf(",,,no,"); // an answer, and whether it was right
        QVERIFY(training > 0);
        write(table, csv.insert(training + 1, "curve"));
        for (const QStringList& words : {QStringList{"study", "check", path("asked")},
                                         {"study", "report", path("asked"), "--out", path("asked-out")}}) {
            const Run run = lab(words);
            QCOMPARE(run.code, 1);
            QVERIFY2(run.err.contains("participant-002.csv\": Line 2 of the table of trials has an answer "
                                      "that nobody could give."),
                     run.err.constData());
        }
    }
    void a_study_that_runs_is_checked_as_far_as_it_has_come() {
        auto writer = run_study("running");
        const Run running = lab({"study", "check", path("running")});
        QCOMPARE(running.code, 0);
        QCOMPARE(running.err,
                 QByteArray("A program is running this study now; this is how far it has come.\n"));
        QVERIFY(running.out.startsWith("Participant 4: ") && running.out.count('\n') == 1);
        writer.reset();
        const Run ended = lab({"study", "check", path("running")});
        QCOMPARE(ended.code, 0);
        QCOMPARE(ended.err, QByteArray());
        write(path("running/paths/") + QString::fromStdString(tp::path_file_name(4, 2)), "torn");
        const Run torn = lab({"study", "check", path("running")});
        QCOMPARE(torn.code, 1);
        QVERIFY(torn.out.contains("trial-0002.csv.gz\": The finger's path cannot be unpacked: it "));
    }
    void a_study_is_exported_as_one_zip() {
        run_study("sent");
        write(path("sent/Anna.txt"), "Anna is participant 4");
        const QStringList words{"study", "export", path("sent"), "--out"};
        const Run run = lab(words + QStringList{path("sent.zip")});
        QCOMPARE(run.code, 0);
        QCOMPARE(run.out, QByteArray("1 participants, 3 trials, 3 paths\n"));
        QVERIFY(run.err.endsWith("Anna.txt\" is no file of the study; it is not in the zip.\n"));
        QCOMPARE(lab(words + QStringList{path("again.zip")}).code, 0);
        QFile one(path("sent.zip")), other(path("again.zip"));
        QVERIFY(one.open(QIODevice::ReadOnly) && other.open(QIODevice::ReadOnly));
        const QByteArray bytes = one.readAll();
        QVERIFY(bytes.startsWith("PK") && bytes == other.readAll());
        QVERIFY(bytes.contains("primitives/paths/participant-004-trial-0003.csv.gz") &&
                !bytes.contains("Anna"));
        QCOMPARE(lab({"study", "export", path("sent")}).code, 2);
        const Run nowhere = lab(words + QStringList{path("no/where.zip")});
        QCOMPARE(nowhere.code, 1);
        QVERIFY(nowhere.err.contains("there is no folder"));
    }
    void what_is_wrong_is_said() {
        QCOMPARE(lab({"study"}).code, 2);
        QCOMPARE(lab({"study", "dance", "."}).code, 2);
        QCOMPARE(lab({"study", "report", "."}).code, 2);
        QCOMPARE(lab({"study", "plan", shipped("tracking"), "--participant", "0"}).code, 2);
        const Run nowhere = lab({"study", "check", path("nowhere")});
        QCOMPARE(nowhere.code, 1);
        QVERIFY(nowhere.err.contains("protocol.study"));
        write(path("bad.study"), "task: dance\n");
        const Run bad = lab({"study", "plan", path("bad.study")});
        QCOMPARE(bad.code, 1);
        QVERIFY(bad.err.contains("Line 1 of the experiment needs follow or name."));
        QVERIFY(bad.out.isEmpty());
    }
    void a_study_without_trials_has_no_report() {
        QVERIFY(QDir(folder_.path()).mkpath("none"));
        QVERIFY(QFile::copy(shipped("primitives"), path("none/protocol.study")));
        QVERIFY(lab({"study", "check", path("none")})
                    .out.startsWith("There are no trials yet.\nThere is no file "));
        const Run run = lab({"study", "report", path("none"), "--out", path("none-out")});
        QCOMPARE(run.code, 1);
        QVERIFY(run.err.contains("There are no trials yet that count."));
        QVERIFY(!QDir(path("none-out")).exists());
    }
};

QTEST_GUILESS_MAIN(StudyVerbTest)
#include "study_test.moc"
