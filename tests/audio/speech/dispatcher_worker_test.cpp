// SPDX-License-Identifier: Apache-2.0
#include "audio/speech/dispatcher_worker.hpp"
#include "audio/speech/spoken_voice.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QLocalServer>
#include <QLocalSocket>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace dispatcher_worker_test {

using namespace tp;

namespace {

/// A speech-dispatcher that says yes to everything but what it is told to refuse, and speaks when it is told to.
class FakeDispatcher : public QObject {
public:
    FakeDispatcher() {
        server_.listen(path());
        connect(&server_, &QLocalServer::newConnection, this, [this] {
            line_ = server_.nextPendingConnection();
            ++callers;
            connect(line_, &QLocalSocket::readyRead, this, [this] { hear(); });
        });
    }
    QString path() const { return folder_.filePath("speechd.sock"); }
    void send(const QByteArray& bytes) {
        line_->write(bytes);
        line_->flush();
    }
    void tell(int message, int code, const QByteArray& word) {
        const QByteArray each = QByteArray::number(code);
        send(each + '-' + QByteArray::number(message) + "\r\n" + each + "-1\r\n" + each + ' ' + word + "\r\n");
    }
    void hang_up() { line_->disconnectFromServer(); }
    bool connected() const { return line_ != nullptr; }

    int callers = 0; ///< until now
    QStringList commands, texts;
    QString refused;

private:
    void hear() {
        while (line_->canReadLine()) {
            const QString line = QString::fromUtf8(line_->readLine()).chopped(2);
            if (taking_ && line == ".") {
                taking_ = false;
                send("225-" + QByteArray::number(texts.size()) + "\r\n225 OK MESSAGE QUEUED\r\n");
            } else if (taking_) {
                texts << line;
            } else {
                commands << line;
                taking_ = line == "SPEAK" && refused != line;
                send(line == refused ? "300 ERR INTERNAL\r\n" : taking_ ? "230 OK RECEIVING DATA\r\n" : "200 OK\r\n");
            }
        }
    }
    QTemporaryDir folder_;
    QLocalServer server_;
    QLocalSocket* line_ = nullptr;
    bool taking_ = false;
};

struct Bench {
    FakeDispatcher dispatcher;
    DispatcherWorker worker{dispatcher.path().toStdString(), false};
    QSignalSpy found{&worker, &SpeechWorker::found};
    QSignalSpy failed{&worker, &SpeechWorker::failed};
    QSignalSpy finished{&worker, &SpeechWorker::finished};
    Bench() { worker.find_engine(); }
};

} // namespace

class DispatcherWorkerTest : public QObject {
    Q_OBJECT
private slots:
    void it_is_there_at_once_and_says_who_it_is() {
        Bench bench;
        QCOMPARE(bench.found.size(), 1);
        bench.worker.set_rate(-0.5);
        bench.worker.set_language("ko");
        QTRY_VERIFY(bench.dispatcher.commands.contains("SET SELF LANGUAGE ko"));
        QVERIFY(bench.dispatcher.commands.first().startsWith("SET SELF CLIENT_NAME "));
        QVERIFY(bench.dispatcher.commands.first().endsWith(":touchphoto:main"));
        QVERIFY(bench.dispatcher.commands.contains("SET SELF RATE -50"));
        QVERIFY(bench.dispatcher.commands.contains("SET SELF NOTIFICATION END ON"));
    }

    void a_text_has_ended_when_the_dispatcher_says_so() {
        Bench bench;
        bench.worker.speak(7, QString::fromUtf8("Große\nAugen."));
        QTRY_COMPARE(bench.dispatcher.texts, QStringList{QString::fromUtf8("Große Augen.")});
        bench.dispatcher.tell(1, 701, "BEGIN");
        bench.dispatcher.tell(99, 702, "END"); // of somebody else's
        bench.dispatcher.tell(1, 702, "END");
        QTRY_COMPARE(bench.finished.size(), 1);
        QCOMPARE(bench.finished[0][0].toULongLong(), quint64(7));
        QVERIFY(bench.failed.isEmpty());
    }

    void a_name_in_another_script_is_spoken_in_its_language() {
        Bench bench;
        bench.worker.set_language("de");
        bench.worker.speak(7, QString::fromUtf8("Anna und Иван, im Garten."));
        QTRY_COMPARE(bench.dispatcher.texts, QStringList({"Anna und ", QString::fromUtf8("Иван, "), "im Garten."}));
        QTRY_COMPARE(bench.dispatcher.commands.filter(QRegularExpression("LANGUAGE|SPEAK")).join('|'),
                     QString("SET SELF LANGUAGE de|SPEAK|SET SELF LANGUAGE ru|SPEAK|SET SELF LANGUAGE de|SPEAK"));
        for (int part = 1; part <= 3; ++part) {
            QVERIFY(bench.finished.isEmpty());
            bench.dispatcher.tell(part, 701, "BEGIN");
            bench.dispatcher.tell(part, 702, "END");
        }
        QTRY_COMPARE(bench.finished.size(), 1);
        QCOMPARE(bench.finished[0][0].toULongLong(), quint64(7));
    }

