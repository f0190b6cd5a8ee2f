// SPDX-License-Identifier: Apache-2.0
// What the kernel is asked for a device with force feedback, and what is made of its answers: a node made by umockdev.
#include "../../mocked_node.hpp"
#include "device/touch_output/force_feedback/event_nodes.hpp"

#include <QTest>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <deque>
#include <linux/input.h>
#include <memory>
#include <poll.h>
#include <string>
#include <sys/ioctl.h>
#include <umockdev-1.0/umockdev.h>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace tp;

namespace {

/// A game pad with two motors in /sys and /dev, and the kernel's part of its node.
class MotorBed {
public:
    std::vector<ff_effect> effects; ///< that were put on it
    QStringList grabs;
    bool turns_down = true;  ///< it has a gain
    std::deque<int> answers; ///< errno of the next requests; 0 where there is none

    MotorBed() : bed_(umockdev_testbed_new()) {
        ioctls_ = UMOCKDEV_IOCTL_BASE(g_object_new(umockdev_ioctl_base_get_type(), nullptr));
        g_signal_connect(ioctls_, "handle-ioctl", G_CALLBACK(&MotorBed::answer_of), this);
    }
    ~MotorBed() {
        unplug();
        g_object_unref(ioctls_);
        g_object_unref(bed_);
    }
    MotorBed(const MotorBed&) = delete;
    MotorBed& operator=(const MotorBed&) = delete;

    bool plug_in() {
        const char* const shown =
            "P: /devices/virtual/input/input5\nE: SUBSYSTEM=input\nA: name=Twin motors\\n\n"
            "A: uniq=00:11\\n\nA: capabilities/ff=107030000 0\\n\n"
            "A: capabilities/key=7fdb000000000000 0 0 0 0\\n\nA: id/bustype=0003\\n\n\n"
            "P: /devices/virtual/input/input5/event5\nN: input/event5\nE: SUBSYSTEM=input\n"
            "E: DEVNAME=/dev/input/event5\nE: MAJOR=13\nE: MINOR=69\nL: device=../../input5\n\n";
        file_ = tp::mock::plugged_in(bed_, shown, "/dev/input/event5", ioctls_);
        return file_ >= 0;
    }
    void unplug() {
        if (file_ >= 0)
            ::close(std::exchange(file_, -1));
    }
    /// The next event that was written, "code value"; empty where there is none.
    QString event() const {
        pollfd ready{file_, POLLIN, 0};
        input_event one{};
        if (::poll(&ready, 1, 0) <= 0 || (ready.revents & POLLIN) == 0 ||
            ::read(file_, &one, sizeof one) != static_cast<ssize_t>(sizeof one) || one.type != EV_FF)
            return {};
        return QString("%1 %2").arg(one.code, 0, 16).arg(one.value);
    }
    /// Nobody has it open.
    bool hung_up() const {
        pollfd ready{file_, 0, 0};
        return ::poll(&ready, 1, 0) > 0 && (ready.revents & POLLHUP) != 0;
    }

private:
    static gboolean answer_of(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        return static_cast<MotorBed*>(self)->answer(client);
    }
    gboolean answer(UMockdevIoctlClient* client) {
        const gulong request = umockdev_ioctl_client_get_request(client);
        if (_IOC_TYPE(request) != 'E')
            return FALSE;
        int error = 0;
        if (!answers.empty()) {
            error = answers.front();
            answers.pop_front();
        }
        if (error == 0)
            obey(request, umockdev_ioctl_client_get_arg(client));
        umockdev_ioctl_client_complete(client, error == 0 ? 0 : -1, error);
        return TRUE;
    }
    void obey(gulong request, UMockdevIoctlData* argument) {
        if (request == EVIOCGRAB) {
            long word = 0;
            std::memcpy(&word, argument->data, sizeof word);
            grabs << QString::number(word);
            return;
        }
        UMockdevIoctlData* const data =
            umockdev_ioctl_data_resolve(argument, 0, static_cast<gsize>(_IOC_SIZE(request)), nullptr);
        if (request == EVIOCSFF) {
            auto* const effect = reinterpret_cast<ff_effect*>(data->data);
            effects.push_back(*effect);
            effect->id = 7;
        } else if (_IOC_NR(request) == 0x20 + EV_FF && turns_down) {
            data->data[FF_GAIN / 8] = 1 << FF_GAIN % 8;
        }
        umockdev_ioctl_data_unref(data);
    }

    UMockdevTestbed* bed_;
    UMockdevIoctlBase* ioctls_ = nullptr;
    int file_ = -1;
};

const FoundFeedback twin_motors{"/dev/input/event5", "Twin motors", "00:11", FeedbackKind::two_motors};

std::unique_ptr<FeedbackNode> opened(FeedbackKind kind = FeedbackKind::two_motors) {
    FoundFeedback found = twin_motors;
    found.kind = kind;
    auto node = open_feedback(found);
    return node.ok() ? std::move(node).value() : nullptr;
}

} // namespace

class EventNodeTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const MotorBed bed;
        QVERIFY2(umockdev_in_mock_environment() != FALSE, "needs umockdev's preloaded library");
    }

    void a_pad_is_found_where_the_kernel_shows_it() {
        MotorBed bed;
        QVERIFY(find_feedback().empty());
        QVERIFY(bed.plug_in());
        const std::vector<FoundFeedback> found = find_feedback();
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].path, twin_motors.path);
        QCOMPARE(found[0].name, twin_motors.name);
        QCOMPARE(found[0].serial_number, twin_motors.serial_number);
        QCOMPARE(found[0].kind, twin_motors.kind);
    }

    /// What another program turned down would stay so.
    void it_is_turned_up_where_it_can_be() {
        for (const bool turns_down : {true, false}) {
            MotorBed bed;
            bed.turns_down = turns_down;
            QVERIFY(bed.plug_in());
            const auto node = opened();
            QVERIFY(node && node->there());
            QCOMPARE(bed.grabs.join(' '), QString("1 0")); // asked whether another program has it, and let go
            QCOMPARE(bed.event(), turns_down ? QString("60 65535") : QString());
            QCOMPARE(bed.event(), QString());
            QVERIFY(!bed.hung_up());
        }
    }

    void one_effect_is_put_on_it_changed_and_played() {
        MotorBed bed;
        bed.turns_down = false;
        QVERIFY(bed.plug_in());
        auto node = opened();
        QVERIFY(node);
        QCOMPARE(node->kind(), FeedbackKind::two_motors);
        QCOMPARE(node->upload({0x1234, 0xFEDC, 0, 50}), 0);
        QCOMPARE(node->upload({0x10, 0x20, 0, 40}), 0);
        QCOMPARE(bed.effects.size(), std::size_t(2));
        QCOMPARE(int(bed.effects[0].id), -1); // a new one
        QCOMPARE(int(bed.effects[1].id), 7);  // the same
        QCOMPARE(int(bed.effects[0].type), FF_RUMBLE);
        QCOMPARE(int(bed.effects[0].replay.length), 50);
        QCOMPARE(int(bed.effects[0].u.rumble.strong_magnitude), 0x1234);
        QCOMPARE(int(bed.effects[0].u.rumble.weak_magnitude), 0xFEDC);
        QCOMPARE(int(bed.effects[1].replay.length), 40);
        QCOMPARE(node->play(true), 0);
        QCOMPARE(bed.event(), QString("7 1"));
        QCOMPARE(node->play(false), 0);
        QCOMPARE(bed.event(), QString("7 0"));
        node.reset();
        QVERIFY(bed.hung_up()); // which ends what plays
    }

    void a_wave_is_half_as_high_as_a_motor_is_strong() { // the kernel's has a sign
        for (const FeedbackKind kind : {FeedbackKind::sine, FeedbackKind::square}) {
            MotorBed bed;
            QVERIFY(bed.plug_in());
            const auto node = opened(kind);
            QVERIFY(node);
            QCOMPARE(node->upload({0xFFFF, 0, 6, 20}), 0);
            const ff_effect& effect = bed.effects.at(0);
            QCOMPARE(int(effect.type), FF_PERIODIC);
            QCOMPARE(int(effect.u.periodic.waveform), kind == FeedbackKind::sine ? FF_SINE : FF_SQUARE);
            QCOMPARE(int(effect.u.periodic.period), 6);
            QCOMPARE(int(effect.u.periodic.magnitude), 0x7FFF);
            QCOMPARE(int(effect.replay.length), 20);
        }
    }

    void what_the_kernel_answers_is_passed_on() {
        MotorBed bed;
        QVERIFY(bed.plug_in());
        const auto node = opened();
        QVERIFY(node);
        for (const int error : {ENOSPC, EINVAL, ENODEV}) {
            bed.answers = {error};
            QCOMPARE(node->upload({1, 1, 0, 40}), error);
        }
        bed.answers = {EINTR, EINTR}; // a signal came in between
        QCOMPARE(node->upload({1, 1, 0, 40}), 0);
        QCOMPARE(bed.effects.size(), std::size_t(1));
    }

    void what_another_program_has_grabbed_is_not_opened() {
        for (const auto& [error, words] : {std::pair{EBUSY, "Another program uses the Twin motors"},
                                           {ENODEV, "The Twin motors was unplugged"}}) {
            MotorBed bed;
            QVERIFY(bed.plug_in());
            bed.answers = {error};
            const auto node = open_feedback(twin_motors);
            QVERIFY(!node.ok());
            QVERIFY2(node.error().find(words) != std::string::npos, node.error().c_str());
            QVERIFY(bed.grabs.empty() && bed.event().isEmpty() && bed.hung_up());
        }
    }

    void unplugged_it_is_not_there_and_plays_nothing() {
        MotorBed bed;
        QVERIFY(bed.plug_in());
        const auto node = opened();
        QVERIFY(node && node->there());
        bed.unplug();
        QVERIFY(!node->there());
        QVERIFY(node->play(true) != 0);
    }
};

QTEST_APPLESS_MAIN(EventNodeTest)
#include "event_node_test.moc"
