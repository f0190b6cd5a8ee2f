// SPDX-License-Identifier: Apache-2.0
// Whatever the service of a phone does, in the service's own time: nobody but the writer waits for it, a pulse is short and ends,
// nothing shakes after a word to be still, and who is not served hears why.
#include "../../../device/closed_loop/fault_schedules.hpp"
#include "app/parts/feedbackd/feedbackd_node.hpp"
#include "device/touch_output/force_feedback/feedback_output.hpp"

#include <QDBusConnection>
#include <QDBusContext>
#include <QDBusError>
#include <QDBusMetaType>
#include <QObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTest>
#include <QThread>

#include <atomic>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace tp;
using tp::testing::any_trouble;
using tp::testing::first_schedule;
using tp::testing::schedules;
using tp::testing::Trouble;

namespace {

constexpr int answers_within_ms = 20'000; ///< real ones, of a busy machine
constexpr double step_s = 0.005;
std::atomic<double> now{0.0}; // s, of the service and of the output

} // namespace

/// The service with its motor.
class Phone : public QObject, protected QDBusContext {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.sigxcpu.Feedback.Haptic")
public:
    std::atomic<bool> refuses{false}, fails{false};
    std::atomic<double> answers_after{0.0}; ///< s
    std::atomic<int> calls{0};
    std::atomic<bool> unbounded{false}; ///< was asked for something that need not end soon

    bool shakes() const { return now < until_; }
    void forget() {
        refuses = fails = unbounded = false;
        answers_after = until_ = 0.0;
    }

public slots:
    bool Vibrate(const QString&, const QList<tp::feedbackd::Pulse>& pattern) {
        ++calls;
        if (fails) {
            sendErrorReply(QDBusError::Failed, "The motor is stuck.");
            return false;
        }
        if (refuses)
            return false;
        double seconds = 0.0;
        for (const feedbackd::Pulse& pulse : pattern) {
            seconds += 0.001 * pulse.length_ms;
            unbounded = unbounded || !(pulse.strength > 0.0 && pulse.strength <= 1.0) || pulse.length_ms == 0;
        }
        unbounded = unbounded || pattern.size() > 1 || seconds > Tick::longest_s;
        until_ = now + seconds;
        now = now + answers_after;
        if (answers_after > 0.001 * feedbackd::answers_within_ms)
            sendErrorReply(QDBusError::NoReply, "Too late.");
        return true;
    }

private:
    std::atomic<double> until_{0.0};
};

namespace {

/// The bus with the service on it, which can go and come.
class Bus {
public:
    Bus() : bus_(QDBusConnection::connectToBus(QDBusConnection::SessionBus, "phone")) {
        phone.moveToThread(&thread_);
        thread_.start();
        bus_.registerObject(feedbackd::path, &phone, QDBusConnection::ExportAllSlots);
        come(true);
    }
    ~Bus() {
        come(false);
        bus_.unregisterObject(feedbackd::path);
        QDBusConnection::disconnectFromBus("phone");
        thread_.quit();
        thread_.wait();
    }
    Bus(const Bus&) = delete;
    Bus& operator=(const Bus&) = delete;

    void come(bool there) {
        if (there != there_)
            there_ = there ? bus_.registerService(feedbackd::service)
                           : !bus_.unregisterService(feedbackd::service);
    }
    bool there() const { return there_; }

    Phone phone;

private:
    QDBusConnection bus_;
    QThread thread_;
    bool there_ = false;
};

FeedbackOutput::Opener opener_on(const QDBusConnection& bus) {
    return [bus]() -> Result<std::unique_ptr<FeedbackNode>> {
        return std::unique_ptr<FeedbackNode>(std::make_unique<FeedbackdNode>(bus, answers_within_ms));
    };
}

FeedbackOutput output_on(const QDBusConnection& bus) {
    return {{"vibration of this phone", ""}, opener_on(bus), LatestWriter::Thread::caller, [] {
                return now.load();
            }};
}

enum Kind { away, refuses, fails, slow, stalled, halted, stopped, kinds };

/// Ticks for a while, with up to four things that go wrong; what a hand could complain of.
class Schedule {
public:
    Schedule(Bus& bus, int number)
        : bus_(bus), random_(static_cast<unsigned>(number)),
          output_(output_on(QDBusConnection::sessionBus())) {
        bus_.come(true);
        bus_.phone.forget();
    }

