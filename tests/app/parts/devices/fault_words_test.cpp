// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/fault_words.hpp"
#include "audio/sentences/sentences.hpp"
#include "device/force_pad/pad_frames.hpp"
#include "device/open_problem.hpp"
#include "marked_sentences.hpp"
#include "test_program.hpp"

#include <QCoreApplication>
#include <QTest>

#include <set>
#include <string>

namespace fault_words_test {

using namespace tp;

class FaultWordsTest : public QObject {
    Q_OBJECT
private slots:
    void everything_that_a_device_says_has_a_translation() {
        std::set<std::string> said{"force pad"};
        for (const System system : {System::linux_system, System::windows, System::macos})
            for (const OpenProblem problem : {OpenProblem::permission, OpenProblem::wrong_driver,
                                              OpenProblem::wrong_usb_driver, OpenProblem::busy, OpenProblem::gone,
                                              OpenProblem::other})
                said.insert(sentence(problem, system, "force pad"));
        for (unsigned status = 0; status < 0x10000u; ++status)
            if (const std::string words = pad_sentence(static_cast<std::uint16_t>(status)); !words.empty())
                said.insert(words);
        tp::testing::Brackets brackets;
        QCoreApplication::installTranslator(&brackets);
        for (const std::string& words : said) {
            const QString translated = in_persons_language(words);
            QVERIFY2(translated.startsWith(u'⟦') && translated.endsWith(u'⟧'), words.c_str());
        }
        for (int fault = 1; fault <= static_cast<int>(Fault::device_lost); ++fault)
            QVERIFY(fault_words(static_cast<Fault>(fault)).startsWith(u'⟦'));
        QCOMPARE(fault_words(Fault::none), QString());
        QCOMPARE(in_persons_language(std::string("Acme Feeler 3000")), QString("Acme Feeler 3000"));
        QCoreApplication::removeTranslator(&brackets);
    }
};

} // namespace fault_words_test

TP_TEST(fault_words_test, FaultWordsTest, event_loop)
#include "fault_words_test.moc"
