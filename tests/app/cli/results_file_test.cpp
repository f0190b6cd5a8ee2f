// SPDX-License-Identifier: Apache-2.0
#include "app/cli/batch_progress.hpp"
#include "app/cli/results_file.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace tp;

namespace {

const QByteArray one_line = "{\"faces\":[],\"photo\":\"one.jpg\"}";
const QByteArray two_line = "{\"faces\":[],\"photo\":\"zwei \\\"ä\\\".jpg\"}";
const QByteArray three_line = "{\"faces\":[],\"photo\":\"three\\nlines.jpg\"}";

} // namespace

class ResultsFileTest : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    std::filesystem::path path(const char* name) const { return folder_.filePath(name).toStdString(); }
    void put(const char* name, const QByteArray& bytes) const {
        QFile file(folder_.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    QByteArray get(const char* name) const {
        QFile file(folder_.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
    }

private slots:
    void lines_are_there_as_soon_as_they_are_appended() {
        auto results = ResultsFile::open(path("new.jsonl"));
        QVERIFY2(results.ok(), results.error().c_str());
        QCOMPARE(results->append("one.jpg", one_line), std::string());
        QCOMPARE(get("new.jsonl"), one_line + '\n');
        QVERIFY(results->holds("one.jpg"));
        QVERIFY(!results->holds("two.jpg"));
        QCOMPARE(results->sync(), std::string());
    }

    void cut_anywhere_only_the_cut_line_is_dropped() {
        const QByteArray lines = one_line + '\n' + two_line + '\n' + three_line + '\n';
        for (qsizetype cut = 0; cut <= lines.size(); ++cut) {
            const qsizetype whole = lines.left(cut).lastIndexOf('\n') + 1;
            put("cut.jsonl", lines.left(cut));
            auto results = ResultsFile::open(path("cut.jsonl"));
            QVERIFY2(results.ok(), results.error().c_str());
            QCOMPARE(get("cut.jsonl"), lines.left(whole));
            QCOMPARE(results->holds("one.jpg"), whole > one_line.size());
            QCOMPARE(results->holds("zwei \"ä\".jpg"), whole > one_line.size() + 1 + two_line.size());
            QCOMPARE(results->holds("three\nlines.jpg"), whole == lines.size());
            QCOMPARE(results->append("last.jpg", one_line), std::string());
            QCOMPARE(get("cut.jsonl"), lines.left(whole) + one_line + '\n');
        }
    }

    void another_kind_of_file_stays_as_it_was_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("a letter") << QByteArray("Dear Anna");
        QTest::newRow("a photograph") << QByteArray("\xFF\xD8\xFF\xE0\0\0JFIF", 10);
        QTest::newRow("a table") << QByteArray("photo,faces\none.jpg,1\n");
        QTest::newRow("other JSON") << QByteArray("{\"name\":\"one.jpg\"}\n");
        QTest::newRow("a list") << QByteArray("[1, 2]\n");
        QTest::newRow("an empty line") << one_line + "\n\n" + two_line + '\n';
        QTest::newRow("a cut line in the middle") << one_line.left(12) + '\n' + two_line + '\n';
        QTest::newRow("a line without an end") << "{\"photo\":\"" + QByteArray(17 << 20, 'a');
        QTest::newRow("a letter after results") << one_line + "\nDear Anna";
    }
    void another_kind_of_file_stays_as_it_was() {
        QFETCH(QByteArray, content);
        put("other", content);
        const std::string error = ResultsFile::open(path("other")).error();
        QVERIFY2(error.find("is not a result of faces --json") != std::string::npos, error.c_str());
        QCOMPARE(get("other"), content);
    }

    void where_nothing_can_be_written_a_sentence_says_so() {
        for (const std::filesystem::path& place :
             {path("no/such/folder.jsonl"), path(""), std::filesystem::path("/dev/full")}) {
            const std::string error = ResultsFile::open(place).error();
            QVERIFY2(error.starts_with("The results cannot be written to \""), error.c_str());
            QVERIFY2(error.ends_with('.'), error.c_str());
        }
    }

    void two_batches_cannot_write_to_one_file() {
        {
            const auto first = ResultsFile::open(path("both.jsonl"));
            QVERIFY(first.ok());
            const std::string error = ResultsFile::open(path("both.jsonl")).error();
            QVERIFY2(error.starts_with("Another batch is writing to"), error.c_str());
        }
        QVERIFY(ResultsFile::open(path("both.jsonl")).ok());
    }

    void time_left_is_said_in_words() {
        QCOMPARE(time_left(0, 10, 5.0), std::string());
        QCOMPARE(time_left(10, 10, 5.0), std::string());
        QCOMPARE(time_left(1, 2, 0.01), std::string("about 1 s left"));
        QCOMPARE(time_left(10, 40, 20.0), std::string("about 60 s left"));
        QCOMPARE(time_left(1, 1001, 0.6), std::string("about 10 min left"));
        QCOMPARE(time_left(100, 1'000'100, 2.0), std::string("about 6 h left"));
        BatchProgress progress(2);
        QVERIFY(progress.next("a.jpg").starts_with("1 of 2: a.jpg, about "));
        QCOMPARE(progress.next("b.jpg"), std::string("2 of 2: b.jpg"));
    }
};

QTEST_GUILESS_MAIN(ResultsFileTest)
#include "results_file_test.moc"