    QString complaint() {
        open();
        constexpr int steps = 60;
        std::vector<Trouble> troubles(1 + random_() % 4);
        for (Trouble& trouble : troubles) {
            trouble = any_trouble(random_, static_cast<int>(random_() % kinds), steps);
            trouble.until = trouble.from + 1 + static_cast<int>(random_() % 20);
        }
        for (int at = 0; at < steps && complaint_.isEmpty(); ++at) {
            for (const Trouble& trouble : troubles)
                if (at == trouble.from || at == trouble.until)
                    set(trouble, at == trouble.from);
            step();
        }
        end();
        return complaint_;
    }

private:
    void open() {
        open_ = output_.open().ok();
        if (!open_)
            complain("it does not open");
    }
    void set(const Trouble& trouble, bool on) {
        Phone& phone = bus_.phone;
        switch (trouble.kind) {
        case away:
            bus_.come(!on);
            break;
        case refuses:
            phone.refuses = on;
            break;
        case fails:
            phone.fails = on;
            break;
        case slow:
            phone.answers_after = on ? 0.7 * trouble.size : 0.0;
            break;
        case stalled:
            stalled_ = on;
            break;
        case halted:
            if (on)
                still([this] { output_.halt(); });
            break;
        default:
            if (on) {
                output_.stop();
                open_ = may_shake_ = false;
                note_unheard();
            } else {
                open();
            }
            break;
        }
    }
    void note_unheard() { unheard_ = unheard_ || !bus_.there() || bus_.phone.refuses || bus_.phone.fails; }
    template <typename Call>
    void still(Call call) {
        without_waiting(call);
        may_shake_ = unheard_ = false;
    }
    /// A call that the service must not see, for else it would be waited for.
    template <typename Call>
    void without_waiting(Call call) {
        const int before = bus_.phone.calls;
        call();
        if (bus_.phone.calls != before)
            complain("a call waits for the service");
    }
    void step() {
        without_waiting([this] {
            if (random_() % 4 == 0) {
                const Tick tick(0.01 * static_cast<double>(1 + random_() % 150), 0.5,
                                0.001 * static_cast<double>(1 + random_() % 80));
                const bool was_lost = output_.lost();
                if (output_.tick(tick)) {
                    may_shake_ = true;
                    unheard_ = false;
                    if (was_lost)
                        complain("it takes ticks though it is lost");
                }
            }
            if (output_.lost() && output_.complaint().empty())
                complain("it is lost and nobody says so");
        });
        if (!stalled_)
            output_.deliver();
        note_unheard();
        if (bus_.phone.unbounded)
            complain("it asks for what need not end soon");
        if (bus_.phone.shakes() && !may_shake_ && !stalled_ && !unheard_)
            complain("it shakes after it was told to be still");
        now = now + step_s;
    }
    void end() {
        bus_.come(true);
        bus_.phone.refuses = bus_.phone.fails = false;
        bus_.phone.answers_after = 0.0;
        const bool heard = open_ && !output_.lost();
        output_.stop();
        if (heard && bus_.phone.shakes())
            complain("it shakes after it was stopped");
        now = now + Tick::longest_s;
        if (bus_.phone.shakes())
            complain("it shakes on by itself");
        if (!output_.open().ok() || output_.lost() || !output_.tick(Tick(1.0, 1.0, 0.05)))
            return complain("the service is there again and cannot be used");
        output_.deliver();
        if (!bus_.phone.shakes() || !output_.complaint().empty())
            complain("the service is there again and nothing is felt");
    }
    void complain(const char* what) {
        if (complaint_.isEmpty())
            complaint_ = what;
    }

    Bus& bus_;
    std::mt19937 random_;
    FeedbackOutput output_;
    QString complaint_;
    bool open_ = false;
    bool stalled_ = false;
    bool may_shake_ = false;
    bool unheard_ =
        false; ///< the service may not have taken the word to be still; the pulse's length ends it
};

} // namespace

class FeedbackdSchedulesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qDBusRegisterMetaType<feedbackd::Pulse>();
        qDBusRegisterMetaType<feedbackd::Pattern>();
    }

    void whatever_the_service_does_nothing_waits_and_all_ends() {
        Bus bus;
        QVERIFY(bus.there());
        for (int number = first_schedule(); number < first_schedule() + schedules(); ++number) {
            const QString complaint = Schedule(bus, number).complaint();
            QVERIFY2(complaint.isEmpty(), qPrintable(QString("schedule %1: %2").arg(number).arg(complaint)));
        }
    }

    void a_bus_that_dies_in_mid_touch_is_a_loss() {
        const QString daemon = QStandardPaths::findExecutable("dbus-daemon");
        if (daemon.isEmpty())
            QSKIP("There is no dbus-daemon here.");
        QProcess bus;
        bus.start(daemon, {"--session", "--nofork", "--print-address"});
        QVERIFY(bus.waitForReadyRead(answers_within_ms));
        const QString address = QString::fromLatin1(bus.readLine().trimmed());
        {
            const QDBusConnection mortal = QDBusConnection::connectToBus(address, "mortal");
            QVERIFY(mortal.isConnected());
            FeedbackOutput output = output_on(mortal);
            QVERIFY(output.open().ok() && output.tick(Tick(1.0, 1.0, 0.05)));
            bus.kill();
            QVERIFY(bus.waitForFinished(answers_within_ms));
            output.deliver();
            QVERIFY(output.lost() && !output.complaint().empty());
            QVERIFY(!output.tick(Tick(1.0, 1.0, 0.05)));
            output.halt();
            output.stop();
        }
        QDBusConnection::disconnectFromBus("mortal");
    }
};

QTEST_GUILESS_MAIN(FeedbackdSchedulesTest)
#include "feedbackd_schedules_test.moc"
