// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/servo_loop.hpp"
#include "device/falcon/falcon.hpp"
#include "device/falcon/simulated_falcon_link.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tp::testing {

/// Lets a link that a test keeps be opened.
class BorrowedFalconLink : public FalconLink {
public:
    explicit BorrowedFalconLink(FalconLink& lent) : lent_(lent) {}
    bool control(const falcon::ftdi::Request& request) noexcept override { return lent_.control(request); }
    UsbGot read(UsbPacket& packet, int wait_ms) noexcept override { return lent_.read(packet, wait_ms); }
    bool write(std::span<const std::uint8_t> bytes) noexcept override { return lent_.write(bytes); }
    Result<std::unique_ptr<ForceGuard>> guard(std::span<const std::uint8_t> no_force) override {
        return lent_.guard(no_force);
    }

private:
    FalconLink& lent_;
};

inline Falcon::Opener lend(FalconLink& link) {
    return [&link]() -> Result<std::unique_ptr<FalconLink>> {
        return std::unique_ptr<FalconLink>(std::make_unique<BorrowedFalconLink>(link));
    };
}

inline std::vector<std::uint8_t> falcon_image() {
    std::vector<std::uint8_t> image(7914);
    for (std::size_t i = 0; i < image.size(); ++i)
        image[i] = static_cast<std::uint8_t>((i * 131) ^ (i >> 5));
    return image;
}

/// A place in the plane of the port, mm, and in front of it, mm towards the person.
inline falcon::Place falcon_place(Vec2 mm, double before = 0.0) {
    return {1e-3 * mm.x, 1e-3 * mm.y, falcon::plane_z + 1e-3 * before};
}

/// A model Falcon on a simulated cable, its back end and a servo loop, all in simulated time.
struct FalconBench {
    ModelFalcon model;
    SimulatedFalconLink link;
    Falcon device{lend(link), [] { return falcon_image(); }, "F-1", LatestWriter::Thread::caller};
    VirtualClock clock;
    Capabilities can;
    std::string error;
    std::unique_ptr<ServoLoop> loop;
    bool writer_stalled = false;
    std::function<void()> after_tick = [] {};

    explicit FalconBench(const FalconPlant& plant = {}, unsigned delay_ms = 0, std::uint32_t seed = 1)
        : model(falcon_image(), plant), link(model, delay_ms, seed) {
        model.run_firmware(true);
        const Result<Capabilities> opened = device.open();
        if (!opened.ok()) {
            error = opened.error();
            return;
        }
        can = *opened;
        loop = std::make_unique<ServoLoop>(device, can, clock, ServoSettings{});
    }
    /// The loop stops the device as it ends: before the link goes.
    ~FalconBench() { loop.reset(); }
    FalconBench(const FalconBench&) = delete;
    FalconBench& operator=(const FalconBench&) = delete;

    void render(std::vector<Contour> lines) {
        auto made = make_haptic_scene(Scene{300.0, 300.0, std::move(lines)});
        loop->render(std::move(made).value());
        loop->engage();
    }
    void tick(double dt = 0.001) {
        clock.sleep_until(clock.now() + dt);
        loop->tick();
        if (!writer_stalled)
            device.deliver();
        for (double t = 0.0005; t < dt; t += 0.001)
            link.advance();
        after_tick();
    }
    void run(double seconds) {
        for (double t = 0.0005; t < seconds; t += 0.001)
            tick();
    }
    Vec2 felt() const { return {model.force().x, model.force().y}; }
    Vec2 grip_mm() const { return {1000.0 * model.grip().x, 1000.0 * model.grip().y}; }
};

} // namespace tp::testing
