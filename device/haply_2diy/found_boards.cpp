// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/found_boards.hpp"

#include <algorithm>

namespace tp {

namespace {

char upper(char letter) {
    return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
}

} // namespace

bool is_arduino(std::string_view vendor) {
    constexpr std::string_view numbers[] = {"2341", "2A03"};
    return std::any_of(std::begin(numbers), std::end(numbers), [vendor](std::string_view number) {
        return std::equal(vendor.begin(), vendor.end(), number.begin(), number.end(),
                          [](char a, char b) { return upper(a) == upper(b); });
    });
}

bool is_arduino_instance(std::string_view instance) {
    constexpr std::string_view before = "USB\\VID_";
    constexpr std::size_t digits = 4;
    return instance.starts_with(before) && is_arduino(instance.substr(before.size(), digits));
}

std::string serial_number_in(std::string_view instance) {
    const std::size_t slash = instance.rfind('\\');
    const std::string_view last = slash == std::string_view::npos ? "" : instance.substr(slash + 1);
    return last.find('&') == std::string_view::npos ? std::string(last) : std::string();
}

} // namespace tp
