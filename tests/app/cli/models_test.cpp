// SPDX-License-Identifier: Apache-2.0
// touchphoto-lab models as a shell sees it.
#include "faces/models/model_catalog.hpp"
#include "lab_process.hpp"
#include "places.hpp"

#include <QTest>

using namespace tp;

class ModelsTest : public QObject {
    Q_OBJECT
private slots:
    void list_names_each_net_with_purpose_bytes_and_licence() {
        const Run run = lab({"models", "list"});
        QCOMPARE(run.code, 0);
        QCOMPARE(run.err, QByteArray());
        const QByteArrayList lines = run.out.split('\n');
        const auto models = embedded_models();
        QCOMPARE(lines.size(), static_cast<qsizetype>(models.size()) + 1); // the last is empty
        for (std::size_t i = 0; i < models.size(); ++i) {
            const EmbeddedModelFacts& model = models[i];
            const QByteArray& line = lines[static_cast<qsizetype>(i)];
            QVERIFY2(line.startsWith(model.name), line.constData());
            QVERIFY2(line.endsWith(QByteArray(model.purpose) + ", " + QByteArray::number(model.bytes) +
                                   " bytes, " + model.licence),
                     line.constData());
        }
    }

    void check_says_of_each_choice_that_it_can_be_used() {
        const Run run = lab({"models", "check"});
        QCOMPARE(run.code, 0);
        QCOMPARE(run.err, QByteArray());
        QCOMPARE(run.out, QByteArray("embedded: loads and gives what the program expects\n"
                                     "yunet: loads and gives what the program expects\n"
                                     "mesh: loads and gives what the program expects\n"));
    }

    void faces_names_the_choices_where_a_name_is_none_of_them_data() {
        QTest::addColumn<QString>("option");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("says");
        const QString net = tp::test::in_source("resources/models/yunet.onnx");
        for (const QString& name : {QString("magic"), net}) {
            QTest::addRow("detector %s", qPrintable(name))
                << "--detector" << name
                << QByteArray("There is no detector named \"" + name.toUtf8() +
                              "\": choose \"embedded\" or \"yunet\".\n");
            QTest::addRow("model %s", qPrintable(name))
                << "--model" << name
                << QByteArray("There is no model named \"" + name.toUtf8() +
                              "\": choose \"embedded\" or \"mesh\".\n");
        }
    }
    void faces_names_the_choices_where_a_name_is_none_of_them() {
        QFETCH(QString, option);
        QFETCH(QString, name);
        QFETCH(QByteArray, says);
        const Run run =
            lab({"faces", option, name, tp::test::in_source("resources/samples/anna_smiling.jpg")});
        QCOMPARE(run.code, 1);
        QCOMPARE(run.out, QByteArray());
        QCOMPARE(run.err, says);
    }

    void wrong_usage_is_code_2_data() {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("nothing") << QStringList{"models"};
        QTest::newRow("no such word") << QStringList{"models", "eat"};
        QTest::newRow("fetch") << QStringList{"models", "fetch"};
        QTest::newRow("fetch of a net") << QStringList{"models", "fetch", "yunet", "--yes"};
    }
    void wrong_usage_is_code_2() {
        QFETCH(QStringList, words);
        const Run run = lab(words);
        QCOMPARE(run.code, 2);
        QCOMPARE(run.out, QByteArray());
        QVERIFY2(run.err.startsWith("Say what to do with the models: list or check."), run.err.constData());
    }
    void too_many_words_are_code_2() {
        for (const char* what : {"list", "check"})
            QCOMPARE(lab({"models", what, "yunet"}).code, 2);
    }
    void help_names_what_there_is() {
        const Run run = lab({"models", "--help"});
        QCOMPARE(run.code, 0);
        QCOMPARE(run.out, QByteArray("touchphoto-lab models list\ntouchphoto-lab models check\n"));
    }
};

QTEST_GUILESS_MAIN(ModelsTest)
#include "models_test.moc"
