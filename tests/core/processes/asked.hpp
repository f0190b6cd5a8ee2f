// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/processes/helper.hpp"
#include "core/processes/our_programs.hpp"

#include <QString>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

// What tests ask helper_double, and what it answers.
namespace tp::test {

inline const std::filesystem::path double_program = beside_this_program("helper_double");

inline Message order(std::string_view word, std::string_view object = {}) {
    return MessageWriter().add(word).add(object).take();
}

inline std::string text_in(std::variant<Message, NoAnswer> answer) {
    auto* const message = std::get_if<Message>(&answer);
    return message ? MessageReader(*message).text() : std::string("no answer");
}

inline std::int64_t number_in(std::variant<Message, NoAnswer> answer) {
    auto* const message = std::get_if<Message>(&answer);
    return message ? MessageReader(*message).number() : std::int64_t{-2};
}

/// No answer's reason, as text for a comparison.
inline QString reason_in(const std::variant<Message, NoAnswer>& answer) {
    const auto* const none = std::get_if<NoAnswer>(&answer);
    return none == nullptr ? "an answer" : *none == NoAnswer::gone ? "gone" : "too long";
}

} // namespace tp::test
