// SPDX-License-Identifier: Apache-2.0
#include "app/photo/scene/extra_features.hpp"
#include "test_program.hpp"

#include <QTest>

namespace extra_features_test {

using namespace tp;

namespace {

Extraction photo() {
    const auto line = [](const char* name) { return contour_through(name, {{0, 0}, {1, 1}}, false); };
    Face face;
    face.contours = {line(feature::left_eye), line(feature::outline)};
    face.extras = {line(feature::left_brow), line(feature::right_brow), line(feature::nose),
                   line(feature::left_iris)};
    Extraction extraction;
    extraction.faces = {face, face};
    return extraction;
}

QStringList names(const Face& face) {
    QStringList list;
    for (const Contour& contour : face.contours)
        list << QString::fromStdString(contour.name);
    return list;
}

} // namespace

class ExtraFeaturesTest : public QObject {
    Q_OBJECT
private slots:
    void nothing_is_added_unasked() {
        QCOMPARE(names(with_extras(photo(), {}).faces[1]), names(photo().faces[1]));
        const auto none = extra_features_named("");
        QVERIFY(none.ok() && !none->brows && !none->nose && !none->irises);
    }

    void one_by_one_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QStringList>("added");
        QTest::newRow("brows") << "brows" << QStringList{"left_brow", "right_brow"};
        QTest::newRow("nose") << "nose" << QStringList{"nose"};
        QTest::newRow("irises") << "irises" << QStringList{"left_iris"};
        QTest::newRow("two") << "irises,nose" << QStringList{"nose", "left_iris"};
    }
    void one_by_one() {
        QFETCH(QString, words);
        QFETCH(QStringList, added);
        const auto chosen = extra_features_named(words.toStdString());
        QVERIFY(chosen.ok());
        for (const Face& face : with_extras(photo(), *chosen).faces)
            QCOMPARE(names(face), names(photo().faces[0]) + added);
    }

    void what_a_person_took_away_stays_away() {
        Extraction mended = photo();
        mended.faces[0].mended = {feature::nose};
        QCOMPARE(names(with_extras(mended, {.nose = true}).faces[0]), names(photo().faces[0]));
        QVERIFY(names(with_extras(mended, {.nose = true}).faces[1]).contains("nose"));
    }

    void what_a_person_placed_stays() {
        Extraction mended = photo();
        mended.faces[0].contours.push_back(contour_through(feature::nose, {{5, 5}, {6, 6}}, false));
        const Face face = with_extras(mended, {.nose = true}).faces[0];
        QCOMPARE(names(face).count("nose"), 1);
        QCOMPARE(start_of(face.contours.back().pieces.front()), Vec2(5, 5));
    }

    void other_words_are_named() {
        const auto wrong = extra_features_named("nose,ears");
        QVERIFY(!wrong.ok());
        QCOMPARE(wrong.error(),
                 std::string("\"ears\" cannot be added to a face; brows, nose and irises can."));
    }
};

} // namespace extra_features_test

TP_TEST(extra_features_test, ExtraFeaturesTest, nothing)
#include "extra_features_test.moc"
