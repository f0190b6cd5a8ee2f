// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/falcon/model_falcon.hpp"
#include "falcon_bench.hpp"

#include <cstdint>
#include <optional>

namespace tp::testing {

/// A model with a line that is quick, as a running Falcon's.
struct QuickFalcon {
    ModelFalcon model;
    falcon::PacketStream stream;

    explicit QuickFalcon(const FalconPlant& plant = {}) : model(falcon_image(), plant) {
        model.run_firmware(true);
        model.control(falcon::ftdi::latency(1));
        model.control(falcon::ftdi::baud_1500000);
    }
    /// The last reply that is there.
    std::optional<falcon::Reply> heard() {
        std::optional<falcon::Reply> newest;
        UsbPacket packet;
        while (model.packet(packet))
            for (const std::uint8_t byte : falcon::ftdi::received(packet.content()).payload)
                if (const std::optional<falcon::Packet> whole = stream.push(byte))
                    newest = falcon::decode_reply(*whole);
        return newest;
    }
    std::optional<falcon::Reply> ask(const falcon::Command& command = {}) {
        model.send(falcon::encode(command));
        model.step();
        return heard();
    }
};

} // namespace tp::testing
