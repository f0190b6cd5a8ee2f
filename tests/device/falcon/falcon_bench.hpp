// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../closed_loop/loop_bench.hpp"
#include "device/falcon/falcon.hpp"
#include "device/falcon/simulated_falcon_link.hpp"

#include <cstdint>
#include <memory>
#include <span>
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

/// A model Falcon on a simulated cable.
struct FalconBench : LoopBench {
    ModelFalcon model;
    SimulatedFalconLink link;
    Falcon device{lend(link), [] { return falcon_image(); }, "F-1", LatestWriter::Thread::caller};
    bool has_watchdog = false;

    explicit FalconBench(const FalconPlant& plant = {}, unsigned delay_ms = 0, std::uint32_t seed = 1)
        : model(falcon_image(), plant), link(model, delay_ms, seed) {
        model.run_firmware(true);
        has_watchdog = plant.watchdog_ms > 0;
        begin(device, device.open());
    }
    ~FalconBench() override { loop.reset(); }

    Vec2 felt() const override { return {model.force().x, model.force().y}; }
    bool lets_go() const override { return model.force() == glm::dvec3(0.0); }
    Vec2 handle() const override { return {1000.0 * model.grip().x, 1000.0 * model.grip().y}; }
    void place(Vec2 there) override { model.place_grip(falcon_place(there)); }
    void move_hand(Vec2 there) override { model.move_hand(falcon_place(there)); }
    bool& unplugged() override { return link.troubles.unplugged; }

protected:
    void deliver() override { device.deliver(); }
    void advance() override { link.advance(); }
};

} // namespace tp::testing
