// SPDX-License-Identifier: Apache-2.0
#include "device/guard/guard_process.hpp"

namespace tp {

std::string guard_word(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += "0123456789abcdef"[byte >> 4];
        text += "0123456789abcdef"[byte & 15u];
    }
    return text;
}

} // namespace tp
