// SPDX-License-Identifier: Apache-2.0
// Steam pads through the real hidapi, with a device made by umockdev.
#include "../hid_bed.hpp"
#include "device/touch_output/steam_pad/hid_steam_transport.hpp"
#include "device/touch_output/steam_pad/model_steam_pad.hpp"
#include "device/touch_output/touch_registry.hpp"
#include "stranger.hpp"

#include <QTest>

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

using namespace tp;

namespace {

/// As the interface of the pads has it: 64 bytes each way without a number. That of the mouse beside it has no feature report.
constexpr std::array<std::uint8_t, 25> of_pads{0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00,
                                               0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x40, 0x09, 0x01,
                                               0x81, 0x02, 0x09, 0x01, 0xB1, 0x02, 0xC0};
constexpr std::array<std::uint8_t, 21> of_mouse{0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09,
                                                0x30, 0x09, 0x31, 0x15, 0x81, 0x25, 0x7F,
                                                0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xC0};

/// A Steam Deck's controller on the bus.
struct SteamBed {
    ModelSteamPad model{steam::Kind::deck};
    std::mutex mutex; ///< of the model
    bool refuses = false;
    std::atomic<int> refused{0}; ///< reports
    mock::HidBed bed;

    explicit SteamBed(std::span<const std::uint8_t> descriptor = of_pads, std::string product = "1205")
        : bed(mock::HidrawDevice{"Steam Deck Controller", "SD-0001", descriptor, "28de", std::move(product)},
              {[this](std::span<const std::uint8_t> report) {
                   const std::lock_guard lock(mutex);
                   refused.fetch_add(refuses ? 1 : 0);
                   return !refuses && model.receive(report);
               },
               [](auto) { return mock::HidBed::Bytes{}; }}) {}
    /// The next input report of the model.
    bool say() {
        const std::lock_guard lock(mutex);
        std::vector<std::uint8_t> bytes;
        while (!model.report(bytes))
            model.step();
        return bed.say(bytes);
    }
    bool imitates() {
        const std::lock_guard lock(mutex);
        return model.imitates();
    }
    unsigned long ticks() {
        const std::lock_guard lock(mutex);
        return model.ticks();
    }
};

const char* const its_name = "steam:SD-0001";

/// Waits for the newest reading; CTest ends a test that waits for ever.
PadTouch reading(TouchOutput& pad) {
    for (double now = 0.0;; now += 1e-6) {
        if (const auto touch = pad.read(now))
            return *touch;
        std::this_thread::yield();
    }
}

} // namespace

class HidSteamTransportTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const SteamBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_deck_is_listed_and_its_pad_ticks_under_the_thumb() {
        SteamBed deck;
        QVERIFY(find_steam_pads().empty());
        QVERIFY(deck.bed.plug_in());
        const std::vector<ListedTouchOutput> listed = list_touch_outputs();
        QCOMPARE(listed.size(), std::size_t(1));
        QCOMPARE(listed.front().name, std::string(its_name));
        QVERIFY(listed.front().is_pad && listed.front().means == TouchMeans::ticks);

        auto pad = touch_output_named(its_name);
        QVERIFY2(pad.ok(), pad.error().c_str());
        const auto can = (*pad)->open();
        QVERIFY2(can.ok(), can.error().c_str());
        QVERIFY(!deck.imitates());
        deck.model.touch(steam::Side::left, {5.0, -2.0});
        QVERIFY(deck.say());
        const PadTouch touch = reading(**pad);
        QVERIFY(touch.touched && distance(touch.place, Vec2(5.0, -2.0)) < 0.01);
        QVERIFY((*pad)->tick(Tick(0.9, 1.0, 0.01)));
        while (deck.ticks() == 0) // CTest ends a test that waits for ever
            std::this_thread::yield();
        QVERIFY(deck.model.felt(steam::Side::left) > 0.5);
        (*pad)->stop();
        QVERIFY(deck.imitates());
    }

    void the_mouse_beside_it_and_another_product_are_no_pads() {
        SteamBed mouse(of_mouse);
        QVERIFY(mouse.bed.plug_in());
        QVERIFY(find_steam_pads().empty());
        SteamBed other(of_pads, "1304");
        QVERIFY(other.bed.plug_in());
        QVERIFY(find_steam_pads().empty());
    }

    void unplugged_in_mid_touch_it_is_lost() {
        SteamBed deck;
        QVERIFY(deck.bed.plug_in());
        auto pad = touch_output_named(its_name);
        QVERIFY(pad.ok() && (*pad)->open().ok());
        deck.bed.unplug();
        for (double now = 0.0; !(*pad)->lost(); now += 1e-6)
            (*pad)->read(now);
        QVERIFY(!(*pad)->tick(Tick(1.0, 1.0, 0.01)));
        QVERIFY((*pad)->complaint().find("was unplugged") != std::string::npos);
        (*pad)->stop();
    }

    void one_that_refuses_is_not_opened() {
        SteamBed deck;
        deck.refuses = true;
        QVERIFY(deck.bed.plug_in());
        auto pad = touch_output_named(its_name);
        QVERIFY(pad.ok());
        QVERIFY((*pad)->open().error().find("does not answer") != std::string::npos);
        QCOMPARE(deck.refused.load(), 50); // by radio it takes a while: each is tried 25 times
    }

    void another_touchphoto_that_uses_it_is_told_of() {
        SteamBed deck;
        QVERIFY(deck.bed.plug_in());
        auto first = touch_output_named(its_name);
        auto second = touch_output_named(its_name);
        QVERIFY(first.ok() && second.ok() && (*first)->open().ok());
        QVERIFY((*second)->open().error().find("Another program uses the Steam Deck") != std::string::npos);
        (*first)->stop();
        QVERIFY((*second)->open().ok());
    }

    void without_permission_it_is_listed_and_a_person_is_told_what_to_do() {
        SteamBed deck;
        QVERIFY(deck.bed.plug_in());
        const mock::Stranger stranger(deck.bed.root(), {mock::hidraw_node}, {mock::hidraw_node});
        QVERIFY(stranger.good());
        auto pad = touch_output_named(its_name);
        QVERIFY2(pad.ok(), pad.error().c_str());
        QVERIFY((*pad)->open().error().find("udev/rules.d") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(HidSteamTransportTest)
#include "hid_steam_transport_test.moc"
