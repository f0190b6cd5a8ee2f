// SPDX-License-Identifier: Apache-2.0
// `touchphoto-lab study simulate`: fills a folder that the other parts of the verb read, and what it refuses.
#include "core/study_folder/study_folder.hpp"
#include "lab_process.hpp"
#include "places.hpp"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cstdint>
#include <string>

class StudySimulateTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }
    QString experiment(const QByteArray& lines) const {
        QFile file(path("an.study"));
        if (!file.open(QIODevice::WriteOnly) || file.write("experiment: a\n" + lines) < 0)
            qFatal("no file");
        return file.fileName();
    }
    static constexpr const char* following =
        "task: follow\nset path: circle\nset stiffness: 0.4 N/mm\nfactor range: 4, "
        "8 mm\nset law: published\n";

private slots:
    void a_simulated_study_is_checked_and_reported_like_one_of_people() {
        const Run run = lab({"study", "simulate", experiment(following), "--participants", "3", "--seed", "4",
                             "--jobs", "0", "--out", path("one"), "--json"});
        QVERIFY2(run.code == 0, run.err.constData());
        const QJsonObject said = QJsonDocument::fromJson(run.out).object();
        QCOMPARE(said["participants"].toInt(), 3);
        QCOMPARE(said["trials"].toInt(), 6);
        QVERIFY(said["seconds"].toDouble() > 10.0);
        QCOMPARE(lab({"study", "check", path("one")}).code, 0);
        QCOMPARE(lab({"study", "report", path("one"), "--out", path("report")}).code, 0);
        const auto study = tp::read_study(path("one").toStdString());
        QVERIFY(study && study->terms && study->terms->simulated);
        QCOMPARE(study->terms->seed, std::uint64_t{4});
    }
    void the_law_can_be_set_and_stands_in_the_protocol() {
        QCOMPARE(lab({"study", "simulate", experiment(following), "--participants", "1", "--law", "exact",
                      "--corner-cue", "--rate", "500", "--delay", "2", "--out", path("exact")})
                     .code,
                 0);
        const auto study = tp::read_study(path("exact").toStdString());
        QCOMPARE(study->experiment.value_of(tp::StudyParameter::law, 0), std::string("exact"));
        QCOMPARE(study->sittings.front().machine.device,
                 std::string("simulated device, 500 Hz, 2 ticks of delay, corner cue"));
        // The same folder with another law is another study.
        const Run other =
            lab({"study", "simulate", experiment(following), "--participants", "1", "--out", path("exact")});
        QCOMPARE(other.code, 1);
        QVERIFY(other.err.contains("another experiment"));
    }
    void a_device_has_its_own_rate_delay_and_body() {
        const auto ends_in = [&](const QStringList& words, const QString& name) {
            const Run run = lab(QStringList{"study", "simulate", experiment(following), "--participants", "1",
                                            "--law", "exact", "--out", path(name)} +
                                words);
            if (run.code != 0)
                qFatal("%s", run.err.constData());
            return tp::read_study(path(name).toStdString()).value();
        };
        const auto stick = ends_in({"--device", "stick"}, "stick");
        QCOMPARE(stick.sittings.front().machine.device,
                 std::string("simulated stick, 1000 Hz, 4 ticks of delay"));
        const auto slow = ends_in({"--device", "stick", "--rate", "500", "--delay", "1", "--led"}, "slow");
        QCOMPARE(slow.sittings.front().machine.device,
                 std::string("simulated stick, 500 Hz, 1 ticks of delay, led to the start"));
        QVERIFY(slow.records != stick.records);
        const Run unknown =
            lab({"study", "simulate", experiment(following), "--device", "joypad", "--out", path("unknown")});
        QCOMPARE(unknown.code, 2);
        QVERIFY2(unknown.err.contains("There is no device \"joypad\"; --device knows pad, stick, falcon, "
                                      "2diy and mouse."),
                 unknown.err.constData());
    }
    void the_program_s_own_experiments_have_names_and_numbers() {
        const QByteArray by_file =
            lab({"study", "plan",
                 QString::fromStdString(tp::test::in_source("resources/studies/laws-tracking.study"))})
                .out;
        QCOMPARE(by_file.count('\n'), 1 + 3 + 2 * 3 * 6); // columns, training, laws x paths x repetitions
        QCOMPARE(lab({"study", "plan", "4"}).out, by_file);
        QCOMPARE(lab({"study", "plan", "laws-tracking"}).out, by_file);
        QVERIFY(lab({"study", "plan", "1"}).out != by_file);
        const Run none = lab({"study", "plan", "6"});
        QCOMPARE(none.code, 1);
        QVERIFY2(none.err.contains("\"6\""), none.err.constData());
    }
    void faces_come_from_a_folder() {
        const QString faces = QString::fromStdString(tp::test::in_source("resources/samples"));
        const QString asked =
            experiment("task: name\nfactor expression: smiling, angry\nfactor face: 1, 2\nset stiffness: "
                       "0.5 N/mm\nset range: 10 mm\nanswer: expression\nlongest trial: 30 s\n");
        const Run run = lab(
            {"study", "simulate", asked, "--participants", "1", "--faces", faces, "--out", path("faces")});
        QVERIFY2(run.code == 0, run.err.constData());
        const auto study = tp::read_study(path("faces").toStdString());
        QVERIFY2(study.ok(), study.error().c_str());
        QVERIFY(!study->records.empty());
        for (const tp::TrialRecord& record : study->records)
            QVERIFY(!record.answer.empty());
        const Run many = lab(
            {"study", "simulate",
             experiment("task: name\nfactor expression: smiling, angry\nset face: 9\nanswer: expression\n"),
             "--participants", "1", "--faces", faces, "--out", path("many")});
        QCOMPARE(many.code, 1);
        QVERIFY(many.err.contains("no face number 9"));
    }
    void what_cannot_be_is_refused_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("sentence");
        QTest::newRow("no folder") << QStringList{} << 2 << QByteArray("--out DIR is missing");
        QTest::newRow("law") << QStringList{"--out", "x", "--law", "mine"} << 2
                             << QByteArray("exact or published");
        QTest::newRow("rate") << QStringList{"--out", "x", "--rate", "10"} << 2 << QByteArray("100 to 4000");
        QTest::newRow("delay") << QStringList{"--out", "x", "--delay", "17"} << 2 << QByteArray("--delay");
        QTest::newRow("nobody") << QStringList{"--out", "x", "--participants", "0"} << 2
                                << QByteArray("--participants");
        QTest::newRow("faces") << QStringList{"--out", "x", "--faces", "/nowhere"} << 1
                               << QByteArray("/nowhere");
        QTest::newRow("published law with a cue")
            << QStringList{"--out", "x", "--corner-cue"} << 1 << QByteArray("belong to the exact law");
    }
    void what_cannot_be_is_refused() {
        QFETCH(QStringList, words);
        QFETCH(int, code);
        QFETCH(QByteArray, sentence);
        for (QString& word : words)
            if (word == "x")
                word = path("refused");
        const Run run = lab(QStringList{"study", "simulate", experiment(following)} + words);
        QCOMPARE(run.code, code);
        QVERIFY2(run.err.contains(sentence), run.err.constData());
    }
    void a_published_experiment_is_done_again_with_other_people() {
        const QString short_one = [&] {
            QFile file(path("short.study"));
            const QByteArray lines =
                "experiment: primitives\ntask: name\nfactor shape: circle, hexagon\nset radius: 20 mm\n"
                "set law: exact\nanswer: shape\nlongest trial: 5 s\n";
            if (!file.open(QIODevice::WriteOnly) || file.write(lines) < 0)
                qFatal("no file");
            return file.fileName();
        }();
        const QStringList words{"study", "replicate",      short_one, "--seeds", "2",           "--seed",
                                "7",     "--participants", "2",       "--out",   path("again"), "--json"};
        const Run run = lab(words);
        QVERIFY2(run.code == 0, run.err.constData());
        const QJsonObject said = QJsonDocument::fromJson(run.out).object();
        QCOMPARE(said["experiment"].toString(), QString("primitives"));
        QCOMPARE(said["studies"].toInt(), 2);
        QCOMPARE(said["participants"].toInt(), 2);
        const QJsonArray published = said["published"].toArray();
        QJsonObject circle;
        for (const QJsonValue& row : published)
            if (row["what"] == "time, circle" && row["published"] == "7.9 s")
                circle = row.toObject();
        QCOMPARE(circle["studies"].toInt(), 2);
        QVERIFY(circle["least"].toDouble() <= circle["mean"].toDouble() &&
                circle["mean"].toDouble() <= circle["most"].toDouble());
        for (const char* const name : {"seed-7/participant-002.csv", "seed-8/participant-002.csv",
                                       "published.csv", "published.html", "published.png", "published.svg"})
            QVERIFY2(QFile::exists(path(QString("again/") + name)), name);
        for (const std::uint64_t seed : {7U, 8U}) {
            const auto study = tp::read_study(path("again/seed-%1").arg(seed).toStdString());
            QVERIFY(study && study->terms && study->terms->seed == seed);
        }
        QCOMPARE(lab(words).out, run.out); // what is done is kept, and gives the same
        const Run mine = lab({"study", "replicate", experiment(following), "--out", path("mine")});
        QCOMPARE(mine.code, 1);
        QCOMPARE(mine.err, QByteArray("Nothing was published of the experiment a.\n"));
    }
    void an_experiment_that_compares_laws_keeps_them() {
        const Run run = lab({"study", "simulate",
                             experiment("task: follow\nset path: circle\nfactor law: exact, published\n"),
                             "--law", "exact", "--out", path("laws")});
        QCOMPARE(run.code, 2);
        QVERIFY(run.err.contains("varies in this experiment"));
    }
};

QTEST_APPLESS_MAIN(StudySimulateTest)
#include "study_simulate_test.moc"
