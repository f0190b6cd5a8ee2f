// SPDX-License-Identifier: Apache-2.0
// Whatever hand and program do to the drawn output: its finger stays on the surface, friction ends, and nothing is heard of what
// was stopped.
#include "../../closed_loop/fault_schedules.hpp"
#include "device/touch_output/drawn/drawn_touch.hpp"

#include <QString>
#include <QTest>

#include <glm/common.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <vector>

using namespace tp;
using tp::testing::any_trouble;
using tp::testing::first_schedule;
using tp::testing::schedules;
using tp::testing::Trouble;

namespace {

constexpr double step_s = 0.001;
constexpr double settled_s =
    0.1; ///< behind a hand that rests, without friction: twelve times its time constant
const Vec2 half{100.0, 75.0};

struct Listener final : TickListener {
    bool listens = false, sounds = false, wrong = false;
    void begin() override { listens = true; }
    void end() override { listens = sounds = false; }
    void ticked(const Tick& tick, double time) noexcept override {
        wrong = wrong || !listens || tick.empty() || tick.seconds() > Tick::longest_s || !(time >= 0.0);
        sounds = true;
    }
    void hush() noexcept override { sounds = false; }
};

enum Kind { nowhere, outside, jumps, lifted, late, halted, stopped, odd_levels, kinds };

/// A second of a hand and a program, with up to four things that go wrong.
class Schedule {
public:
    explicit Schedule(int number) : random_(static_cast<unsigned>(number)) {}

    QString complaint() {
        constexpr int steps = 1000;
        open();
        std::vector<Trouble> troubles(1 + random_() % 4);
        for (Trouble& trouble : troubles)
            trouble = any_trouble(random_, static_cast<int>(random_() % kinds), steps);
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
    double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
    void open() {
        open_ = touch_.open().ok();
        if (!open_)
            complain("it does not open");
    }
    void set(const Trouble& trouble, bool on) {
        on_[static_cast<std::size_t>(trouble.kind)] = on;
        if (trouble.kind == halted && on) {
            touch_.halt();
            if (listener_->sounds)
                complain("it is heard after it was told to be still");
        }
        if (trouble.kind == stopped && on && open_) {
            touch_.stop();
            open_ = false;
            if (listener_->listens)
                complain("it is listened to after it was stopped");
        } else if (trouble.kind == stopped && !on) {
            open();
        }
    }
    void move() {
        hand_ += Vec2(share() - 0.5, share() - 0.5);
        if (on_[jumps] && random_() % 20 == 0)
            hand_ = 2.0 * half * Vec2(share() - 0.5, share() - 0.5);
        Vec2 told = hand_ = glm::clamp(hand_, -half, half);
        if (on_[outside])
            told = hand_ = 1e6 * Vec2(share() - 0.5, share() - 0.5);
        if (on_[nowhere])
            told.x = std::numeric_limits<double>::quiet_NaN();
        if (on_[lifted])
            touch_.lift();
        else if (random_() % 200 == 0)
            touch_.set_down(told);
        else
            touch_.move_hand(told);
    }
    void feel() {
        if (random_() % 3 == 0) {
            constexpr std::array odd{-1.0, 7.0, std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::infinity()};
            touch_.resist(on_[odd_levels] ? odd[random_() % odd.size()] : share());
        }
        if (random_() % 30 == 0 && touch_.tick(Tick(share(), share(), 0.1 * share())) && !open_)
            complain("it ticks after it was stopped");
    }
    void step() {
        now_ += on_[late] ? 0.3 * share() : step_s;
        if (random_() % 4 != 0)
            move();
        look();
        feel();
    }
    void look() {
        const std::optional<PadTouch> touch = touch_.read(now_);
        if (!touch || !is_finite(touch->place) || std::abs(touch->place.x) > half.x ||
            std::abs(touch->place.y) > half.y)
            return complain("its finger is not on the surface");
        place_ = touch->place;
        if (listener_->wrong)
            complain("it was told of a tick that cannot be");
    }
    /// Nobody resists any more, and the hand rests.
    void end() {
        on_ = {};
        touch_.halt();
        move();
        now_ += step_s;
        look();
        for (const double until = now_ + settled_s; now_ < until; now_ += step_s)
            look();
        if (length(place_ - hand_) > 0.1)
            complain("friction goes on");
        open();
        touch_.set_down(hand_);
        look();
        touch_.resist(1.0);
        touch_.stop();
        if (touch_.tick(Tick(1.0, 1.0, 0.05)) || listener_->sounds)
            complain("it ticks after it was stopped");
        open();
        look();
        if (!touch_.tick(Tick(1.0, 1.0, 0.05)) || !listener_->sounds)
            complain("opened again it is not heard");
    }
    void complain(const char* what) {
        if (complaint_.isEmpty())
            complaint_ = QString("%1 at %2 s").arg(what).arg(now_);
    }

    std::mt19937 random_;
    std::shared_ptr<Listener> listener_ = std::make_shared<Listener>();
    DrawnTouch touch_{2.0 * half.x, 2.0 * half.y, listener_};
    std::array<bool, kinds> on_{};
    double now_ = 0.0;
    Vec2 hand_{0.0}, place_{0.0};
    bool open_ = false;
    QString complaint_;
};

} // namespace

class DrawnSchedulesTest : public QObject {
    Q_OBJECT
private slots:
    void whatever_goes_wrong_it_stays_on_the_surface_and_ends() {
        for (int number = first_schedule(); number < first_schedule() + schedules(); ++number) {
            const QString complaint = Schedule(number).complaint();
            QVERIFY2(complaint.isEmpty(), qPrintable(QString("schedule %1: %2").arg(number).arg(complaint)));
        }
    }

    void friction_that_is_not_asked_for_again_ends() {
        DrawnTouch touch(2.0 * half.x, 2.0 * half.y, nullptr);
        QVERIFY(touch.open().ok());
        touch.set_down({0.0, 0.0});
        touch.read(0.0);
        touch.resist(1.0);
        touch.move_hand({30.0, 0.0});
        const double lasts = TouchOutput::friction_lasts_s;
        double held = 0.0;
        for (double now = step_s; now < lasts; now += step_s)
            held = 30.0 - touch.read(now)->place.x;
        QVERIFY(held > 5.0);
        for (double now = lasts; now < lasts + settled_s; now += step_s)
            held = 30.0 - touch.read(now)->place.x;
        QVERIFY(held < 0.1);
    }
};

QTEST_APPLESS_MAIN(DrawnSchedulesTest)
#include "fault_schedules_test.moc"