    void a_known_name_is_spoken_in_its_language_from_the_next_text_on() {
        Bench bench;
        bench.worker.set_language("de");
        bench.worker.set_name_languages({{"Giulia", "it"}});
        bench.worker.speak(1, "Giulia lacht.");
        QTRY_COMPARE(bench.dispatcher.texts, QStringList({"Giulia ", "lacht."}));
        bench.worker.set_name_languages({});
        bench.worker.speak(2, "Giulia lacht.");
        QTRY_COMPARE(bench.dispatcher.texts, QStringList({"Giulia ", "lacht.", "Giulia lacht."}));
        QTRY_COMPARE(bench.dispatcher.commands.filter(QRegularExpression("LANGUAGE|SPEAK")).join('|'),
                     QString("SET SELF LANGUAGE de|SET SELF LANGUAGE it|SPEAK|SET SELF LANGUAGE de|SPEAK|SPEAK"));
    }

    void names_come_from_the_voice_to_the_dispatcher_before_it_is_there_and_after() {
        FakeDispatcher dispatcher;
        qputenv("SPEECHD_ADDRESS", "unix_socket:" + QFile::encodeName(dispatcher.path()));
        {
            SpokenVoice voice;
            voice.set_language("de");
            voice.set_name_languages({{"Giulia", "it"}});
            voice.say("Giulia lacht.", Priority::message);
            QTRY_COMPARE(dispatcher.texts, QStringList({"Giulia ", "lacht."}));
            voice.set_name_languages({{"Luca", "it"}});
            voice.say("Giulia, Luca", Priority::fault);
            QTRY_COMPARE(dispatcher.texts, QStringList({"Giulia ", "lacht.", "Giulia, ", "Luca"}));
        }
        qunsetenv("SPEECHD_ADDRESS");
    }

    void one_that_spoke_and_went_away_is_looked_for_again() {
        FakeDispatcher dispatcher;
        qputenv("SPEECHD_ADDRESS", "unix_socket:" + QFile::encodeName(dispatcher.path()));
        {
            SpokenVoice voice;
            voice.say("left eye", Priority::message);
            QTRY_COMPARE(dispatcher.texts, QStringList{"left eye"});
            dispatcher.tell(1, 701, "BEGIN");
            dispatcher.tell(1, 702, "END");
            QTRY_VERIFY(!voice.busy());
            dispatcher.hang_up();
            QTRY_COMPARE(dispatcher.callers, 2);
            voice.say("lips", Priority::message);
            QTRY_COMPARE(dispatcher.texts, QStringList({"left eye", "lips"}));
        }
        qunsetenv("SPEECHD_ADDRESS");
    }

    void a_late_end_of_a_cancelled_text_does_not_end_the_next() {
        Bench bench;
        bench.worker.speak(1, "left eye");
        bench.worker.cancel();
        bench.worker.speak(2, "lips");
        QTRY_COMPARE(bench.dispatcher.texts, QStringList({"left eye", "lips"}));
        QVERIFY(bench.dispatcher.commands.contains("CANCEL SELF"));
        bench.dispatcher.tell(1, 703, "CANCELED");
        bench.dispatcher.tell(2, 701, "BEGIN");
        bench.dispatcher.tell(2, 702, "END");
        QTRY_VERIFY(!bench.finished.isEmpty());
        QCOMPARE(bench.finished.size(), 1);
        QCOMPARE(bench.finished[0][0].toULongLong(), quint64(2));
    }

    void two_refused_texts_are_a_mute_engine() {
        Bench bench;
        bench.dispatcher.refused = "SPEAK";
        bench.worker.speak(1, "left eye");
        QTRY_COMPARE(bench.finished.size(), 1);
        QVERIFY(bench.failed.isEmpty());
        bench.worker.speak(2, "lips");
        QTRY_COMPARE(bench.failed.size(), 1);
        QVERIFY(!bench.dispatcher.commands.contains("left eye")); // which would be a command there
        QCOMPARE(bench.finished.size(), 2);
    }

    void one_that_hangs_up_has_failed() {
        Bench bench;
        QTRY_VERIFY(bench.dispatcher.connected());
        bench.dispatcher.hang_up();
        QTRY_COMPARE(bench.failed.size(), 1);
        bench.worker.speak(1, "lips"); // nobody hears it, and nothing breaks
        QVERIFY(bench.finished.isEmpty());
    }

    void one_that_talks_nonsense_has_failed() {
        Bench bench;
        QTRY_VERIFY(bench.dispatcher.connected());
        bench.dispatcher.send("HTTP/1.1 200 OK\r\n");
        QTRY_COMPARE(bench.failed.size(), 1);
    }

    void where_there_is_none_it_says_so() {
        const QTemporaryDir folder;
        for (const QString& path : {folder.filePath("none.sock"), QString(200, 'x')}) {
            DispatcherWorker worker(path.toStdString(), false);
            const QSignalSpy failed(&worker, &SpeechWorker::failed);
            worker.find_engine();
            QCOMPARE(failed.size(), 1);
        }
    }

    void the_socket_is_where_its_own_library_looks() {
        qputenv("XDG_RUNTIME_DIR", "/run/user/7");
        QCOMPARE(DispatcherWorker::usual_socket(), std::string("/run/user/7/speech-dispatcher/speechd.sock"));
        qputenv("SPEECHD_ADDRESS", "unix_socket:/tmp/other.sock");
        QCOMPARE(DispatcherWorker::usual_socket(), std::string("/tmp/other.sock"));
        qunsetenv("SPEECHD_ADDRESS");
    }
};

} // namespace dispatcher_worker_test

TP_TEST(dispatcher_worker_test, DispatcherWorkerTest, event_loop)
#include "dispatcher_worker_test.moc"
