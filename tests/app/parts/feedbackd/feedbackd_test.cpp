// SPDX-License-Identifier: Apache-2.0
// Ticks through feedbackd, on a bus of the test's own, where a small service with its interface stands in.
#include "app/parts/feedbackd/feedbackd_bus.hpp"
#include "app/parts/feedbackd/feedbackd_node.hpp"

#include <QDBusConnection>
#include <QDBusMetaType>
#include <QObject>
#include <QTest>
#include <QThread>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

using namespace tp;

namespace {

constexpr int soon_ms = 20'000;

} // namespace

/// What a phone's service was asked for.
class StandIn : public QObject {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.sigxcpu.Feedback.Haptic")
public:
    std::atomic<bool> refuses{false};
    QStringList taken() {
        const std::lock_guard lock(mutex_);
        return std::exchange(asked_, {});
    }
    int asked() {
        const std::lock_guard lock(mutex_);
        return static_cast<int>(asked_.size());
    }

public slots:
    bool Vibrate(const QString& program, const QList<tp::feedbackd::Pulse>& pattern) {
        QString told = program;
        for (const feedbackd::Pulse& pulse : pattern)
            told += QString(" %1 %2").arg(pulse.strength, 0, 'f', 2).arg(pulse.length_ms);
        const std::lock_guard lock(mutex_);
        asked_ << told;
        return !refuses;
    }

private:
    std::mutex mutex_;
    QStringList asked_;
};

/// The service, on a thread and a connection of its own.
class PhoneService {
public:
    explicit PhoneService(bool has_motor = true)
        : bus_(QDBusConnection::connectToBus(QDBusConnection::SessionBus, "phone")) {
        stand_in.moveToThread(&thread_);
        thread_.start();
        if (has_motor)
            bus_.registerObject(feedbackd::path, &stand_in, QDBusConnection::ExportAllSlots);
        good = bus_.registerService(feedbackd::service);
    }
    ~PhoneService() {
        bus_.unregisterService(feedbackd::service);
        bus_.unregisterObject(feedbackd::path);
        QDBusConnection::disconnectFromBus("phone");
        thread_.quit();
        thread_.wait();
    }
    PhoneService(const PhoneService&) = delete;
    PhoneService& operator=(const PhoneService&) = delete;

    StandIn stand_in;
    bool good = false;

private:
    QDBusConnection bus_;
    QThread thread_;
};

class FeedbackdTest : public QObject {
    Q_OBJECT

    static std::unique_ptr<TouchOutput> the_only_one() {
        const auto outputs = plugged_feedbackd();
        return outputs.size() == 1 ? outputs[0].make() : nullptr;
    }

private slots:
    void initTestCase() {
        qDBusRegisterMetaType<feedbackd::Pulse>();
        qDBusRegisterMetaType<feedbackd::Pattern>();
    }

    void without_the_service_or_its_motor_there_is_nothing() {
        QVERIFY(plugged_feedbackd().empty());
        const PhoneService none(false);
        QVERIFY(none.good);
        QVERIFY(plugged_feedbackd().empty());
    }

    void a_tick_is_a_pulse_with_an_end_and_halt_ends_it() {
        PhoneService phone;
        QVERIFY(phone.good);
        const auto outputs = plugged_feedbackd();
        QCOMPARE(outputs.size(), std::size_t(1));
        QCOMPARE(outputs[0].name, std::string("feedbackd:motor"));
        QCOMPARE(outputs[0].means, TouchMeans::rumble);
        const auto output = outputs[0].make();
        QVERIFY(output->open().ok());
        QCOMPARE(phone.stand_in.asked(), 0);
        QVERIFY(output->tick(Tick(0.5, 1.0, 0.01)));
        QTRY_COMPARE_WITH_TIMEOUT(phone.stand_in.asked(), 1, soon_ms);
        QCOMPARE(phone.stand_in.taken(), QStringList("touchphoto 0.50 40"));
        output->halt();
        QTRY_COMPARE_WITH_TIMEOUT(phone.stand_in.asked(), 1, soon_ms);
        QCOMPARE(phone.stand_in.taken(), QStringList("touchphoto"));
        QCOMPARE(output->complaint(), std::string());
        output->stop();
        QVERIFY(!output->tick(Tick(0.5, 1.0, 0.01)));
    }

    void a_service_that_refuses_is_said_and_goes_on() {
        PhoneService phone;
        const auto output = the_only_one();
        QVERIFY(output && output->open().ok());
        phone.stand_in.refuses = true;
        QVERIFY(output->tick(Tick(0.5, 1.0, 0.01)));
        QTRY_VERIFY_WITH_TIMEOUT(!output->complaint().empty(), soon_ms);
        QVERIFY(output->complaint().find("did not play") != std::string::npos);
        QVERIFY(!output->lost());
        phone.stand_in.refuses = false;
        QVERIFY(output->tick(Tick(0.5, 1.0, 0.01)));
        QTRY_VERIFY_WITH_TIMEOUT(output->complaint().empty(), soon_ms);
    }

    void a_service_that_has_ended_is_lost() {
        std::unique_ptr<TouchOutput> output;
        {
            const PhoneService phone;
            output = the_only_one();
            QVERIFY(output && output->open().ok());
        }
        QVERIFY(!output->lost());
        output->tick(Tick(0.5, 1.0, 0.01));
        QTRY_VERIFY_WITH_TIMEOUT(output->lost(), soon_ms);
        QVERIFY(!output->complaint().empty());
        QVERIFY(!output->tick(Tick(0.5, 1.0, 0.01)));
    }
};

QTEST_GUILESS_MAIN(FeedbackdTest)
#include "feedbackd_test.moc"
