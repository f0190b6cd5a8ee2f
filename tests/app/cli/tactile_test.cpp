// SPDX-License-Identifier: Apache-2.0
#include "lab_process.hpp"
#include "places.hpp"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace {

const QString anna = QString(tp::test::in_source("resources/samples/anna_smiling.jpg"));
const QString two_people = QString(tp::test::in_source("resources/samples/ben_and_clara.jpg"));

QByteArray bytes_of(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TactileVerbTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QString path(const QString& name) const { return folder_.filePath(name); }

private slots:
    void a_portrait_becomes_a_sheet_of_either_kind() {
        for (const QString out : {"anna.pdf", "anna.svg"}) {
            const Run run = lab({"tactile", anna, path(out), "--name", "Anna", "--title", "Anna, 2026", "--json"});
            QCOMPARE(run.code, 0);
            QVERIFY(bytes_of(path(out)).startsWith(out.endsWith("pdf") ? "%PDF-1.4" : "<?xml"));
            const QJsonObject sheet = QJsonDocument::fromJson(run.out).object();
            QCOMPARE(sheet["width_mm"].toDouble(), 210.0);
            QVERIFY(sheet["least_gap_mm"].toDouble() >= 3.0);
            QVERIFY(sheet["lines"].toArray().size() >= 5);
            QCOMPARE(sheet["labels"].toArray()[0].toObject()["braille"].toString(), QString("⠠⠁⠝⠝⠁"));
            QCOMPARE(run.err.count('\n'), sheet["notes"].toArray().size());
        }
    }
    void the_same_words_give_the_same_bytes() {
        for (const QString out : {"one.pdf", "other.pdf"})
            QCOMPARE(lab({"tactile", anna, path(out), "--name", "Anna"}).code, 0);
        QCOMPARE(bytes_of(path("one.pdf")), bytes_of(path("other.pdf")));
    }
    void names_come_from_the_sidecar() {
        const QString photo = path("two.jpg");
        QVERIFY(QFile::copy(two_people, photo));
        const QJsonObject found = QJsonDocument::fromJson(lab({"faces", photo, "--json"}).out).object();
        const QJsonArray box = found["faces"].toArray()[1].toObject()["box"].toArray();
        const double width = found["width"].toDouble(), height = found["height"].toDouble();
        const QString place = QString("%1,%2,%3,%4")
                                  .arg((box[0].toDouble() + 0.5 * box[2].toDouble()) / width)
                                  .arg((box[1].toDouble() + 0.5 * box[3].toDouble()) / height)
                                  .arg(box[2].toDouble() / width)
                                  .arg(box[3].toDouble() / height);
        QCOMPARE(lab({"album", "person", "name", photo, "Clara", "--face", place}).code, 0);
        const Run run = lab({"tactile", photo, path("two.svg"), "--json", "--landscape", "--paper", "a3"});
        QCOMPARE(run.code, 0);
        const QJsonObject sheet = QJsonDocument::fromJson(run.out).object();
        QCOMPARE(sheet["width_mm"].toDouble(), 420.0);
        QCOMPARE(sheet["labels"].toArray().size(), 1);
        QCOMPARE(sheet["labels"].toArray()[0].toObject()["name"].toString(), QString("Clara"));
    }
    void one_face_alone_and_another_language() {
        const Run run = lab({"tactile", two_people, path("face.svg"), "--face", "2", "--name", "Ben", "--name", "민수",
                             "--language", "de", "--paper", "braille", "--json"});
        QCOMPARE(run.code, 0);
        const QJsonObject sheet = QJsonDocument::fromJson(run.out).object();
        QCOMPARE(sheet["labels"].toArray()[0].toObject()["name"].toString(), QString("민수"));
        for (const QJsonValue line : sheet["lines"].toArray())
            QVERIFY(!line.toObject()["name"].toString().startsWith("face 1"));
    }
    void what_cannot_be_done_is_said_data() {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<int>("code");
        QTest::newRow("no output") << QStringList{"a.jpg"} << 2;
        QTest::newRow("another kind") << QStringList{"a.jpg", "a.doc"} << 2;
        QTest::newRow("no such paper") << QStringList{"a.jpg", "a.pdf", "--paper", "a5"} << 2;
        QTest::newRow("no such language") << QStringList{"a.jpg", "a.pdf", "--language", "tlh"} << 2;
        QTest::newRow("face zero") << QStringList{"a.jpg", "a.pdf", "--face", "0"} << 2;
        QTest::newRow("no photograph") << QStringList{"/nowhere/a.jpg", "a.pdf"} << 1;
        QTest::newRow("no such face") << QStringList{anna, "a.pdf", "--face", "9"} << 1;
        QTest::newRow("no such folder") << QStringList{anna, "/nowhere/at/all.pdf"} << 1;
    }
    void what_cannot_be_done_is_said() {
        QFETCH(QStringList, words);
        QFETCH(int, code);
        const Run run = lab(QStringList{"tactile"} + words);
        QCOMPARE(run.code, code);
        QVERIFY(run.out.isEmpty());
        QVERIFY(!run.err.isEmpty());
    }
};

QTEST_GUILESS_MAIN(TactileVerbTest)
#include "tactile_test.moc"
