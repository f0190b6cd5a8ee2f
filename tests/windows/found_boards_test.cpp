// SPDX-License-Identifier: Apache-2.0
// Ports of Arduino boards as Windows keeps them, put into Wine's registry, found by a program for Windows.
#include <QProcess>
#include <QTest>

namespace {

constexpr const char* ports_class = "{4d36e978-e325-11ce-bfc1-08002be10318}";

QByteArray run(const QStringList& words) {
    const QStringList puller = qEnvironmentVariable("TP_BOARD_PULLER").split(';'); // Wine and the program
    QProcess process;
    process.start(puller.first(), words.isEmpty() ? QStringList{puller.last(), "boards"} : words);
    process.waitForFinished(-1);
    return process.exitCode() == 0 ? process.readAllStandardOutput() : "it failed";
}

/// As the system does where the device with that name is plugged in.
void plug_in(const QString& instance, const QString& port) {
    const QString key = "HKLM\\System\\CurrentControlSet\\Enum\\" + instance;
    run({"reg", "add", key, "/v", "ClassGUID", "/d", ports_class, "/f"});
    run({"reg", "add", key + "\\Device Parameters", "/v", "PortName", "/d", port, "/f"});
}

void unplug(const QString& instance) {
    run({"reg", "delete", "HKLM\\System\\CurrentControlSet\\Enum\\" + instance, "/f"});
}

} // namespace

class FoundBoardsTest : public QObject {
    Q_OBJECT
private slots:
    void arduino_boards_are_found_with_their_ports_and_serial_numbers() {
        const QString due = "USB\\VID_2341&PID_003E\\7523031393535120A0D1";
        const QString part = "USB\\VID_2A03&PID_003D&MI_00\\6&2A8C9D&0&0000";
        const QString other = "USB\\VID_0403&PID_6001\\A900";
        const QString printer = "USB\\VID_2341&PID_0001\\1234";
        plug_in(due, "COM12");
        plug_in(part, "COM31");
        plug_in(other, "COM13");
        plug_in(printer, "LPT1");
        QCOMPARE(run({}), QByteArray("COM12 7523031393535120A0D1\r\nCOM31 \r\n"));
        unplug(due);
        QCOMPARE(run({}), QByteArray("COM31 \r\n"));
        for (const QString& instance : {part, other, printer})
            unplug(instance);
        QCOMPARE(run({}), QByteArray());
    }
};

QTEST_GUILESS_MAIN(FoundBoardsTest)
#include "found_boards_test.moc"
