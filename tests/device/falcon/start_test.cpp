// SPDX-License-Identifier: Apache-2.0
#include "device/falcon/falcon_start.hpp"
#include "device/falcon/firmware_image.hpp"
#include "device/falcon/simulated_falcon_link.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace start_test {

using namespace tp;
using namespace tp::falcon;
using What = FalconStart::Step::What;
using Trouble = FalconStart::Trouble;

namespace {

std::vector<std::uint8_t> any_image(std::size_t size = 8012) {
    std::vector<std::uint8_t> image(size);
    for (std::size_t i = 0; i < size; ++i)
        image[i] = static_cast<std::uint8_t>((i * 131) ^ (i >> 5));
    return image;
}

/// A model Falcon that is started over a simulated cable; and what was asked of the line.
struct Bench {
    std::vector<std::uint8_t> image = any_image();
    ModelFalcon model{image};
    SimulatedFalconLink link{model};
    std::vector<ftdi::Request> requests;
    int steps = 0;

    FalconStart run(std::span<const std::uint8_t> loaded) {
        FalconStart start(loaded);
        while (true) {
            ++steps;
            const FalconStart::Step step = start.next();
            if (step.what == What::control) {
                requests.push_back(step.request);
                link.control(step.request);
            } else if (step.what == What::send) {
                link.write(step.bytes);
            } else if (step.what == What::listen) {
                UsbPacket packet;
                if (link.read(packet, FalconStart::listen_ms) == UsbGot::packet) {
                    const ftdi::Received got = ftdi::received(packet.content());
                    start.heard(got.payload, got.clear_to_send);
                } else {
                    start.silence();
                }
            } else {
                return start;
            }
        }
    }
};

struct Tries {
    std::map<std::size_t, int> sent; ///< how often so many bytes
    int listened = 0;
};

/// What is tried until it is given up, where each time that it listens ends like that.
template <typename End>
Tries until_failed(FalconStart& start, End end) {
    Tries tries;
    for (FalconStart::Step step = start.next(); step.what != What::failed && tries.listened < 100000;
         step = start.next()) {
        if (step.what == What::send)
            ++tries.sent[step.bytes.size()];
        if (step.what == What::listen) {
            ++tries.listened;
            end();
        }
    }
    return tries;
}

} // namespace

class FalconStartTest : public QObject {
    Q_OBJECT
private slots:
    void a_running_firmware_is_found_and_nothing_is_loaded() {
        Bench bench;
        bench.model.run_firmware(true);
        FalconStart start = bench.run(bench.image);
        QVERIFY(start.next().what == What::running);
        QCOMPARE(start.loads(), 0);
        QVERIFY(bench.model.firmware_runs());
        QVERIFY(bench.requests ==
                (std::vector<ftdi::Request>{{9, 1}, {3, 0x0002}, {4, 8}, {2, 0}, {0, 1}, {0, 2}}));
    }

    void a_falcon_just_switched_on_is_loaded_at_once() {
        Bench bench;
        FalconStart start = bench.run(bench.image);
        QVERIFY(start.next().what == What::running);
        QVERIFY(start.trouble() == Trouble::none);
        QCOMPARE(start.loads(), 1);
        QCOMPARE(bench.model.loads_begun(), 1);
        QVERIFY(bench.model.firmware_runs());
        // The line as the facts have it, from the loader's greeting to the firmware's packets.
        const std::vector<ftdi::Request> wanted{
            {0, 1},      {0, 2},      {9, 16},     {3, 0x4138}, {4, 8},      {2, 0},
            {1, 0x0200}, {1, 0x0100}, {1, 0x0101}, {1, 0x0100}, {3, 0x0015}, {9, 1},
            {3, 0x0002}, {4, 8},      {2, 0},      {0, 1},      {0, 2}};
        QVERIFY(std::vector<ftdi::Request>(bench.requests.begin() + 6, bench.requests.end()) == wanted);
    }

    void an_image_goes_in_chunks_that_come_back_in_a_packet() {
        Bench bench;
        FalconStart start(bench.image);
        for (int i = 0; i < 5 * 3; ++i) { // nobody answers: it is not running
            while (start.next().what != What::listen) {
            }
            start.silence();
        }
        const auto until_sent = [&start] {
            FalconStart::Step step = start.next();
            while (step.what == What::control)
                step = start.next();
            return step;
        };
        FalconStart::Step step = until_sent();
        QVERIFY(std::vector<std::uint8_t>(step.bytes.begin(), step.bytes.end()) ==
                (std::vector<std::uint8_t>{0x0A, 0x43, 0x0D}));
        const std::vector<std::uint8_t> answer{0x0A, 0x44, 0x2C, 0x0D};
        start.heard(std::span(answer).first(2), false); // in two packets
        start.heard(std::span(answer).last(2), false);
        step = until_sent();
        QVERIFY(step.what == What::listen); // for CTS
        start.heard({}, false);
        QVERIFY(start.next().what == What::listen);
        start.heard({}, true);
        step = until_sent();
        QVERIFY(step.bytes.size() == 1 && step.bytes.front() == 0x41);
        start.heard(std::vector<std::uint8_t>{0x41}, true);
        std::vector<std::uint8_t> sent;
        while (sent.size() < bench.image.size()) {
            step = until_sent();
            QVERIFY(step.what == What::send && step.bytes.size() <= 62);
            const std::vector<std::uint8_t> echo(step.bytes.begin(), step.bytes.end());
            sent.insert(sent.end(), echo.begin(), echo.end());
            start.heard(std::span(echo).first(echo.size() / 2), true);
            start.heard(std::span(echo).subspan(echo.size() / 2), true);
        }
        QVERIFY(sent == bench.image);
        QCOMPARE(start.loads(), 1);
    }

