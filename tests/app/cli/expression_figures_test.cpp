// SPDX-License-Identifier: Apache-2.0
// How well contours tell expressions: on people drawn for it, and on portraits of people.
#include "expression_runs.hpp"
#include "places.hpp"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace expression_runs;

namespace {

const QString london = QString(tp::test::in_shared("faces/photos/london"));

/// Neutral and smiling portraits of the people whom the training of the nets did not see.
QStringList portraits() {
    QStringList files;
    for (const QByteArray& person : bytes_of(tp::test::in_source("faces/training/holdout.txt")).split('\n'))
        if (!person.isEmpty() && !person.startsWith('#'))
            files += files_in(london, person + "_*.jpg");
    return files;
}

} // namespace

class ExpressionFiguresTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }
    /// Contours of so many drawn people with every expression, or nothing where this machine cannot draw.
    QStringList crowd(int people, int seed) const {
        const QString out = path(QStringLiteral("crowd%1").arg(seed));
        QProcess drawing;
        drawing.start("/usr/bin/python3", {samples + "/draw_portraits.py", "--crowd", QString::number(people),
                                           "--seed", QString::number(seed), "--contours-only", "--out", out});
        return ended(drawing).code == 0 ? files_in(out, "*.truth.svg") : QStringList();
    }

private slots:
    void initTestCase() { QVERIFY(folder_.isValid()); }

    void people_who_taught_nothing_are_told_apart_too() {
        const QStringList files = crowd(100, 7);
        if (files.isEmpty())
            QSKIP("needs Debian's python3-numpy and python3-opencv");
        QCOMPARE(files.size(), 500);
        const auto cells = table(path("table"), files);
        QVERIFY(cells["exact smiling as_smiling"] > 85.0 && cells["exact surprised as_surprised"] > 80.0);
        QVERIFY(cells["exact sad as_sad"] > 65.0 && cells["exact angry as_angry"] > 65.0);
        QVERIFY(right(cells, "exact") > 80.0 && right(cells, "felt") > 70.0);
        QVERIFY(right(cells, "felt") < right(cells, "exact"));
        // The order that the paper found.
        for (const char* clear : {"smiling", "surprised"})
            for (const char* like : {"sad", "angry"})
                QVERIFY(cells[QStringLiteral("felt %1 as_%1").arg(clear)] >
                        cells[QStringLiteral("felt %1 as_%1").arg(like)]);
        QVERIFY(cells["felt sad as_angry"] > 5.0 * cells["felt sad as_smiling"] + 5.0);
        QVERIFY(cells["felt angry as_sad"] > 5.0 * cells["felt angry as_smiling"] + 5.0);
    }

    void what_is_built_in_is_what_the_drawn_crowd_teaches() {
        const QStringList files = crowd(300, 1);
        if (files.isEmpty())
            QSKIP("needs Debian's python3-numpy and python3-opencv");
        const QString learned = path("learned.inc");
        const Run run = lab(QStringList{"expressions", "--learn", learned} + files);
        QVERIFY2(run.code == 0, run.err.constData());
        QCOMPARE(bytes_of(learned), bytes_of(tp::test::in_source("core/study/expression_observer.inc")));
    }

    /// Portraits of 34 people, neutral and smiling. Neutral is not among the paper's four, so what is told
    /// apart here is a smile from none; each person is judged by what the others teach.
    void smiles_of_real_people_are_told_from_their_neutral_faces() {
        const QStringList files = portraits();
        if (files.isEmpty())
            QSKIP("needs ../shared/faces: the London portraits");
        QByteArray csv = "photo,expression\n";
        for (const QString& file : files)
            csv += file.toUtf8() + (file.endsWith("_08.jpg") ? ",smiling\n" : ",neutral\n");
        const QString table_of_labels = path("london.csv");
        QFile file(table_of_labels);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(csv) == csv.size());
        file.close();
        const QStringList labels{"--labels", table_of_labels};
        const auto others =
            table(path("table"), files, QStringList{"--across-people", "--with-neutral"} + labels);
        QCOMPARE(others["exact smiling faces"], 34.0);
        QVERIFY(others["exact smiling as_smiling"] > 65.0 && others["exact neutral as_neutral"] > 85.0);
        QVERIFY(others["felt smiling as_smiling"] > 65.0 && others["felt neutral as_neutral"] > 85.0);
        // What drawn people taught holds for real ones, though less well.
        const auto drawn = table(path("table"), files, labels);
        QVERIFY(drawn["exact smiling as_smiling"] > 60.0 && drawn["exact neutral as_smiling"] < 20.0);
        QCOMPARE(drawn["exact smiling as_surprised"], 0.0);
    }

    void people_across_people_and_a_face_without_a_label() {
        const QStringList files = crowd(8, 3);
        if (files.isEmpty())
            QSKIP("needs Debian's python3-numpy and python3-opencv");
        const auto cells = table(path("table"), files, {"--across-people", "--with-neutral"});
        QVERIFY(cells.contains("exact neutral as_neutral"));
        QVERIFY(cells["exact smiling as_smiling"] > 50.0);
        const QString stranger = path("stranger.svg");
        QVERIFY(QFile::copy(samples + "/ben_smiling.truth.svg", stranger));
        const Run run = lab(QStringList{"expressions", "--json", "--across-people", stranger} + files);
        const QJsonObject first = QJsonDocument::fromJson(run.out.left(run.out.indexOf('\n'))).object();
        QVERIFY(first["expression"].isNull());
        QCOMPARE(first["answer"].toString(), QString("smiling"));
    }
};

QTEST_GUILESS_MAIN(ExpressionFiguresTest)
#include "expression_figures_test.moc"
