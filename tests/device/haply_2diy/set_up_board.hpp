// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/haply_2diy/model_board.hpp"
#include "device/haply_2diy/protocol/board_frames.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace tp::testing {

/// A model board that a test speaks to byte for byte.
struct Board {
    Pantograph arms;
    ModelBoard model;
    explicit Board(HaplyGeneration generation = HaplyGeneration::third, const HaplyPlant& plant = {})
        : arms(generation), model(generation, plant) {}

    void hear(std::span<const std::uint8_t> bytes) {
        for (const std::uint8_t byte : bytes)
            model.receive(byte);
    }
    void set_up() { hear(haply::encode(arms.set_up(arms.reference_deg())).view()); }
    /// Its answer to torques, by arm.
    std::optional<haply::Reply> ask(const std::array<double, 2>& torques = {}) {
        hear(haply::encode(arms.command_of(torques)));
        return said();
    }
    std::optional<haply::Reply> said() {
        std::array<std::uint8_t, haply::reply_size> bytes{};
        if (model.sent().size() != bytes.size())
            return std::nullopt;
        std::copy(model.sent().begin(), model.sent().end(), bytes.begin());
        model.sent().clear();
        return haply::decode_reply(bytes);
    }
};

} // namespace tp::testing
