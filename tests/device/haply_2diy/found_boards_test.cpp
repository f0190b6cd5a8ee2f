// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/found_boards.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace found_boards_test {

using namespace tp;

namespace {

void put(const std::filesystem::path& file, const std::string& words) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << words << '\n';
}

/// A port of the USB device `usb`, as the kernel shows it below `root`.
void add(const std::filesystem::path& root, const char* tty, const std::string& usb,
         const std::string& vendor, const std::string& serial) {
    const std::filesystem::path device = root / "devices" / usb;
    const std::filesystem::path interface = device / (usb + ":1.0");
    std::filesystem::create_directories(interface);
    put(device / "idVendor", vendor);
    if (!serial.empty())
        put(device / "serial", serial);
    std::filesystem::create_directories(root / "tty" / tty);
    std::filesystem::create_directory_symlink(interface, root / "tty" / tty / "device");
}

} // namespace

class FoundBoardsTest : public QObject {
    Q_OBJECT
private slots:
    /// A folder as the kernel's, with two boards of Arduino's vendors among what is none.
    void boards_are_found_by_their_usb_vendor() {
        const QTemporaryDir folder;
        const std::filesystem::path root = folder.path().toStdString();
        add(root, "ttyACM1", "1-2", "2341", "7523031393535120A0D1");
        add(root, "ttyACM0", "1-3", "2a03", "");
        add(root, "ttyUSB0", "1-4", "0403", "A900");
        std::filesystem::create_directories(root / "tty" / "tty0"); // a console
        const std::vector<FoundBoard> found = find_boards_below(root / "tty", "/dev");
        QCOMPARE(found.size(), std::size_t(2));
        QCOMPARE(found[0].path, std::string("/dev/ttyACM0"));
        QCOMPARE(found[0].serial_number, std::string());
        QCOMPARE(found[1].path, std::string("/dev/ttyACM1"));
        QCOMPARE(found[1].serial_number, std::string("7523031393535120A0D1"));
        QVERIFY(find_boards_below(root / "none", "/dev").empty());
    }

    void what_a_board_tells_of_itself_can_be_said_and_is_never_long() {
        const QTemporaryDir folder;
        const std::filesystem::path root = folder.path().toStdString();
        add(root, "ttyACM0", "1-2", "2341", std::string(1 << 20, '7'));
        add(root, "ttyACM1", "1-3", "2341",
            "75\x1b[2J\xe2\x80\xae"
            "30\"D1 and more");
        add(root, "ttyACM2", "1-4", std::string(1 << 20, '2'), "A900");
        const std::vector<FoundBoard> found = find_boards_below(root / "tty", "/dev");
        QCOMPARE(found.size(), std::size_t(2));
        QCOMPARE(found[0].serial_number, std::string(80, '7'));
        QCOMPARE(found[1].serial_number, std::string("75[2J30D1"));
    }

    /// A port is a part of a device that may be a part of a hub's; farther up it is another's.
    void a_port_belongs_to_a_device_six_folders_up_at_most() {
        const QTemporaryDir folder;
        const std::filesystem::path root = folder.path().toStdString();
        for (const auto& [tty, way] : {std::pair{"ttyACM6", "2/3/4/5/6"}, {"ttyACM7", "2/3/4/5/6/7"}}) {
            const std::filesystem::path device = root / "devices" / tty;
            put(device / "idVendor", "2341");
            std::filesystem::create_directories(device / way);
            std::filesystem::create_directories(root / "tty" / tty);
            std::filesystem::create_directory_symlink(device / way, root / "tty" / tty / "device");
        }
        const std::vector<FoundBoard> found = find_boards_below(root / "tty", "/dev");
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].path, std::string("/dev/ttyACM6"));
    }
};

} // namespace found_boards_test

TP_TEST(found_boards_test, FoundBoardsTest, nothing)
#include "found_boards_test.moc"
