// SPDX-License-Identifier: Apache-2.0
// The force pad through the real libusb, with a device made by umockdev.
#include "device/force_pad/bulk_transport.hpp"
#include "device/force_pad/pad_frames.hpp"
#include "device/usb/usb_devices.hpp"
#include "found_pad_judge.hpp"
#include "mock_usb.hpp"
#include "stranger.hpp"

#include <QTest>

#include <cstdint>
#include <libusb.h>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace tp;
using mock::UsbPadBed;

namespace {

struct Bench : FoundPadBench {
    explicit Bench(UsbPadBed& bed, bool patient = true)
        : FoundPadBench(
              find_bulk(), open_bulk,
              [&bed] {
                  const UsbPadBed::Seen seen = bed.seen();
                  return seen.answered + seen.given_up;
              },
              patient) {}
};

const std::vector<std::string> nodes = {UsbPadBed::node, mock::hidraw_node};

} // namespace

class BulkTransportTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const UsbPadBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_thousand_frames_go_there_and_back() {
        UsbPadBed bed;
        QVERIFY(find_bulk().empty());
        QVERIFY(bed.plug_in()); // late arrival: it was not there a moment ago
        const std::vector<FoundPad> found = find_bulk();
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found.front().path, std::string("1-1"));
        QCOMPARE(found.front().serial_number, std::string("TPC-0001"));
        QCOMPARE(found.front().product, std::string("force pad"));
        {
            Bench bench(bed);
            judge_a_thousand_frames(bench);
            QVERIFY(bed.seen().motors);
        }
        // The way out leaves no force, and the interface to others.
        const UsbPadBed::Seen seen = bed.seen();
        QVERIFY(!seen.motors);
        QCOMPARE(seen.x_mn, std::int16_t(0));
        QCOMPARE(seen.y_mn, std::int16_t(0));
        QCOMPARE(seen.claimed, 1L);
        QCOMPARE(seen.released, 1L);
    }

    void unplugged_in_mid_touch_it_is_lost_and_everything_ends() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        Bench bench(bed);
        judge_unplugged_in_mid_touch(bench, [&] { bed.unplug(); });
    }

    void unplugged_it_is_lost_to_who_reads_and_who_writes() {
        for (const bool reads : {true, false}) {
            UsbPadBed bed;
            QVERIFY(bed.plug_in());
            Result<std::unique_ptr<ReportTransport>> opened = open_bulk({"", "TPC-0001", ""});
            QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().c_str());
            ReportTransport& transport = *opened.value();
            pad::Frame frame;
            QVERIFY(transport.read(frame, 0) == ReportTransport::Got::nothing);
            bed.unplug();
            if (reads)
                QVERIFY(transport.read(frame, 600000) == ReportTransport::Got::lost);
            QVERIFY(!transport.write(pad::encode(pad::ForceFrame{})));
            // libusb's own thread hears of it in its time.
            QVERIFY(transport.read(frame, 600000) == ReportTransport::Got::lost);
            QVERIFY(transport.read(frame, 600000) == ReportTransport::Got::lost); // and stays so
        }
    }

    void a_pad_that_falls_silent_is_stale_and_heals() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        Bench bench(bed);
        UsbPadBed::Behaviour silent;
        silent.silent = true;
        judge_silent_for_a_while(
            bench, [&] { bed.behave(silent); }, [&] { bed.behave({}); });
    }

    void a_frame_that_the_pad_does_not_take_never_comes_late() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        Result<std::unique_ptr<ReportTransport>> opened = open_bulk({"", "TPC-0001", ""});
        QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().c_str());
        UsbPadBed::Behaviour deaf;
        deaf.deaf = true;
        bed.behave(deaf);
        pad::ForceFrame strong;
        strong.x_mn = 1000;
        strong.motors = true;
        QVERIFY(opened.value()->write(pad::encode(strong))); // the pad is there all the same
        bed.behave({});
        while (bed.seen().taken == 0) // a busy machine may take a frame back before the pad has it
            QVERIFY(opened.value()->write(pad::encode(pad::ForceFrame{})));
        QCOMPARE(bed.seen().taken, 1L);
        QCOMPARE(bed.seen().x_mn, std::int16_t(0));
    }

    void packets_of_another_length_are_dropped_and_counted() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        Bench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        UsbPadBed::Behaviour odd;
        odd.odd_packets = true;
        bed.behave(odd);
        for (int i = 0; i < 200; ++i)
            bench.tick(true);
        QCOMPARE(bench.loop->snapshot().fault, Fault::none);
        bed.behave({});
        bench.until([&] { return bench.device->bad_frames() == static_cast<std::uint64_t>(bed.seen().odd); });
        QVERIFY(bed.seen().odd >= 3 * (190 - bed.seen().given_up));
    }

    void halted_pipes_are_opened_again_and_broken_packets_borne_data() {
        QTest::addColumn<int>("in");
        QTest::addColumn<int>("out");
        QTest::addColumn<int>("errors");
        QTest::newRow("from the pad") << 5 << 0 << 0;
        QTest::newRow("to the pad") << 0 << 5 << 0;
        QTest::newRow("both") << 5 << 5 << 0;
        QTest::newRow("broken packets") << 0 << 0 << 20;
        QTest::newRow("everything") << 3 << 3 << 20;
    }
    void halted_pipes_are_opened_again_and_broken_packets_borne() {
        QFETCH(int, in);
        QFETCH(int, out);
        QFETCH(int, errors);
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        Bench bench(bed);
        QVERIFY2(bench.loop, bench.error.c_str());
        for (int i = 0; i < 100; ++i)
            bench.tick(true);
        UsbPadBed::Behaviour trouble;
        trouble.stalls_in = in;
        trouble.stalls_out = out;
        trouble.errors_in = errors;
        bed.behave(trouble);
        bench.until([&] { return bed.seen().halts_cleared >= in + out; });
        for (int i = 0; i < 100; ++i)
            bench.tick(false);
        const long before = bed.seen().answered;
        bench.until([&] { return bed.seen().answered > before + 100; });
        bench.until([&] { return bench.loop->snapshot().fault == Fault::none; });
        QVERIFY(!bench.device->lost());
        QCOMPARE(bed.seen().halts_cleared, static_cast<long>(in + out));
    }

    void a_line_on_which_every_packet_breaks_is_lost() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        Result<std::unique_ptr<ReportTransport>> opened = open_bulk({"", "TPC-0001", ""});
        QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().c_str());
        UsbPadBed::Behaviour broken;
        broken.errors_in = 1000000;
        bed.behave(broken);
        pad::Frame frame;
        QVERIFY(opened.value()->read(frame, 600000) == ReportTransport::Got::lost);
    }

    void who_reads_late_gets_the_newest_packets() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        Result<std::unique_ptr<ReportTransport>> opened = open_bulk({"", "TPC-0001", ""});
        QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().c_str());
        ReportTransport& transport = *opened.value();
        constexpr int sent = 200;
        for (int i = 0; i < sent; ++i)
            QVERIFY(transport.write(pad::encode(pad::AskFrame{0, pad::FrameType::identity, 0})));
        const long taken = bed.seen().taken; // of those that were sent: a busy machine takes some back
        QVERIFY(taken >= sent / 2);
        while (bed.seen().answered < 2 * taken) // the answer to each, and a state
            std::this_thread::yield();
        int count = 0;
        int newest = 0;
        while (newest < taken) {
            pad::Frame frame;
            QVERIFY(transport.read(frame, 600000) == ReportTransport::Got::report);
            ++count;
            if (pad::StateFrame state; pad::decode(frame, state))
                newest = state.sequence;
        }
        QVERIFY2(count >= 63 && count <= 72,
                 std::to_string(count).c_str()); // some came while these were read
    }

    void another_device_with_the_same_ids_is_told_apart_data() { other_devices(); }
    void another_device_with_the_same_ids_is_told_apart() {
        QFETCH(bool, silent);
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        UsbPadBed::Behaviour other;
        (silent ? other.silent : other.other_device) = true;
        bed.behave(other);
        const Bench bench(bed, false);
        judge_another_device(bench);
    }

    void another_device_without_the_interface_is_not_listed() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in(false, false));
        QVERIFY(find_bulk().empty());
    }

    void a_driver_of_the_kernel_makes_way_and_comes_back() {
        UsbPadBed bed;
        UsbPadBed::Behaviour held;
        held.kernel_driver = true;
        bed.behave(held);
        QVERIFY(bed.plug_in());
        {
            const Result<std::unique_ptr<ReportTransport>> opened = open_bulk({"", "TPC-0001", ""});
            QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().c_str());
            QCOMPARE(bed.seen().detached, 1L);
            QCOMPARE(bed.seen().attached, 0L);
        }
        QCOMPARE(bed.seen().attached, 1L);
    }

    void an_interface_that_another_program_holds_is_busy() {
        UsbPadBed bed;
        UsbPadBed::Behaviour busy;
        busy.busy = true;
        bed.behave(busy);
        QVERIFY(bed.plug_in());
        const Result<std::unique_ptr<ReportTransport>> opened = open_bulk({"", "TPC-0001", ""});
        QVERIFY(!opened.ok());
        QVERIFY2(opened.error().find("Close that program") != std::string::npos, opened.error().c_str());
    }

    void without_permission_a_person_is_told_what_to_do() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        const mock::Stranger stranger(bed.root(), nodes, {UsbPadBed::node});
        QVERIFY(stranger.good());
        const std::vector<FoundPad> found = find_bulk();
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found.front().serial_number, std::string("TPC-0001")); // who it is may everybody know
        judge_without_permission(open_bulk(found.front()));
    }

    void a_pad_with_another_number_or_at_another_place_is_not_opened() {
        UsbPadBed bed;
        QVERIFY(bed.plug_in());
        for (const FoundPad& other : {FoundPad{"1-1", "TPC-0002", ""}, FoundPad{"1-2", "", ""}}) {
            const Result<std::unique_ptr<ReportTransport>> opened = open_bulk(other);
            QVERIFY(!opened.ok());
            QVERIFY2(opened.error().find("unplugged") != std::string::npos, opened.error().c_str());
        }
        QVERIFY(open_bulk({"1-1", "", ""}).ok());
        QVERIFY(open_bulk({"1-9", "TPC-0001", ""}).ok()); // plugged in elsewhere meanwhile
    }

    void each_error_of_libusb_is_a_reason_a_person_is_told() {
        QCOMPARE(open_problem_of_libusb(LIBUSB_ERROR_ACCESS, System::linux_system), OpenProblem::permission);
        QCOMPARE(open_problem_of_libusb(LIBUSB_ERROR_ACCESS, System::macos), OpenProblem::busy);
        QCOMPARE(open_problem_of_libusb(LIBUSB_ERROR_BUSY, System::linux_system), OpenProblem::busy);
        QCOMPARE(open_problem_of_libusb(LIBUSB_ERROR_NO_DEVICE, System::windows), OpenProblem::gone);
        QCOMPARE(open_problem_of_libusb(LIBUSB_ERROR_NOT_FOUND, System::linux_system), OpenProblem::gone);
        for (const int error : {LIBUSB_ERROR_NOT_FOUND, LIBUSB_ERROR_NOT_SUPPORTED}) {
            const OpenProblem problem = open_problem_of_libusb(error, System::windows);
            QVERIFY(sentence(problem, System::windows, "force pad").find("WinUsb") != std::string::npos);
        }
        QCOMPARE(open_problem_of_libusb(LIBUSB_ERROR_NO_MEM, System::linux_system), OpenProblem::other);
    }
};

QTEST_APPLESS_MAIN(BulkTransportTest)
#include "bulk_transport_test.moc"
