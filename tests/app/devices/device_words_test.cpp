// SPDX-License-Identifier: Apache-2.0
#include "app/devices/device_access.hpp"
#include "app/devices/device_words.hpp"
#include "device/force_pad/pad_frames.hpp"
#include "device/open_problem.hpp"

#include <QCoreApplication>
#include <QTest>
#include <QTranslator>

#include <string>
#include <vector>

using namespace tp;

namespace {

/// Every text becomes itself between brackets.
class Brackets final : public QTranslator {
public:
    QString translate(const char*, const char* source, const char*, int) const override {
        return "[" + QString::fromUtf8(source) + "]";
    }
    bool isEmpty() const override { return false; }
};

} // namespace

class DeviceWordsTest : public QObject {
    Q_OBJECT
private slots:
    void everything_that_a_device_says_has_a_translation() {
        Brackets brackets;
        QCoreApplication::installTranslator(&brackets);
        const auto translated = [](const std::string& words) {
            return device_words(words).startsWith('[') && device_words(words).endsWith(']');
        };
        for (const System system : {System::linux_system, System::windows, System::macos})
            for (const OpenProblem problem : {OpenProblem::permission, OpenProblem::wrong_driver,
                                              OpenProblem::wrong_usb_driver, OpenProblem::busy, OpenProblem::gone,
                                              OpenProblem::other}) {
                const std::string words = sentence(problem, system, "force pad");
                QVERIFY2(translated(words), words.c_str());
            }
        for (unsigned status = 0; status < 0x10000u; ++status) {
            const std::string words = pad_sentence(static_cast<std::uint16_t>(status));
            QVERIFY2(words.empty() || translated(words), words.c_str());
        }
        for (int fault = 1; fault <= static_cast<int>(Fault::device_lost); ++fault)
            QVERIFY(fault_words(static_cast<Fault>(fault)).startsWith('['));
        QCOMPARE(fault_words(Fault::none), QString());
        QVERIFY(translated("force pad"));
        QCOMPARE(device_words("Acme Feeler 3000"), QString("Acme Feeler 3000"));
        QCOMPARE(device_words({}), QString());
        QCoreApplication::removeTranslator(&brackets);
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
