// SPDX-License-Identifier: Apache-2.0
// `touchphoto-lab aim`: what it writes, twice the same, and what it refuses.
#include "lab_process.hpp"

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace {

QByteArray bytes_of(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class AimVerbTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }
    Run simulate(const QString& out, const QStringList& more) const {
        return lab(QStringList{"aim", "simulate", "--out", path(out)} + more);
    }

private slots:
    void initTestCase() { QVERIFY(folder_.isValid()); }

    void it_writes_json_tables_and_a_plot() {
        const Run run = simulate("one", {"--people", "40", "--json"});
        QCOMPARE(run.code, 0);
        QCOMPARE(run.err, QByteArray());
        const QJsonObject report = QJsonDocument::fromJson(run.out).object();
        QCOMPARE(report["aim"].toString(), QStringLiteral("middle"));
        QCOMPARE(report["people"].toInt(), 40);
        QCOMPARE(report["seed"].toInt(), 1);
        const QJsonArray rows = report["guidance"].toArray();
        QCOMPARE(rows.size(), 4);
        const auto within = [&rows](int row, const char* s) {
            return rows[row].toObject()[s].toDouble(-1.0);
        };
        QCOMPARE(rows[0].toObject()["guidance"].toString(), QStringLiteral("words and tone"));
        QCOMPARE(rows[3].toObject()["guidance"].toString(), QStringLiteral("none"));
        QVERIFY(within(0, "within_15_s") > within(3, "within_15_s"));
        for (int row = 0; row < 4; ++row)
            QVERIFY(within(row, "within_5_s") >= 0.0 &&
                    within(row, "within_5_s") <= within(row, "within_20_s"));
        QVERIFY(rows[0].toObject()["median_s"].isDouble());
        QVERIFY(rows[3].toObject()["median_s"].isNull());

        const QList<QByteArray> shares = bytes_of(path("one/aim.csv")).trimmed().split('\n');
        QCOMPARE(shares.size(), 5);
        QVERIFY(shares[0].startsWith("aim,guidance,people,within_5_s"));
        const QList<QByteArray> people = bytes_of(path("one/people.csv")).trimmed().split('\n');
        QCOMPARE(people.size(), 41);
        // The people's own times are what the shares are of.
        int within_10 = 0;
        for (const QByteArray& person : people.mid(1)) {
            const QByteArray time = person.trimmed().split(',')[5];
            within_10 += !time.isEmpty() && time.toDouble() <= 10.0 ? 1 : 0;
        }
        QCOMPARE(within_10, qRound(40.0 * within(0, "within_10_s")));
        QVERIFY(!QImage(path("one/aim.png")).isNull());
        QVERIFY(bytes_of(path("one/aim.svg")).contains("<svg"));
    }

    void the_same_seed_gives_the_same_bytes() {
        const Run first = simulate("a", {"--people", "12", "--seed", "7"});
        const Run second = simulate("b", {"--people", "12", "--seed", "7"});
        const Run other = simulate("c", {"--people", "12", "--seed", "8"});
        QCOMPARE(first.code, 0);
        QCOMPARE(first.out, second.out);
        QVERIFY(first.out != other.out);
        for (const char* name : {"aim.csv", "people.csv", "aim.png", "aim.svg"})
            QCOMPARE(bytes_of(path(QStringLiteral("a/") + name)),
                     bytes_of(path(QStringLiteral("b/") + name)));
        QVERIFY(bytes_of(path("a/people.csv")) != bytes_of(path("c/people.csv")));
    }

    void other_assumptions_are_a_table() {
        QCOMPARE(simulate("assumed", {"--people", "10", "--assumptions"}).code, 0);
        const QList<QByteArray> rows = bytes_of(path("assumed/assumptions.csv")).trimmed().split('\n');
        QCOMPARE(rows.size(), 13);
        QVERIFY(rows[1].startsWith("as it is,"));
        // As it is, is what the other table says of words and tone.
        const QList<QByteArray> both = bytes_of(path("assumed/aim.csv")).split('\n')[1].trimmed().split(',');
        QCOMPARE(rows[1].trimmed().split(',')[2], both[5]);
        QCOMPARE(rows[1].trimmed().split(',')[4], both[7]);
    }

    void every_aim_can_be_named() {
        for (const char* aim : {"middle", "thirds", "head-and-shoulders", "everybody"}) {
            const Run run = simulate("aims", {"--people", "2", "--json", "--aim", aim});
            QCOMPARE(run.code, 0);
            QVERIFY(run.out.contains(aim));
        }
    }

    void what_is_wrong_is_one_sentence_data() {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("no_folder") << QStringList{"simulate"};
        QTest::newRow("another_word") << QStringList{"dream", "--out", "x"};
        QTest::newRow("nobody") << QStringList{"simulate", "--out", "x", "--people", "0"};
        QTest::newRow("no_seed") << QStringList{"simulate", "--out", "x", "--seed", "none"};
        QTest::newRow("no_aim") << QStringList{"simulate", "--out", "x", "--aim", "feet"};
    }
    void what_is_wrong_is_one_sentence() {
        QFETCH(QStringList, words);
        const Run run = lab(QStringList{"aim"} + words);
        QCOMPARE(run.code, 2);
        QVERIFY(run.out.isEmpty() && !run.err.isEmpty());
    }

    void a_folder_that_cannot_be_made_is_bad_input() {
        const Run run =
            lab({"aim", "simulate", "--out", written(path("file"), "x") + "/in_it", "--people", "1"});
        QCOMPARE(run.code, 1);
        QVERIFY(is_one_sentence(run.err));
    }
};

QTEST_GUILESS_MAIN(AimVerbTest)
#include "aim_test.moc"
