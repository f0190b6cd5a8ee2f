// SPDX-License-Identifier: Apache-2.0
#include "app/devices/device_access.hpp"
#include "app/devices/device_words.hpp"
#include "device/force_pad/pad_frames.hpp"
#include "device/open_problem.hpp"

#include <QTest>

using namespace tp;

class DeviceWordsTest : public QObject {
    Q_OBJECT
private slots:
    void everything_that_a_device_says_is_there_to_translate() {
        for (const System system : {System::linux_system, System::windows, System::macos})
            for (const OpenProblem problem : {OpenProblem::permission, OpenProblem::wrong_driver,
                                              OpenProblem::wrong_usb_driver, OpenProblem::busy, OpenProblem::gone,
                                              OpenProblem::other}) {
                const std::string words = sentence(problem, system, "force pad");
                QVERIFY2(is_device_words(words), words.c_str());
            }
        for (unsigned status = 0; status < 0x10000u; ++status) {
            const std::string words = pad_sentence(static_cast<std::uint16_t>(status));
            QVERIFY2(words.empty() || is_device_words(words), words.c_str());
        }
        for (int fault = 1; fault <= static_cast<int>(Fault::device_lost); ++fault)
            QVERIFY(is_device_words(sentence(static_cast<Fault>(fault))));
        QVERIFY(is_device_words("force pad"));
        QVERIFY(!is_device_words("Acme Feeler 3000"));
        QCOMPARE(device_words("Acme Feeler 3000"), QString("Acme Feeler 3000"));
        QCOMPARE(device_words({}), QString());
    }

    void the_chosen_device_serves_and_else_the_first() {
        const std::vector<ListedDevice> there{{"pad:A", "one", "A", "hid"}, {"pad:/dev/hidraw3", "two", "", "bulk"}};
        QCOMPARE(device_for(there, {}), &there[0]);
        QCOMPARE(device_for(there, "A"), &there[0]);
        QCOMPARE(device_for(there, "pad:/dev/hidraw3"), &there[1]);
        QCOMPARE(device_for(there, "broken long ago"), &there[0]);
        QCOMPARE(device_for(there, no_device_key), nullptr);
        QCOMPARE(device_for({}, "A"), nullptr);
        for (const ListedDevice& one : there)
            QCOMPARE(device_for(there, key_of(one)), &one);
    }
};

QTEST_GUILESS_MAIN(DeviceWordsTest)
#include "device_words_test.moc"
