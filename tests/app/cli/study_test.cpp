// SPDX-License-Identifier: Apache-2.0
// `touchphoto-lab study`: plans, checks and reports, and what it refuses.
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

#include <string>

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

    /// Three people who have named shapes, as `plan` has planned it; radius 20 mm is hard.
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
                const bool hard = cells[4] == "20" && (cells[0].toInt() + participant) % 2 == 0;
                const QByteArray answer = hard ? "circle" : cells[3];
                csv += "primitives," + QByteArray::number(participant) + "," + cells[0] + "," + cells[1] +
                       "," + cells[2] + "," + cells[3] + "," + cells[4] + ",," +
                       QByteArray::number(8 + participant) + "." + cells[0] + "," + answer + "," +
                       (answer == cells[3] ? "yes" : "no") + ",no," + cells[5] + "\n";
            }
            write(path(name + QString("/participant-00%1.csv").arg(participant)), csv);
        }
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
        QCOMPARE(check.code, 0);
        QVERIFY(check.out.startsWith("Participant 1: 45 trials of 45.\nParticipant 2:"));
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
        QCOMPARE(lab({"study", "check", path("none")}).out, QByteArray("There are no trials yet.\n"));
        const Run run = lab({"study", "report", path("none"), "--out", path("none-out")});
        QCOMPARE(run.code, 1);
        QVERIFY(run.err.contains("There are no trials yet that count."));
        QVERIFY(!QDir(path("none-out")).exists());
    }
};

QTEST_GUILESS_MAIN(StudyVerbTest)
#include "study_test.moc"
