// SPDX-License-Identifier: Apache-2.0
#include "lab_parts.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QImage>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>

namespace lab_scene_test {

using namespace tp;

class LabSceneTest : public QObject {
    Q_OBJECT
private slots:
    void the_field_is_that_of_the_scene_and_in_words_too() {
        LabParts bench;
        QSignalSpy painted(&bench.scene, &LabScene::fieldChanged);
        bench.scene.setFieldScale(1.0);
        QTRY_VERIFY_WITH_TIMEOUT(!painted.isEmpty(), patience_ms);
        QCOMPARE(bench.scene.field().size(), QSize(220, 160 + bench.scene.legendPixels()));
        const QImage circle = bench.scene.field();
        bench.scene.choose(1);
        QTRY_VERIFY_WITH_TIMEOUT(bench.scene.field() != circle, patience_ms);
        QVERIFY(bench.scene.fieldWords().contains("from 0 to 0.80 newtons"));
    }

    void a_photograph_is_felt_and_one_that_cannot_be_is_told() {
        LabParts bench;
        bench.scene.choose(3);
        QVERIFY(bench.last().startsWith("There is no photograph yet."));
        bench.scene.openPhoto(QUrl("https://example.org/a.jpg"));
        QVERIFY(bench.last().startsWith("Only a photograph that is a file"));
        bench.scene.openPhoto(QUrl::fromLocalFile("/nowhere/face.jpg"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.last().startsWith("face.jpg: "), patience_ms);
        QCOMPARE(bench.scene.current(), 0);
        bench.scene.openPhoto(QUrl::fromLocalFile(tp::test::in_source("resources/samples/anna_smiling.jpg")));
        QTRY_COMPARE_WITH_TIMEOUT(bench.scene.current(), 3, 120000);
        QVERIFY2(bench.last().startsWith("anna_smiling.jpg: "), qPrintable(bench.last()));
        QVERIFY(bench.scene.flat().lines.size() >= 5);
        QCOMPARE(bench.scene.names()[3], QString("Photograph anna_smiling.jpg"));
    }

    void another_scene_and_another_law_are_rendered_anew() {
        LabParts bench;
        QSignalSpy rendered(&bench.scene, &LabScene::rendered);
        bench.scene.choose(1);
        QCOMPARE(bench.last(), QString("Triangle, 50 mm high."));
        bench.tuning.chooseLaw(1);
        bench.tuning.setNumber("mass", 0.3, "Mass"); // is not felt as another scene
        QCOMPARE(rendered.size(), 2);
        for (const int index : {-1, 99})
            bench.scene.choose(index);
        bench.activity.become(LabActivity::Replaying);
        bench.scene.choose(2);
        bench.scene.openPhoto(QUrl::fromLocalFile("/nowhere/face.jpg"));
        QVERIFY(bench.last().startsWith("Nothing can be changed during a replay."));
        QCOMPARE(bench.scene.current(), 1);
        QCOMPARE(rendered.size(), 2);
    }
    void a_photograph_that_is_not_wanted_any_more_does_not_come() {
        LabParts bench;
        QVERIFY(!bench.scene.cancel());
        bench.scene.openPhoto(QUrl::fromLocalFile("/nowhere/face.jpg"));
        QVERIFY(bench.scene.cancel());
        QTest::qWait(0);
        QCOMPARE(bench.last(), QString("Looking for faces in face.jpg."));
    }
};

} // namespace lab_scene_test

TP_TEST(lab_scene_test, LabSceneTest, window)
#include "lab_scene_test.moc"
