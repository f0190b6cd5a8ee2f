// SPDX-License-Identifier: Apache-2.0
// The pad without hardware, of which nothing is read back through what it is to try.
#include "device/force_pad/model_pad.hpp"
#include "test_program.hpp"

#include <QTest>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace model_pad_test {

using namespace tp;

namespace {

pad::StateFrame state_of(ModelPad& model) {
    pad::StateFrame state;
    pad::Frame frame;
    while (model.report(frame))
        pad::decode(frame, state);
    return state;
}

/// Armed, and asked for a force for so long that its ramp has ended.
pad::StateFrame pull(ModelPad& model, int x_mn, int y_mn, int milliseconds = 20) {
    static std::uint16_t sequence = 0;
    model.step();
    model.receive(pad::encode(pad::ForceFrame{++sequence, 0, 0, true}));
    for (int i = 0; i < milliseconds; ++i) {
        model.receive(pad::encode(pad::ForceFrame{++sequence, static_cast<std::int16_t>(x_mn),
                                                  static_cast<std::int16_t>(y_mn), true}));
        model.step();
    }
    return state_of(model);
}

/// So heavy that it stays where it is put.
PadPlant anvil() {
    PadPlant plant;
    plant.mass = 1e9;
    return plant;
}

} // namespace

class ModelPadTest : public QObject {
    Q_OBJECT
private slots:
    void a_pad_that_was_homed_when_it_was_switched_on_says_where_it_is_and_nothing_else() {
        ModelPad model(pad::cable_pad());
        pad::Frame frame;
        QVERIFY(!model.report(frame));
        model.step();
        QVERIFY(model.report(frame));
        QCOMPARE(pad::type_of(frame), pad::FrameType::state);
        QVERIFY(!model.report(frame));
    }

    void its_clock_counts_milliseconds() {
        ModelPad model(pad::cable_pad());
        for (std::uint32_t i = 1; i <= 5; ++i) {
            model.step();
            QCOMPARE(state_of(model).time_us, 1000 * i);
        }
    }

    /// On its mark and elsewhere; the pantograph's mark is where its angles are 130 and 50 degrees.
    void its_encoders_say_where_the_knob_is() {
        ModelPad cables(pad::cable_pad());
        QVERIFY(length(cables.knob()) < 1e-6);
        ModelPad bars(pad::pantograph_pad());
        QVERIFY(std::abs(bars.knob().x - 19.0) < 1e-3);
        QVERIFY(std::abs(bars.knob().y - 116.9) < 0.1);
        for (const Vec2 off : {Vec2(0.0), Vec2(30.0, -20.0), Vec2(-45.0, -38.0)})
            for (ModelPad* const model : {&cables, &bars}) {
                const Vec2 place = (model == &bars ? Vec2(19.0, 120.0) : Vec2(0.0)) + off;
                model->place_knob(place);
                QVERIFY(model->knob() == place);
                model->step();
                const pad::StateFrame state = state_of(*model);
                QVERIFY(length(1e-3 * Vec2(state.x_um, state.y_um) - place) < 0.03);
                QCOMPARE(int(state.status) & ~pad::status::outside, 0);
            }
    }

    void its_motors_pull_its_knob_as_the_firmware_says() {
        for (const pad::PadConfig& config : {pad::cable_pad(), pad::pantograph_pad()})
            for (const Vec2 off : {Vec2(0.0), Vec2(20.0, -15.0), Vec2(-40.0, -10.0)}) {
                ModelPad model(config, anvil());
                model.place_knob(model.knob() + off);
                const pad::StateFrame state = pull(model, 800, -500);
                QVERIFY(state.status & pad::status::armed);
                QVERIFY(length(model.force() - Vec2(0.8, -0.5)) < 0.003);
            }
    }

    void a_knob_that_is_free_follows_the_force_and_a_hand_holds_it() {
        ModelPad free(pad::cable_pad());
        pull(free, 800, 0, 100);
        QVERIFY(free.knob().x > 5.0 && std::abs(free.knob().y) < 0.1);
        PadPlant held;
        held.hand_stiffness = 1.0;
        held.hand_damping = 10.0;
        ModelPad model(pad::cable_pad(), held);
        model.move_hand({3.0, 0.0});
        for (int i = 0; i < 500; ++i)
            model.step();
        QVERIFY(std::abs(model.knob().x - 3.0) < 0.1);
    }

    /// A cable without length has no direction, and its tension is then on no side.
    void on_an_exit_the_other_cables_pull() {
        ModelPad model(pad::cable_pad(), anvil());
        model.place_knob({150.0, 110.0});
        const pad::StateFrame state = pull(model, -800, -800);
        QVERIFY(state.status & pad::status::armed);
        QVERIFY(model.force().x < -0.3 && model.force().y < -0.3);
    }

    /// As if its links were stretched towards it, or folded away from it.
    void a_knob_out_of_a_pantographs_reach_has_angles_all_the_same() {
        ModelPad model(pad::pantograph_pad());
        model.place_knob({19.0, 500.0});
        model.step();
        pad::StateFrame state = state_of(model);
        QVERIFY(std::abs(1e-3 * state.x_um - 19.0) < 0.1);
        QVERIFY(std::abs(1e-3 * state.y_um - 158.5) < 0.1);
        model.place_knob({0.0, 5.0}); // within 20 mm of a motor, where its links cannot fold to
        model.step();
        state = state_of(model);
        QVERIFY(std::abs(1e-3 * state.x_um + 9.9) < 1.0);
        QVERIFY(std::abs(1e-3 * state.y_um - 19.4) < 1.0);
    }

    void each_trouble_is_one_that_the_firmware_notices() {
        for (std::size_t drum = 0; drum < 4; ++drum) {
            ModelPad model(pad::cable_pad(), anvil());
            model.troubles.slip_mm[drum] = 4.0;
            model.step();
            const pad::StateFrame state = state_of(model);
            QVERIFY(state.status & pad::status::unsure);
            QVERIFY(state.residual_um > 1000 && state.residual_um < 4000);
        }
        ModelPad model(pad::cable_pad(), anvil());
        QVERIFY(pull(model, 500, 0).status & pad::status::armed);
        model.troubles.celsius = 71;
        model.step();
        const pad::StateFrame hot = state_of(model);
        QVERIFY(hot.status & pad::status::hot);
        QCOMPARE(int(hot.celsius), 71);
        QVERIFY(model.force() == Vec2(0.0));
        model.troubles.celsius = 25;
        QVERIFY(pull(model, 500, 0).status & pad::status::armed);
        model.troubles.current_ma = 801;
        model.step();
        QVERIFY(state_of(model).status & pad::status::over_current);
        model.restart();
        model.step();
        const pad::StateFrame anew = state_of(model);
        QVERIFY(anew.status & pad::status::not_homed);
        QCOMPARE(int(anew.sequence), 1);
    }
};

} // namespace model_pad_test

TP_TEST(model_pad_test, ModelPadTest, nothing)
#include "model_pad_test.moc"
