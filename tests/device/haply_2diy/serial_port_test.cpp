// SPDX-License-Identifier: Apache-2.0
// The line to a board, at a pseudo-terminal.
#include "device/haply_2diy/serial_port.hpp"

#include <QTemporaryFile>
#include <QTest>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <string>
#include <sys/ioctl.h>
#include <termios.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace tp;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// What is at the board's end.
struct Terminal {
    int end = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    std::string path;

    Terminal() {
        grantpt(end);
        unlockpt(end);
        path = ptsname(end);
    }
    ~Terminal() { close(); }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    void close() {
        if (end >= 0)
            ::close(std::exchange(end, -1));
    }
    bool say(const Bytes& bytes) const {
        return ::write(end, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
    }
    Bytes heard(std::size_t count) const {
        Bytes bytes(count);
        for (std::size_t at = 0; at < count;) { // CTest ends a test that waits for ever
            const ssize_t got = ::read(end, bytes.data() + at, count - at);
            if (got <= 0)
                return {};
            at += static_cast<std::size_t>(got);
        }
        return bytes;
    }
    std::unique_ptr<SerialPort> port() const {
        auto opened = open_serial_port(path, "board");
        return opened.ok() ? std::move(opened).value() : nullptr;
    }
};

/// The next bytes; those of a test are there when it asks.
Bytes read_of(SerialPort& port) {
    std::array<std::uint8_t, 64> bytes{};
    const int got = port.read(bytes, 0);
    return got > 0 ? Bytes(bytes.begin(), bytes.begin() + got) : Bytes{};
}

bool is_exclusive(int descriptor) {
    int exclusive = 0;
    return ioctl(descriptor, TIOCGEXCL, &exclusive) == 0 && exclusive != 0;
}

} // namespace

class SerialPortTest : public QObject {
    Q_OBJECT
private slots:
    /// Also those that mean an end of a line, an interruption or a pause to a terminal.
    void bytes_go_both_ways_as_they_are() {
        const Terminal terminal;
        const auto port = terminal.port();
        QVERIFY(port);
        const Bytes bytes{0x00, 0x03, 0x04, 0x0A, 0x0D, 0x11, 0x13, 0x1A, 0x1C, 0x7F, 0x80, 0xFF};
        QVERIFY(port->write(bytes));
        QVERIFY(terminal.heard(bytes.size()) == bytes);
        QVERIFY(terminal.say(bytes));
        QVERIFY(read_of(*port) == bytes);
        QVERIFY(read_of(*port).empty()); // no echo
        QVERIFY(port->write(Bytes{7}));
        QVERIFY(terminal.heard(1) == Bytes{7});
        QVERIFY(terminal.say({8}));
        QVERIFY(read_of(*port) == Bytes{8});
    }
    /// What the system does not take at once it takes when the board has read.
    void more_than_the_system_keeps_goes_out_too() {
        const Terminal terminal;
        auto port = terminal.port();
        QVERIFY(port);
        Bytes bytes(300'000);
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<std::uint8_t>(i * i >> 8u);
        Bytes heard;
        std::thread reader([&] { heard = terminal.heard(bytes.size()); });
        const bool written = port->write(bytes);
        port.reset(); // so that the reader ends in any case
        reader.join();
        QVERIFY(written && heard == bytes);
    }
    void a_read_that_waits_ends_with_the_first_byte() {
        const Terminal terminal;
        const auto port = terminal.port();
        QVERIFY(port);
        std::atomic<bool> reading{false};
        std::thread board([&] {
            reading.wait(false);
            terminal.say({5});
        });
        std::array<std::uint8_t, 8> bytes{};
        reading.store(true);
        reading.notify_one();
        const int got = port->read(bytes, 600'000); // CTest ends a test that waits so long
        board.join();
        QCOMPARE(got, 1);
        QCOMPARE(int(bytes[0]), 5);
    }
    /// 1200 would send an Arduino into its boot loader; a modem line that falls would reset it.
    void the_line_is_as_a_board_wants_it() {
        const Terminal terminal;
        const auto port = terminal.port();
        QVERIFY(port);
        termios settings{};
        QCOMPARE(tcgetattr(static_cast<int>(port->handle()), &settings), 0);
        QCOMPARE(cfgetospeed(&settings), speed_t{B115200});
        QCOMPARE(cfgetispeed(&settings), speed_t{B115200});
        QCOMPARE(settings.c_cflag & (CSIZE | CLOCAL | CREAD | HUPCL | PARENB | CSTOPB),
                 tcflag_t{CS8 | CLOCAL | CREAD});
        QVERIFY(settings.c_iflag == 0 && settings.c_oflag == 0 && settings.c_lflag == 0);
        QVERIFY(settings.c_cc[VMIN] == 1 && settings.c_cc[VTIME] == 0);
    }
    void what_was_left_on_it_before_is_forgotten() {
        const Terminal terminal;
        const int before = ::open(terminal.path.c_str(), O_RDWR | O_NOCTTY);
        QVERIFY(terminal.say({'o', 'l', 'd', '\n'}));
        const auto port = terminal.port();
        ::close(before);
        QVERIFY(port);
        QVERIFY(read_of(*port).empty());
    }
    void nobody_else_uses_it_meanwhile() {
        const Terminal terminal;
        auto port = terminal.port();
        QVERIFY(port);
        QVERIFY(is_exclusive(static_cast<int>(port->handle())));
        port.reset();
        QVERIFY(terminal.heard(1).empty()); // and when it has gone nobody has it open
        const int after = ::open(terminal.path.c_str(), O_RDWR | O_NOCTTY);
        QVERIFY(after >= 0 && !is_exclusive(after));
        ::close(after);
    }
    void nothing_yet_and_nothing_ever_differ() {
        Terminal terminal;
        const auto port = terminal.port();
        QVERIFY(port);
        std::array<std::uint8_t, 8> bytes{};
        QCOMPARE(port->read(bytes, 0), 0);
        terminal.close(); // unplugged
        QCOMPARE(port->read(bytes, 0), -1);
        QCOMPARE(port->read(bytes, 1000), -1); // and does not wait
        QVERIFY(!port->write(bytes));
    }
    void a_line_that_fails_is_gone() {
        const Terminal terminal;
        const auto port = terminal.port();
        QVERIFY(port);
        ::close(static_cast<int>(port->handle())); // behind its back
        std::array<std::uint8_t, 8> bytes{};
        QCOMPARE(port->read(bytes, 0), -1);
        QVERIFY(!port->write(bytes));
    }
    void what_is_no_line_is_said_in_a_sentence() {
        QVERIFY(open_serial_port("/dev/ttyNone", "board").error().find("The board was unplugged") !=
                std::string::npos);
        QTemporaryFile file;
        QVERIFY(file.open());
        const auto opened = open_serial_port(file.fileName().toStdString(), "board");
        QVERIFY2(!opened.ok() && opened.error().find("could not be opened") != std::string::npos,
                 opened.error().c_str());
    }
};

QTEST_APPLESS_MAIN(SerialPortTest)
#include "serial_port_test.moc"
