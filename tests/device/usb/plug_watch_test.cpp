// SPDX-License-Identifier: Apache-2.0
#include "../force_pad/mock_usb.hpp"
#include "device/usb/plug_watch.hpp"

#include <QObject>
#include <QTest>

#include <atomic>
#include <chrono>
#include <thread>

using namespace tp;

namespace {

/// Does `deed` again and again until the watch has told of it; CTest ends a test that waits for ever.
template <typename Deed>
void until_told(const std::atomic<int>& told, Deed deed) {
    for (const int before = told.load(); told.load() == before;) {
        deed();
        for (int i = 0; i < 100 && told.load() == before; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

} // namespace

class PlugWatchTest : public QObject {
    Q_OBJECT

private slots:
    void what_comes_and_goes_is_told() {
        mock::UsbPadBed bed;
        std::atomic<int> told{0};
        const PlugWatch watch([&told] { ++told; });
        bool there = false;
        until_told(told, [&] { // the watch's thread may still be making its context
            if (there) {
                bed.unplug();
                bed.forget();
            }
            QVERIFY(bed.plug_in());
            there = true;
        });
        const int came = told.load();
        bed.unplug();
        while (told.load() == came)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }

    void it_ends_at_any_moment_and_tells_nothing_more() {
        mock::UsbPadBed bed;
        for (int i = 0; i < 50; ++i) {
            std::atomic<bool> alive{true};
            {
                const PlugWatch watch([&alive] { QVERIFY(alive.load()); });
                QVERIFY(bed.plug_in());
                if (i % 2 == 0)
                    std::this_thread::yield();
            }
            alive.store(false);
            bed.unplug();
            bed.forget();
        }
    }
};

QTEST_GUILESS_MAIN(PlugWatchTest)
#include "plug_watch_test.moc"
