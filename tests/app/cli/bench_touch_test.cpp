// SPDX-License-Identifier: Apache-2.0
#include "lab_process.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

class BenchTouchTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QByteArray first_; ///< what is written with the seed 1

    QString path(const QString& name) const { return folder_.filePath(name); }
    QByteArray table(const QString& out, const QString& seed) const {
        const Run run = lab({"bench", "touch", "--people", "1", "--seed", seed, "--out", path(out)});
        QFile file(path(out) + "/touch.csv");
        return run.code == 0 && run.out.startsWith("manner") && file.open(QIODevice::ReadOnly)
                   ? file.readAll()
                   : QByteArray();
    }

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        first_ = table("one", "1");
        QVERIFY(!first_.isEmpty());
    }

    void a_row_for_the_force_and_each_latency_of_the_others() {
        const QList<QByteArray> rows = first_.trimmed().split('\n');
        QCOMPARE(rows.size(), 10);
        QCOMPARE(rows[0].trimmed(),
                 QByteArray("manner,latency_ms,trials,found,find_s,followed,follow_s,error_mm,lost"));
        QVERIFY(rows[1].startsWith("force,5,9,") && rows[1].trimmed().endsWith(','));
        QVERIFY(rows[2].startsWith("resistance,5,9,") && rows[5].startsWith("resistance,100,9,"));
        QVERIFY(rows[6].startsWith("ticks,5,9,") && rows[9].startsWith("ticks,100,9,"));
    }

    void the_same_seed_writes_the_same_bytes() {
        QVERIFY(table("again", "1") == first_ && table("other", "2") != first_);
    }

    void what_is_wrong_is_said() {
        QCOMPARE(lab({"bench", "touch"}).code, 2);
        QCOMPARE(lab({"bench", "touch", "--out", path("x"), "--people", "0"}).code, 2);
        QCOMPARE(lab({"bench", "touch", "--out", path("x"), "--seed", "one"}).code, 2);
        const Run run =
            lab({"bench", "touch", "--people", "1", "--out", written(path("file"), "x") + "/folder"});
        QVERIFY(run.code == 1 && is_one_sentence(run.err));
    }
};

QTEST_APPLESS_MAIN(BenchTouchTest)
#include "bench_touch_test.moc"
