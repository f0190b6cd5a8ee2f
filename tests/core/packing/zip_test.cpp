// SPDX-License-Identifier: Apache-2.0
#include "core/packing/zip.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace zip_test {

using namespace tp;

namespace {

std::string zip_of_two() {
    std::string file;
    ZipWriter zip([&](std::string_view bytes) {
        file += bytes;
        return std::string();
    });
    const std::string text(50'000, 'a');
    if (!zip.add("study/sittings.csv", text).empty() || !zip.add("study/paths/x.gz", text, true).empty() ||
        !zip.close().empty())
        qFatal("no zip");
    return file;
}

} // namespace

class ZipTest : public QObject {
    Q_OBJECT
private slots:
    void another_program_reads_it() {
        QTemporaryDir dir;
        QFile file(dir.filePath("x.zip"));
        const std::string bytes = zip_of_two();
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        file.close();
        QProcess python;
        python.start(
            "/usr/bin/python3",
            {"-c",
             "import sys, zipfile\n"
             "z = zipfile.ZipFile(sys.argv[1])\n"
             "assert z.testzip() is None\n"
             "for i in z.infolist(): print(i.filename, i.file_size, i.compress_type, i.date_time[0], "
             "oct(i.external_attr >> 16), set(z.read(i)) == {97})",
             file.fileName()});
        QVERIFY(python.waitForFinished());
        QCOMPARE(python.readAllStandardError(), QByteArray());
        QCOMPARE(python.readAllStandardOutput(), QByteArray("study/sittings.csv 50000 8 1980 0o100644 True\n"
                                                            "study/paths/x.gz 50000 0 1980 0o100644 True\n"));
    }
    void a_name_in_any_script_is_read_as_it_was() {
        QTemporaryDir dir;
        std::string bytes;
        ZipWriter zip([&](std::string_view part) {
            bytes += part;
            return std::string();
        });
        QVERIFY(zip.add("연구/größe.csv", "x").empty() && zip.close().empty());
        QFile file(dir.filePath("x.zip"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        file.close();
        QProcess python;
        python.start("/usr/bin/python3",
                     {"-c",
                      "import sys, zipfile\n"
                      "sys.stdout.buffer.write(zipfile.ZipFile(sys.argv[1]).namelist()[0].encode())",
                      file.fileName()});
        QVERIFY(python.waitForFinished());
        QCOMPARE(python.readAllStandardOutput(), QByteArray("연구/größe.csv"));
    }
    void the_same_files_are_the_same_bytes_in_every_zone() {
        const std::string here = zip_of_two();
        qputenv("TZ", "Asia/Seoul");
        ::tzset();
        QVERIFY(zip_of_two() == here);
        QVERIFY(here.size() < 51'000);
    }
    void a_full_disk_is_said() {
        int left = 1;
        ZipWriter zip([&](std::string_view) { return std::string(left-- > 0 ? "" : "the disk is full."); });
        std::string problem;
        for (int i = 0; i < 100 && problem.empty(); ++i)
            problem = zip.add("f" + std::to_string(i), std::string(10'000, 'b'), true);
        QCOMPARE(problem, std::string("the disk is full."));
        ZipWriter late([&](std::string_view) { return std::string("the disk is full."); });
        QCOMPARE(late.add("f", "x"), std::string());
        QCOMPARE(late.close(), std::string("the disk is full."));
    }
};

} // namespace zip_test

TP_TEST(zip_test, ZipTest, event_loop)
#include "zip_test.moc"