    void a_load_that_fails_is_tried_again_as_a_whole_data() {
        QTest::addColumn<int>("broken");
        QTest::addColumn<int>("lossy");
        QTest::newRow("an echo is wrong") << 1 << 0;
        QTest::newRow("a byte is lost") << 0 << 1;
        QTest::newRow("nine times") << 5 << 4;
    }
    void a_load_that_fails_is_tried_again_as_a_whole() {
        QFETCH(int, broken);
        QFETCH(int, lossy);
        Bench bench;
        bench.model.troubles.broken_loads = broken;
        bench.model.troubles.lossy_loads = lossy;
        FalconStart start = bench.run(bench.image);
        QVERIFY(start.next().what == What::running);
        QCOMPARE(start.loads(), 1 + broken + lossy);
        QVERIFY(bench.model.firmware_runs());
    }

    void a_zero_before_the_greeting_is_borne() {
        Bench bench;
        bench.model.troubles.eager_zero = true;
        QVERIFY(bench.run(bench.image).next().what == What::running);
    }

    void where_cts_never_rises_it_is_tried_all_the_same() {
        Bench bench;
        bench.model.troubles.never_clear = true;
        QVERIFY(bench.run(bench.image).next().what == What::running);
    }

    void each_way_to_fail_ends_and_says_what_to_do_data() {
        QTest::addColumn<int>("way");
        QTest::addColumn<int>("trouble");
        QTest::addColumn<QString>("says");
        QTest::newRow("no image") << 0 << static_cast<int>(Trouble::no_image) << "Copy the firmware file";
        QTest::newRow("the loader is mute") << 1 << static_cast<int>(Trouble::mute_loader) << "power supply";
        QTest::newRow("every load breaks") << 2 << static_cast<int>(Trouble::broken_load) << "not into a hub";
        QTest::newRow("it loads and is dead")
            << 3 << static_cast<int>(Trouble::dead_firmware) << "not the firmware";
        QTest::newRow("another's firmware")
            << 4 << static_cast<int>(Trouble::dead_firmware) << "not the firmware";
        QTest::newRow("nothing comes back") << 5 << static_cast<int>(Trouble::mute_loader) << "power supply";
    }
    void each_way_to_fail_ends_and_says_what_to_do() {
        QFETCH(int, way);
        QFETCH(int, trouble);
        QFETCH(QString, says);
        Bench bench;
        std::vector<std::uint8_t> loaded = bench.image;
        if (way == 0)
            loaded.clear();
        bench.model.troubles.mute_loader = way == 1;
        bench.model.troubles.broken_loads = way == 2 ? 1000 : 0;
        bench.model.troubles.dead_firmware = way == 3;
        if (way == 4)
            loaded[4000] ^= 1;
        bench.link.troubles.mute = way == 5;
        FalconStart start = bench.run(loaded);
        QVERIFY(start.next().what == What::failed);
        QCOMPARE(static_cast<int>(start.trouble()), trouble);
        QVERIFY(start.loads() <= FalconStart::most_loads);
        const std::string words = start_sentence(start.trouble(), "the/file");
        QVERIFY2(words.find(says.toStdString()) != std::string::npos, words.c_str());
    }

    void firmware_is_looked_for_where_the_page_says() {
        const QByteArray before = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", "/data");
        QCOMPARE(firmware_file().generic_string(), std::string("/data/touchphoto/falcon/firmware.bin"));
        qunsetenv("XDG_DATA_HOME");
        const QByteArray home = qgetenv("HOME");
        qputenv("HOME", "/home/anna");
        QCOMPARE(firmware_file().generic_string(),
                 std::string("/home/anna/.local/share/touchphoto/falcon/firmware.bin"));
        qputenv("HOME", home);
        if (!before.isNull())
            qputenv("XDG_DATA_HOME", before);
    }

