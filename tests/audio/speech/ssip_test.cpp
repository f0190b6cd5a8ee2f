// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/ssip.hpp"
#include "ssip_check.hpp"
#include "test_program.hpp"

#include <QTest>

#include <string>
#include <vector>

namespace ssip_test {

using namespace tp;

class SsipTest : public QObject {
    Q_OBJECT
private slots:
    void replies_are_put_together_from_any_pieces() {
        const std::string sent = "208 OK CLIENT NAME SET\r\n225-21\r\n225 OK MESSAGE QUEUED\r\n701-21\r\n701-4\r\n701 BEGIN\r\n";
        for (std::size_t piece = 1; piece <= sent.size(); ++piece) {
            SsipReader reader;
            std::vector<SsipReply> replies;
            for (std::size_t at = 0; at < sent.size(); at += piece)
                QVERIFY(reader.read(std::string_view(sent).substr(at, piece), replies));
            QCOMPARE(replies.size(), std::size_t(3));
            QCOMPARE(replies[0].code, 208);
            QVERIFY(!replies[0].is_event());
            QCOMPARE(replies[1].code, 225);
            QCOMPARE(replies[1].lines, (std::vector<std::string>{"21", "OK MESSAGE QUEUED"}));
            QCOMPARE(replies[2].lines, (std::vector<std::string>{"21", "4", "BEGIN"}));
            QVERIFY(replies[2].is_event());
        }
    }

    void what_is_no_ssip_is_refused_for_good_data() {
        QTest::addColumn<QString>("sent");
        QTest::newRow("words") << "hello\r\n";
        QTest::newRow("short") << "20\r\n";
        QTest::newRow("nothing") << "\r\n";
        QTest::newRow("another code within a reply") << "225-21\r\n226 OK\r\n";
        QTest::newRow("no space") << "225:OK\r\n";
        QTest::newRow("endless line") << QString(SsipReader::most_bytes + 1, '2');
        QTest::newRow("endless reply") << QString("700-more\r\n").repeated(SsipReader::most_bytes / 8);
    }
    void what_is_no_ssip_is_refused_for_good() {
        QFETCH(QString, sent);
        SsipReader reader;
        std::vector<SsipReply> replies;
        QVERIFY(!reader.read(sent.toStdString(), replies));
        QVERIFY(!reader.read("208 OK\r\n", replies));
        QVERIFY(replies.empty());
        QCOMPARE(test::complaint_about_ssip(sent.toStdString()), std::string());
    }

    void a_text_is_one_line_and_cannot_end_itself() {
        QCOMPARE(ssip_text("One face."), std::string("One face.\r\n.\r\n"));
        QCOMPARE(ssip_text("."), std::string("..\r\n.\r\n"));
        QCOMPARE(ssip_text("one\r\n.\r\nSTOP ALL"), std::string("one  .  STOP ALL\r\n.\r\n"));
        QCOMPARE(ssip_text(""), std::string("\r\n.\r\n"));
    }
};

} // namespace ssip_test

TP_TEST(ssip_test, SsipTest, event_loop)
#include "ssip_test.moc"
