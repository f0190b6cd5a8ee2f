// SPDX-License-Identifier: Apache-2.0
// Hours of use at one go: somebody wanders over all pages while the album, the devices, the voice and the sound change
// underneath. Each deed counts as two seconds of a person's. It lasts sixteen hours, in CI two but for every third time;
// TP_SOAK_HOURS asks for more or fewer of them. A line tells each half hour what the program holds of the machine. What is
// kept fills for ten hours: pictures, pages, dialogs, threads that wait for work. What fills ends and what is lost goes on, so
// where it seems to grow the test goes on too, before it says so.
#include "disturbances.hpp"
#include "effort.hpp"
#include "monkey.hpp"
#include "page_test.hpp"
#include "process_load.hpp"

#include <QCoreApplication>
#include <QQmlEngine>
#include <QStringList>
#include <QTest>
#include <QThreadPool>

#include <cmath>
#include <cstdio>
#include <random>
#include <span>
#include <vector>

using namespace tp;
using tp::test::ProcessLoad;

namespace {

constexpr double deed_s = 2.0;    ///< of a person's time
constexpr double sound_s = 0.2;   ///< that passes with each deed
constexpr double look_every_h = 0.5;
constexpr double most_growth = 5.0;        ///< MB an hour
constexpr double judged_h = 6.0;           ///< fewer tell chance from growth no more
constexpr int most_judged = 3;             ///< so many hours each, one after the other
constexpr double fills_h = 10.0;           ///< what is kept, until it does not grow any more
constexpr double unlike = 3.0;             ///< handles or threads, of the pages and dialogs that happen to be open

double hours_asked() {
    return qEnvironmentVariableIsSet("TP_SOAK_HOURS") ? qEnvironmentVariable("TP_SOAK_HOURS").toDouble()
                                                      : (test::is_long_run() ? fills_h + judged_h : 2.0);
}

struct LoadLook {
    double hour = 0.0;
    ProcessLoad load;
};

/// MB an hour, by least squares.
double growth(std::span<const LoadLook> looks) {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const LoadLook& look : looks) {
        n += 1.0;
        x += look.hour;
        y += look.load.memory_mb;
        xx += look.hour * look.hour;
        xy += look.hour * look.load.memory_mb;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

template <typename Count>
double mean(std::span<const LoadLook> looks, Count count) {
    double sum = 0.0;
    for (const LoadLook& look : looks)
        sum += static_cast<double>(count(look.load));
    return sum / static_cast<double>(looks.size());
}

/// Whether nothing grows; tells how much it does.
bool is_steady(std::span<const LoadLook> judged) {
    const std::span<const LoadLook> before = judged.first(judged.size() / 2),
                                    after = judged.last(judged.size() / 2);
    const auto handles = [](const ProcessLoad& load) { return load.handles; };
    const auto threads = [](const ProcessLoad& load) { return load.threads; };
    const double more_handles = mean(after, handles) - mean(before, handles);
    const double more_threads = mean(after, threads) - mean(before, threads);
    std::printf("grows by %.2f MB an hour, %.1f handles and %.1f threads\n", growth(judged), more_handles,
                more_threads);
    std::fflush(stdout);
    return growth(judged) <= most_growth && more_handles <= unlike && more_threads <= unlike;
}

} // namespace

class SoakTest : public PageTest {
    Q_OBJECT

    /// At home with nothing under way.
    void rest(WholeProgram& whole) {
        whole.shell().open("start");
        QTRY_VERIFY_WITH_TIMEOUT(whole.complete(), 60000);
        QThreadPool::globalInstance()->waitForDone();
        QTest::qWait(200);
        whole.window->engine()->collectGarbage(); // what scripts have let go of is not held
    }

private slots:
    void nothing_grows_and_nothing_is_left() {
        testing::DeviceSocket socket;
        DeviceAccess access = socket.access();
        access.look_every_ms = 200;
        WholeProgram whole(WholeProgram::asked(), access);
        QVERIFY(whole.shown());
        Monkey monkey(whole, 20260501);
        Disturbances disturbances(whole, socket, 20260502);
        std::mt19937 random(20260503);
        const QStringList pages{"start", "browse", "explore", "care",  "capture",
                                "mend",  "print",  "lab",     "study", "settings"};
        const auto deeds_between = static_cast<int>(std::lround(3600.0 * look_every_h / deed_s));
        std::vector<LoadLook> looks;
        const auto use = [&](double hours) {
            const auto deeds = static_cast<int>(std::lround(3600.0 * hours / deed_s));
            for (int i = 0; i < deeds; ++i) {
                if (random() % 25 == 0)
                    whole.shell().open(
                        pages[static_cast<int>(random() % static_cast<unsigned>(pages.size()))]);
                monkey.do_something();
                if (random() % 8 == 0)
                    disturbances.let_something_happen();
                disturbances.let_sound_pass(sound_s);
                QCoreApplication::processEvents();
                QVERIFY2(whole.program->explore().finger()->newtons() <=
                             whole.program->preferences().choices().max_force_n + 1e-9,
                         qPrintable(monkey.last()));
                QVERIFY2(whole.keeps_to_its_folder(), qPrintable(monkey.last()));
                QVERIFY2(warnings().isEmpty(), qPrintable(monkey.last() + ", " + disturbances.last() + ": " +
                                                          warnings().join('\n')));
                if ((i + 1) % deeds_between != 0)
                    continue;
                rest(whole);
                looks.push_back(
                    {(static_cast<double>(looks.size()) + 1.0) * look_every_h, ProcessLoad::now()});
                std::printf("hour %4.1f: %.1f MB, %zu handles, %zu threads\n", looks.back().hour,
                            looks.back().load.memory_mb, looks.back().load.handles,
                            looks.back().load.threads);
                std::fflush(stdout);
            }
        };
        use(hours_asked());
        if (QTest::currentTestFailed())
            return;
        const auto judged = static_cast<std::size_t>(std::lround(judged_h / look_every_h));
        const bool told_apart = static_cast<double>(looks.size()) * look_every_h >= fills_h + judged_h;
        bool steady = !told_apart || is_steady(std::span(looks).last(judged));
        for (int more = 1; !steady && more < most_judged && !QTest::currentTestFailed(); ++more) {
            use(judged_h);
            steady = is_steady(std::span(looks).last(judged));
        }
        socket.unplug();
        QTRY_VERIFY(!socket.in_use());
        if (!told_apart)
            std::printf("too few hours to judge what grows\n");
        QVERIFY(steady);
    }
};

QTEST_MAIN(SoakTest)
#include "soak_test.moc"