    void a_file_of_another_size_is_no_firmware_data() {
        QTest::addColumn<int>("size");
        QTest::addColumn<bool>("good");
        QTest::newRow("empty") << 0 << false;
        QTest::newRow("cut") << 4095 << false;
        QTest::newRow("the smallest known") << 7914 << true;
        QTest::newRow("the largest known") << 8492 << true;
        QTest::newRow("a picture") << 16385 << false;
    }
    void a_file_of_another_size_is_no_firmware() {
        QFETCH(int, size);
        QFETCH(bool, good);
        const QTemporaryDir folder;
        QFile file(folder.filePath("firmware.bin"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(size, 'x'));
        file.close();
        const Result<std::vector<std::uint8_t>> image = firmware_in(file.fileName().toStdString());
        QCOMPARE(image.ok(), good);
        if (good)
            QCOMPARE(image->size(), static_cast<std::size_t>(size));
        else
            QVERIFY2(image.error().find("firmware.bin") != std::string::npos, image.error().c_str());
    }

    void no_file_is_no_firmware_and_no_error() {
        const QTemporaryDir folder;
        const Result<std::vector<std::uint8_t>> image =
            firmware_in(folder.filePath("firmware.bin").toStdString());
        QVERIFY(image.ok() && image->empty());
    }

    // What is tried with a Falcon until it is said not to answer

    void a_firmware_that_may_run_is_asked_five_times_for_60_ms_each() {
        FalconStart silent(std::span<const std::uint8_t>{});
        const Tries in_silence = until_failed(silent, [&] { silent.silence(); });
        QCOMPARE(in_silence.sent, (std::map<std::size_t, int>{{packet_size, 5}}));
        QCOMPARE(in_silence.listened, 15);
        FalconStart idle(
            std::span<const std::uint8_t>{}); // packets with nothing in them come each millisecond
        QCOMPARE(until_failed(idle, [&] { idle.heard({}, false); }).listened, 5 * 60);
    }

    void a_loader_is_greeted_a_hundred_times_a_load_and_loaded_ten_times() {
        const std::vector<std::uint8_t> image = any_image();
        FalconStart start(image);
        Tries tries = until_failed(start, [&] { start.heard({}, false); }); // of a loader each 16 ms
        QCOMPARE(tries.sent[3], 10 * 100);
        QCOMPARE(tries.listened, 5 * 60 + 10 * 100 * 4);
        QCOMPARE(start.loads(), 10);
    }

    /// From the greeting on, with silence at one stage.
    void each_stage_of_a_load_has_its_patience() {
        const std::vector<std::uint8_t> image = any_image();
        FalconStart start(image);
        const auto until_sent = [&start](std::size_t size) {
            for (int i = 0; i < 1000; ++i) {
                const FalconStart::Step step = start.next();
                if (step.what == What::send && step.bytes.size() == size)
                    return true;
                if (step.what == What::listen)
                    start.silence();
            }
            return false;
        };
        const std::vector<std::uint8_t> greeted{0x0A, 0x44, 0x2C, 0x0D};
        const std::vector<std::uint8_t> knocked{0x41};
        const auto knocked_again = [&] {
            if (!until_sent(3))
                return false;
            start.heard(greeted, false);
            start.heard({}, true);
            const bool knocks = until_sent(1);
            start.heard(knocked, true);
            return knocks;
        };
        QVERIFY(until_sent(3));
        start.heard(greeted, false);
        int silences = 0; // for CTS 300 ms, then it is tried without
        FalconStart::Step step = start.next();
        for (; step.what != What::send; step = start.next())
            if (step.what == What::listen) {
                ++silences;
                start.silence();
            }
        QCOMPARE(silences, 15);
        QCOMPARE(step.bytes.size(), std::size_t(1));
        int knocks = 1;
        while (start.loads() == 1) {
            step = start.next();
            if (step.what == What::send)
                ++knocks;
            else
                start.silence();
        }
        QCOMPARE(knocks, 5);
        QVERIFY(knocked_again()); // the whole load again
        QVERIFY(until_sent(62));
        silences = 0; // a chunk is sent once and waited for 400 ms
        while (start.loads() == 2) {
            step = start.next();
            QVERIFY(step.what == What::listen);
            ++silences;
            start.silence();
        }
        QCOMPARE(silences, 20);
        QVERIFY(start.trouble() == Trouble::broken_load);
        QVERIFY(knocked_again());
        std::size_t loaded = 0;
        while (loaded < image.size()) {
            step = start.next();
            QVERIFY(step.what == What::send);
            const std::vector<std::uint8_t> echo(step.bytes.begin(), step.bytes.end());
            loaded += echo.size();
            start.heard(echo, true);
        }
        int proofs = 0; // ten times, then the load begins anew
        while (start.loads() == 3) {
            step = start.next();
            if (step.what == What::send)
                ++proofs;
            else if (step.what == What::listen)
                start.silence();
        }
        QCOMPARE(proofs, 10);
        QVERIFY(start.trouble() == Trouble::dead_firmware);
    }
};

} // namespace start_test

TP_TEST(start_test, FalconStartTest, nothing)
#include "start_test.moc"
