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

/// CTest ends a test that waits for ever.
template <typename Condition>
void await(Condition condition) {
    while (!condition())
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

} // namespace

class PlugWatchTest : public QObject {
    Q_OBJECT

private slots:
    void what_comes_and_goes_is_told() {
        mock::UsbPadBed bed;
        std::atomic<int> told{0};
        const PlugWatch watch([&told] { ++told; });
        await([&] { return watch.listens(); });
        QVERIFY(bed.plug_in());
        await([&] { return told.load() > 0; });
        const int came = told.load();
        bed.unplug();
        await([&] { return told.load() > came; });
    }

    void it_ends_at_any_moment_and_tells_nothing_more() {
        mock::UsbPadBed bed;
        for (int i = 0; i < 50; ++i) {
            std::atomic<bool> alive{true};
            {
                const PlugWatch watch([&alive] { QVERIFY(alive.load()); });
                if (i % 2 == 0) { // the others end while they begin
                    await([&] { return watch.listens(); });
                    QVERIFY(bed.plug_in());
                }
            }
            alive.store(false);
            if (i % 2 == 0) {
                bed.unplug();
                bed.forget();
            }
        }
    }
};

QTEST_GUILESS_MAIN(PlugWatchTest)
#include "plug_watch_test.moc"
