// SPDX-License-Identifier: Apache-2.0
#include "core/packing/gzip.hpp"
#include "test_program.hpp"

#include <QProcess>
#include <QTest>

#include <random>

namespace gzip_test {

using namespace tp;

namespace {

std::string some_bytes(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::string bytes;
    for (std::size_t i = 0; i < count; ++i)
        bytes += static_cast<char>(i % 3 == 0 ? random() % 256 : 'a');
    return bytes;
}

} // namespace

class GzipTest : public QObject {
    Q_OBJECT
private slots:
    void bytes_come_back_as_they_were() {
        for (const std::size_t count : {0U, 1U, 1000U, 65536U, 65537U, 300'000U}) {
            const std::string bytes = some_bytes(count, 1);
            const auto back = gunzipped(gzipped(bytes), count);
            QVERIFY2(back.ok(), back.error().c_str());
            QVERIFY(*back == bytes);
        }
        QVERIFY(gzipped(some_bytes(300'000, 1)).size() < 250'000);
    }
    /// RFC 1952: no flags, no time, no system.
    void the_head_says_nothing_of_when_and_where() {
        const std::string head = gzipped("x").substr(0, 10);
        QCOMPARE(QByteArray::fromStdString(head).toHex(), QByteArray("1f8b08000000000000ff"));
    }
    void another_program_reads_it() {
        QProcess gzip;
        gzip.start("gzip", {"-dc"});
        QVERIFY(gzip.waitForStarted());
        const std::string bytes = some_bytes(100'000, 2);
        gzip.write(QByteArray::fromStdString(gzipped(bytes)));
        gzip.closeWriteChannel();
        QVERIFY(gzip.waitForFinished());
        QCOMPARE(gzip.exitCode(), 0);
        QVERIFY(gzip.readAllStandardOutput().toStdString() == bytes);
    }
    void one_that_was_cut_off_anywhere_is_said() {
        const std::string file = gzipped(some_bytes(500, 3));
        for (std::size_t cut = 0; cut < file.size(); ++cut)
            QCOMPARE(gunzipped(file.substr(0, cut), 1000).error(), std::string("it ends too soon."));
    }
    void a_changed_byte_is_said() {
        const std::string bytes = some_bytes(500, 4), file = gzipped(bytes);
        int unsaid = 0; // of the last byte before the checksum some bits mean nothing
        for (std::size_t i = 10; i < file.size(); ++i) {
            std::string changed = file;
            changed[i] = static_cast<char>(changed[i] ^ 0x10);
            const auto back = gunzipped(changed, 1000);
            QVERIFY2(!back || *back == bytes, std::to_string(i).c_str());
            unsaid += back.ok();
        }
        QVERIFY(unsaid <= 1);
        QCOMPARE(gunzipped("this is no such file at all", 1000).error(), std::string("it is damaged."));
    }
    void what_stands_behind_its_end_is_said() {
        const std::string file = gzipped("x");
        QCOMPARE(gunzipped(file + "y", 1000).error(), std::string("there is something behind its end."));
        QVERIFY(!gunzipped(file + file, 1000).ok());
    }
    void no_more_is_unpacked_than_asked_for() {
        const std::string file = gzipped(std::string(10'000'000, '0'));
        QVERIFY(file.size() < 20'000);
        QCOMPARE(gunzipped(file, 9'999'999).error(), std::string("it holds more than such a file may."));
        QVERIFY(gunzipped(file, 10'000'000).ok());
    }
};

} // namespace gzip_test

TP_TEST(gzip_test, GzipTest, event_loop)
#include "gzip_test.moc"
