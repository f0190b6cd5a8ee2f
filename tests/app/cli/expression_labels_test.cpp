// SPDX-License-Identifier: Apache-2.0
#include "app/cli/expression_labels.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace tp;

class ExpressionLabelsTest : public QObject {
    Q_OBJECT
private slots:
    void names_say_person_and_expression_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("person");
        QTest::addColumn<QString>("expression");
        QTest::newRow("photograph") << "anna_sad.jpg"
                                    << "anna"
                                    << "sad";
        QTest::newRow("in a folder_sad") << "a_sad/b/ben_angry.PNG"
                                         << "ben"
                                         << "angry";
        QTest::newRow("drawn contours") << "anna_surprised.truth.svg"
                                        << "anna"
                                        << "surprised";
        QTest::newRow("a phone's photograph") << "anna_sad.HEIC"
                                              << "anna"
                                              << "sad";
        QTest::newRow("found contours") << "anna_smiling.jpg.contours.svg"
                                        << "anna"
                                        << "smiling";
        QTest::newRow("two underscores") << "aunt_anna_neutral.webp"
                                         << "aunt_anna"
                                         << "neutral";
        QTest::newRow("a dot in the name") << "dr. no_sad.jpg"
                                           << "dr. no"
                                           << "sad";
        QTest::newRow("a number") << "002_08.jpg"
                                  << "002"
                                  << "";
        QTest::newRow("two people") << "ben_and_clara.jpg"
                                    << "ben_and"
                                    << "";
        QTest::newRow("no underscore") << "sad.jpg"
                                       << "sad"
                                       << "";
        QTest::newRow("another ending") << "anna_sad.txt"
                                        << "anna"
                                        << "";
        QTest::newRow("no name") << ".jpg"
                                 << ".jpg"
                                 << "";
    }
    void names_say_person_and_expression() {
        QFETCH(QString, file);
        QFETCH(QString, person);
        QFETCH(QString, expression);
        const ExpressionLabel label = ExpressionLabels().of(file.toStdString());
        QCOMPARE(QString::fromStdString(label.person), person);
        QCOMPARE(label.shown ? std::string(name_of(*label.shown)) : "", expression.toStdString());
    }

    void a_table_goes_before_names() {
        const auto labels = ExpressionLabels::from_csv("\xEF\xBB\xBFphoto,note,expression,person\r\n"
                                                       "002_08.jpg,\"a \"\"big\"\" one, yes\",smiling,\r\n"
                                                       "x/anna_sad.jpg,,angry,Anna\n"
                                                       "\n"
                                                       "\"a,b_1.jpg\",,neutral,");
        QVERIFY2(labels.ok(), labels.error().c_str());
        const auto says = [&](const char* file, const char* person, std::optional<Expression> shown) {
            const ExpressionLabel label = labels.value().of(file);
            return label.person == person && label.shown == shown;
        };
        QVERIFY(says("/photos/002_08.jpg", "002", Expression::smiling)); // by its name alone
        QVERIFY(says("x/anna_sad.jpg", "Anna", Expression::angry));      // by its path
        QVERIFY(says("y/anna_sad.jpg", "anna", Expression::sad));        // another file
        QVERIFY(says("a,b_1.jpg", "a,b", Expression::neutral));
    }

    void a_bad_table_is_a_sentence_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("empty") << QByteArray() << QByteArray("first line");
        QTest::newRow("no heading") << QByteArray("anna.jpg,sad\n") << QByteArray("first line");
        QTest::newRow("no such expression")
            << QByteArray("photo,expression\na.jpg,sad\nb.jpg,glad\n") << QByteArray("Line 3 says \"glad\"");
        QTest::newRow("a column too few")
            << QByteArray("photo,expression\na.jpg\n") << QByteArray("Line 2 has 1 column");
        QTest::newRow("an open quotation")
            << QByteArray("photo,expression\n\"a.jpg,sad\n") << QByteArray("quotation mark");
    }
    void a_bad_table_is_a_sentence() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, says);
        const std::string error = ExpressionLabels::from_csv(text.toStdString()).error();
        QVERIFY2(error.ends_with('.') && QByteArray::fromStdString(error).contains(says), error.c_str());
    }

    void a_file_that_cannot_be_read_is_a_sentence() {
        QTemporaryDir folder;
        for (const QString& name : {folder.filePath("none.csv"), folder.path(), QString("/dev/zero")}) {
            const std::string error = ExpressionLabels::read(name.toStdString()).error();
            QVERIFY2(error.find("cannot be read") != std::string::npos, error.c_str());
        }
        QFile file(folder.filePath("labels.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("photo,expression\na.jpg,glad\n") > 0);
        file.close();
        QVERIFY(ExpressionLabels::read(file.fileName().toStdString()).error().find("labels.csv: Line 2") !=
                std::string::npos);
    }
};

QTEST_APPLESS_MAIN(ExpressionLabelsTest)
#include "expression_labels_test.moc"
