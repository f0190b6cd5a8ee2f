// SPDX-License-Identifier: Apache-2.0
// Which of a kernel's input devices are offered, by folders like those of its sysfs.
#include "byte_mutants.hpp"
#include "device/told_name.hpp"
#include "device/touch_output/force_feedback/event_nodes.hpp"
#include "device/touch_output/force_feedback/plugged_feedback.hpp"
#include "nodes_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace event_nodes_test {

using namespace tp;

namespace {

// As Linux 6.1 shows them on a machine of 64 bits.
constexpr const char* rumble_pad = "107030000 0";
constexpr const char* gaming_keys = "7fdb000000000000 0 0 0 0";
constexpr const char* keyboard_keys = "fffffffffffffffe";
constexpr const char* wheel = "300040000 0"; // constant force too

struct Shown {
    std::string ff = rumble_pad;
    std::string key = gaming_keys;
    std::string name = "Twin motors";
    std::string uniq = {};
    std::string bus = "0003";
};

/// What a kernel shows of input devices.
class Inputs {
public:
    void show(const std::string& node, const Shown& shown) const {
        const std::filesystem::path device = path() / node / "device";
        std::filesystem::create_directories(device / "capabilities");
        std::filesystem::create_directories(device / "id");
        put(device / "capabilities/ff", shown.ff);
        put(device / "capabilities/key", shown.key);
        put(device / "name", shown.name);
        put(device / "uniq", shown.uniq);
        put(device / "id/bustype", shown.bus);
    }
    std::vector<FoundFeedback> found() const { return find_feedback_below(path(), "/dev/input"); }

private:
    std::filesystem::path path() const { return folder_.path().toStdString(); }
    static void put(const std::filesystem::path& file, const std::string& text) {
        std::ofstream(file) << text << '\n';
    }
    QTemporaryDir folder_;
};

} // namespace

