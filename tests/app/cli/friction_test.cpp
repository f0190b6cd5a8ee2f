// SPDX-License-Identifier: Apache-2.0
#include "lab_process.hpp"

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

class FrictionVerbTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }
    QString scene() const {
        return written(
            path("scene.svg"),
            "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' viewBox='0 0 100 60'>"
            "<path id='line' d='M 10 30 L 90 30'/><circle id='ring' cx='50' cy='30' r='20'/></svg>");
    }
    Run friction(const QStringList& more) const {
        return lab(QStringList{"friction", "--scene", scene(), "--out", path("map.png")} + more);
    }

private slots:
    void initTestCase() { QVERIFY(folder_.isValid()); }
    void init() { QFile::remove(path("map.png")); }

    void a_scene_becomes_a_grey_picture_true_to_scale() {
        const Run run = friction({"--dots", "4", "--texture", "ring", "--width", "3"});
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY(run.out.isEmpty() && run.err.isEmpty());
        const QImage map(path("map.png"));
        QVERIFY(map.size() == QSize(400, 240) && map.format() == QImage::Format_Grayscale8);
        QVERIFY(map.dotsPerMeterX() == 4000 && map.dotsPerMeterY() == 4000);
        const auto grey = [&](double x, double y) { return qGray(map.pixel(int(4 * x), int(4 * y))); };
        QVERIFY(grey(20.1, 30.1) > 245 && grey(20.1, 33) == 0 &&
                grey(1, 1) == 0);                                // the line, x right, y down
        QVERIFY(grey(50.1, 10.1) > 245);                         // the ring
        QVERIFY(grey(50.1, 20.1) > 90 && grey(51.1, 20.1) < 10); // a stripe in it
    }

    void choices_change_the_map() {
        const auto map = [&](const QStringList& more) {
            const Run run = friction(more);
            return run.code == 0 ? QImage(path("map.png")) : QImage();
        };
        const QImage usual = map({});
        QVERIFY(usual.width() == 1000 && map({}) == usual);
        for (const QStringList& more : {QStringList{"--ridge", "flat"},
                                        {"--ridge", "tent"},
                                        {"--width", "5"},
                                        {"--strength", "0.5"},
                                        {"--texture", "ring"}})
            QVERIFY(map(more).size() == usual.size() && map(more) != usual);
        const QImage striped = map({"--texture", "ring"});
        for (const QStringList& more : {QStringList{"--stripes", "3"}, {"--stripe-strength", "0.9"}})
            QVERIFY(map(QStringList{"--texture", "ring"} + more) != striped);
    }

    void wrong_usage_is_code_2_data() {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("no scene") << QStringList{"friction", "--out", "a.png"};
        QTest::newRow("no picture") << QStringList{"friction", "--scene", "a.svg"};
        QTest::newRow("a picture that changes greys")
            << QStringList{"friction", "--scene", "a.svg", "--out", "a.jpg"};
        const QStringList most{"friction", "--scene", "a.svg", "--out", "a.png"};
        for (const QStringList& more : {QStringList{"--ridge", "steep"},
                                        {"--width", "0"},
                                        {"--width", "wide"},
                                        {"--strength", "1.5"},
                                        {"--dots", "-3"},
                                        {"--stripes", "nan"},
                                        {"--stripe-strength", "2"},
                                        {"more"}})
            QTest::newRow(qPrintable(more.join(' '))) << most + more;
    }
    void wrong_usage_is_code_2() {
        QFETCH(QStringList, words);
        const Run run = lab(words);
        QCOMPARE(run.code, 2);
        QVERIFY(run.out.isEmpty() && run.err.size() > 20);
    }

    void bad_input_is_one_sentence_and_no_picture_data() {
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("no such texture") << QStringList{"--texture", "ring,nose"} << QByteArray("\"nose\"");
        QTest::newRow("an open one") << QStringList{"--texture", "line"} << QByteArray("it has \"ring\"");
        QTest::newRow("too many dots") << QStringList{"--dots", "500"} << QByteArray("fewer dots");
        QTest::newRow("ridges between dots") << QStringList{"--dots", "0.5"} << QByteArray("wider ridge");
        QTest::newRow("no such scene") << QStringList{"--scene", "missing.svg"} << QByteArray("missing.svg");
        QTest::newRow("no place for it")
            << QStringList{"--out", "/no/such/folder/map.png"} << QByteArray("map.png");
    }
    void bad_input_is_one_sentence_and_no_picture() {
        QFETCH(QStringList, more);
        QFETCH(QByteArray, says);
        const Run run = friction(more);
        QCOMPARE(run.code, 1);
        QVERIFY2(is_one_sentence(run.err) && run.err.contains(says), run.err.constData());
        QVERIFY(run.out.isEmpty() && !QFile::exists(path("map.png")));
    }

    void a_scene_without_a_line_is_refused() {
        const QString empty =
            written(path("empty.svg"), "<svg xmlns='http://www.w3.org/2000/svg' width='9mm' "
                                       "height='9mm' viewBox='0 0 9 9'/>");
        const Run run = friction({"--scene", empty});
        QVERIFY2(run.code == 1 && is_one_sentence(run.err), run.err.constData());
    }
};

QTEST_APPLESS_MAIN(FrictionVerbTest)
#include "friction_test.moc"
