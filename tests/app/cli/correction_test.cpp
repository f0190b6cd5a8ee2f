// SPDX-License-Identifier: Apache-2.0
// A caregiver's corrections from the shell: they override, survive, and are weighed by what is felt.
#include "core/svg/contour_sheet.hpp"
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

using namespace tp;

class CorrectionTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    QString photo_;
    QString sheet_;
    QString truth_ = QString(tp::test::in_source("resources/samples/anna_smiling.truth.svg"));

    QJsonObject face(const QStringList& options = {}) const {
        const Run run = lab(QStringList{"faces", "--json", photo_} + options);
        return QJsonDocument::fromJson(run.out)["faces"].toArray().first().toObject();
    }

private slots:
    void init() {
        photo_ = folder_.filePath("anna.jpg");
        sheet_ = photo_ + ".contours.svg";
        QFile::remove(photo_);
        QFile::remove(sheet_);
        QVERIFY(QFile::copy(tp::test::in_source("resources/samples/anna_smiling.jpg"), photo_));
    }

    void a_correction_overrides_survives_and_is_never_written_over() {
        const QJsonObject before = face();
        QVERIFY(before["mended"].toArray().isEmpty());
        QVERIFY(QFile::copy(truth_, sheet_));
        QFile file(sheet_);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray mended = file.readAll();

        QVERIFY(face()["mended"].toArray().contains("left_eye"));
        QVERIFY(face()["contours"] != before["contours"]);
        QVERIFY(face({"--uncorrected"})["contours"] == before["contours"]);
        const Run kept = lab({"faces", "--svg", folder_.path(), photo_});
        QCOMPARE(kept.code, 1);
        QVERIFY(kept.err.contains("is kept"));
        QFile after(sheet_);
        QVERIFY(after.open(QIODevice::ReadOnly));
        QCOMPARE(after.readAll(), mended);
    }

    void the_true_contours_improve_what_is_felt_and_moved_ones_do_not() {
        QVERIFY(QFile::copy(truth_, sheet_));
        const QString picture = folder_.filePath("difference.png");
        const Run better = lab({"correction", photo_, "--truth", truth_, "--out", picture});
        QVERIFY2(better.code == 0, better.err.constData());
        QVERIFY(better.err.contains("the correction improves what is felt"));
        QVERIFY(better.out.startsWith("feature,moved_percent,error_before_percent,error_after_percent\n"));
        QVERIFY(better.out.contains("left_eye,"));
        QVERIFY(!QImage(picture).isNull());

        auto moved = read_sheet(truth_.toStdString(), ContourSheet::Unit::pixel);
        QVERIFY(moved.ok());
        for (Contour& contour : moved->contours)
            contour = mapped(contour, [](Vec2 p) { return p + Vec2(0.0, 25.0); });
        QVERIFY(write_sheet(sheet_.toStdString(), *moved).ok());
        const Run worse = lab({"correction", photo_, "--truth", truth_});
        QVERIFY(worse.err.contains("the correction does not improve what is felt"));
    }

    void what_is_missing_is_said() {
        const Run none = lab({"correction", photo_});
        QCOMPARE(none.code, 1);
        QVERIFY(none.err.count('\n') == 1 && none.err.endsWith(".\n"));
        QCOMPARE(lab({"correction"}).code, 2);
        QFile sheet(sheet_);
        QVERIFY(sheet.open(QIODevice::WriteOnly) && sheet.write("<svg") > 0);
        sheet.close();
        QCOMPARE(lab({"correction", photo_}).code, 1);
        const Run faces = lab({"faces", photo_});
        QCOMPARE(faces.code, 1);
        QVERIFY(faces.err.contains("cannot be used, so the program's own are used"));
        QVERIFY(faces.out.contains("1 face"));
    }
};

QTEST_GUILESS_MAIN(CorrectionTest)
#include "correction_test.moc"