class EventNodesTest : public QObject {
    Q_OBJECT
private slots:
    void bits_are_read_as_the_kernel_writes_them() {
        const auto bits = kernel_bits("107030000 0", 64);
        for (const std::size_t bit : {0x50U, 0x51U, 0x58U, 0x59U, 0x5aU, 0x60U})
            QVERIFY(bits[bit]);
        QCOMPARE(bits.count(), std::size_t(6));
        QVERIFY(kernel_bits("1 7030000 0 0", 32) == bits);
        QVERIFY(kernel_bits("7fdb000000000000 0 0 0 0", 64)[0x130]);
    }
    void what_no_kernel_writes_is_no_bit() {
        std::string many = "1";
        for (int i = 0; i < 1000; ++i)
            many += " 1";
        std::string longest = "1"; // all that fit in 768 bits
        for (int i = 1; i < 12; ++i)
            longest += " 0";
        QVERIFY(kernel_bits(longest, 64)[704]);
        for (const std::string& text :
             {longest + " 1", std::string(), std::string("x"), std::string("1 -1"), std::string("1  1"),
              std::string("11111111111111111"), std::string("1\0", 2), many})
            QVERIFY2(kernel_bits(text, 64).none(), text.c_str());
    }
    void names_are_letters_that_can_be_read_aloud() {
        QCOMPARE(told_name(" Pad\x1b[2J \"x\"\xff\n"), std::string("Pad[2J x"));
        QCOMPARE(told_name("\t\xff  "), std::string());
        QCOMPARE(told_name(std::string(10'000, 'a')).size(), std::size_t(80));
    }

    void pads_and_phones_are_found_and_nothing_else() {
        const Inputs inputs;
        inputs.show("event10", {"10000 0", "0", "pm8941_vib", "", "0019"});
        inputs.show("event2", {rumble_pad, gaming_keys, "Twin motors", "00:11"});
        inputs.show("event3", {"0", keyboard_keys, "Keyboard"});
        inputs.show("event4", {wheel, gaming_keys, "Wheel"});
        inputs.show("js0", {});
        inputs.show("event5", {"7030000 0", "0", "Haptic strip"}); // without gain: its own waves
        const std::vector<FoundFeedback> found = inputs.found();
        QCOMPARE(found.size(), std::size_t(3));
        QCOMPARE(found[0].path, std::string("/dev/input/event2"));
        QCOMPARE(found[0].name, std::string("Twin motors"));
        QCOMPARE(found[0].serial_number, std::string("00:11"));
        QCOMPARE(found[0].kind, FeedbackKind::two_motors);
        QCOMPARE(found[1].path, std::string("/dev/input/event5"));
        QCOMPARE(found[1].kind, FeedbackKind::sine);
        QCOMPARE(found[2].path, std::string("/dev/input/event10"));
    }
    void what_is_built_in_is_not_called_by_its_driver() {
        const Inputs inputs;
        inputs.show("event1", {rumble_pad, "0", "pm8941_vib", "", "0019"});
        inputs.show("event2", {rumble_pad, "0", "", "", "0003"});
        inputs.show("event3", {rumble_pad, gaming_keys, "", "", "0003"});
        const std::vector<FoundFeedback> found = inputs.found();
        QCOMPARE(found.size(), std::size_t(3));
        QCOMPARE(found[0].kind, FeedbackKind::motor);
        QCOMPARE(found[0].name, std::string("vibration motor of this machine"));
        QCOMPARE(found[1].name, std::string("vibration motor of this machine"));
        QCOMPARE(found[2].name, std::string("game pad"));
    }
    void a_kernel_that_shows_nothing_has_none() {
        QVERIFY(find_feedback_below("/nowhere", "/dev/input").empty());
        const Inputs inputs;
        QVERIFY(inputs.found().empty());
    }

    void each_goes_by_a_name_of_its_own() {
        const auto outputs =
            feedback_outputs({{"/dev/input/event2", "Pad", "00:11", FeedbackKind::two_motors},
                              {"/dev/input/event3", "Pad", "00:11", FeedbackKind::sine},
                              {"/dev/input/event4", "Other", "", FeedbackKind::motor}});
        QCOMPARE(outputs.size(), std::size_t(3));
        QCOMPARE(outputs[0].name, std::string("motor:00:11"));
        QCOMPARE(outputs[0].about, std::string("Pad"));
        QCOMPARE(outputs[0].means, TouchMeans::rumble);
        QCOMPARE(outputs[1].name, std::string("motor:/dev/input/event3"));
        QCOMPARE(outputs[1].means, TouchMeans::ticks);
        QCOMPARE(outputs[2].name, std::string("motor:/dev/input/event4"));
        QVERIFY(!outputs[0].is_pad);
    }
    void what_was_unplugged_before_it_was_opened_is_gone() {
        const auto outputs = feedback_outputs({{"/dev/input/event777", "Pad", "", FeedbackKind::motor}});
        const auto can = outputs[0].make()->open();
        QVERIFY(!can.ok());
        QVERIFY2(can.error().find("The Pad was unplugged.") != std::string::npos, can.error().c_str());
    }

    void whatever_a_kernel_shows_what_is_offered_can_be_said_and_opened() {
        const std::vector<test::Seed> seeds =
            test::corpus(test::in_source("tests/device/touch_output/force_feedback/corpus"));
        QVERIFY(seeds.size() >= 5);
        for (const test::Seed& seed : seeds)
            QCOMPARE(QString::fromStdString(test::complaint_about_input_device(seed.text)), QString());
        test::ByteMutator mutator(1);
        for (int i = 0; i < 2000; ++i)
            QCOMPARE(QString::fromStdString(test::complaint_about_input_device(mutator.mutant(seeds))),
                     QString());
    }
};

} // namespace event_nodes_test

TP_TEST(event_nodes_test, EventNodesTest, nothing)
#include "event_nodes_test.moc"
