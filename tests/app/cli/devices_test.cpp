// SPDX-License-Identifier: Apache-2.0
// touchphoto-lab devices as a shell sees it.
#include "lab_process.hpp"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

class DevicesTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QString scene() {
        return written(folder_.filePath("scene.svg"),
                       "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"200mm\" height=\"150mm\" "
                       "viewBox=\"0 0 200 150\">"
                       "<path id=\"line\" d=\"M 20 77 L 180 77\"/></svg>");
    }

private slots:
    void lists_the_simulated_device_always() {
        const Run run = lab({"devices", "--json"});
        QCOMPARE(run.code, 0);
        const QJsonObject first = QJsonDocument::fromJson(run.out.split('\n').first()).object();
        QCOMPARE(first["name"].toString(), QString("simulated"));
        QVERIFY(first["interface"].isString());
        QCOMPARE(first["means"].toString(), QString("force"));
        QVERIFY(first["pad"].isBool());
        QVERIFY(lab({"devices"}).out.startsWith("simulated "));
    }

    void tests_a_device() {
        const Run run = lab({"devices", "test", "simulated", "--seconds", "0.3"});
        // What a PHANToM Premium 1.5 gives, with which the method was published.
        QVERIFY2(run.out.contains("force       8.5 N, continuous 1.4 N\n"), run.out + run.err);
    }

    void a_device_that_does_not_move_is_not_calibrated() {
        const QString file = folder_.filePath("calibrations.txt");
        const QStringList words{"devices", "calibrate", "simulated", "--screen", "250x150", "--file", file};
        const Run run = lab(words, "\n\n\n\n");
        QCOMPARE(run.code, 1);
        for (const char* const said : {"top left mark", "top right mark", "bottom right mark", "bottom left mark",
                                       "at least three marks that do not lie on one line"})
            QVERIFY2(run.err.contains(said), run.err);
        const Run given_up = lab(words, "\n");
        QCOMPARE(given_up.code, 1);
        QVERIFY2(given_up.err.contains("Nothing was changed."), given_up.err);
        QVERIFY(!QFile::exists(file));
    }

    void what_is_not_there_is_said_so() {
        for (const char* const verb : {"test", "home", "measure", "tick"}) {
            const Run run = lab({"devices", verb, "pad:none"});
            QCOMPARE(run.code, 1);
            QVERIFY(is_one_sentence(run.err) || run.err.contains("lists what is there"));
        }
        QCOMPARE(lab({"devices", "home", "simulated"}).code, 1);
        QVERIFY(lab({"devices", "measure", "simulated"}).err.contains("only force sticks need measuring"));
        QCOMPARE(lab({"devices", "calibrate", "pad:none", "--screen", "250x150"}).code, 1);
        for (const char* screen : {"", "250", "250x", "1x1", "axb", "250x150x3"})
            QCOMPARE(lab({"devices", "calibrate", "simulated", "--screen", screen}).code, 2);
        QCOMPARE(lab({"devices", "calibrate", "simulated", "--screen", "250x150", "--inset", "-1"}).code, 2);
        QCOMPARE(lab({"devices", "test"}).code, 2);
        for (const char* const wrong : {"--count=0", "--count=x", "--strength=0", "--strength=x"})
            QCOMPARE(lab({"devices", "tick", "motor:none", wrong}).code, 2);
        QCOMPARE(lab({"devices", "record", folder_.filePath("no"), "--device", "pad:none"}).code, 1);
    }

    void a_session_is_recorded_and_replayed() {
        const QString file = folder_.filePath("session");
        const Run recorded = lab({"devices", "record", file, "--seconds", "1", "--scene", scene()});
        QVERIFY2(recorded.code == 0, recorded.err);
        const Run csv = lab({"devices", "replay", file});
        QCOMPARE(csv.code, 0);
        QVERIFY(csv.out.startsWith("now_s,fresh,x_mm,y_mm,fx_n,fy_n,lost,motors_off,refused\n"));
        QVERIFY(csv.out.count('\n') > 10);
        const Run again = lab({"devices", "replay", file, "--scene", scene()});
        QCOMPARE(again.code, 0);
        const QByteArray ticks = QByteArray::number(csv.out.count('\n') - 1);
        QVERIFY2(again.out.startsWith("ticks " + ticks + ','), again.out);
        QCOMPARE(lab({"devices", "record", file}).code, 1); // it exists
    }

    void what_is_no_recording_is_refused() {
        const Run run = lab({"devices", "replay", scene()});
        QCOMPARE(run.code, 1);
        QVERIFY(run.err.contains("not a recording of a force device"));
        QCOMPARE(lab({"devices", "replay", folder_.filePath("missing")}).code, 1);
    }
};

QTEST_GUILESS_MAIN(DevicesTest)
#include "devices_test.moc"
