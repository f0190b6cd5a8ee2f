// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/stick_scale_file.hpp"

#include "core/base/result.hpp"
#include "core/files/whole_file.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <locale>
#include <sstream>

namespace tp {

namespace {

constexpr std::string_view stick_scale_head = "touchphoto sticks 1\n";
constexpr std::size_t largest_scale_file = 1 << 16;
constexpr double least_newtons = 0.5;
constexpr double greatest_newtons = 200.0;

} // namespace

std::optional<StickScale> stick_scale_in(std::string_view text, std::string_view key) {
    std::optional<StickScale> found;
    if (!text.starts_with(stick_scale_head))
        return found;
    std::istringstream lines{std::string(text.substr(stick_scale_head.size()))};
    std::string line;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        StickScale scale;
        std::string name;
        if (!(words >> scale.newtons_at_full >> scale.sign.x >> scale.sign.y >> std::ws) ||
            !std::getline(words, name))
            continue;
        const bool sane = scale.newtons_at_full >= least_newtons &&
                          scale.newtons_at_full <= greatest_newtons && std::abs(scale.sign.x) == 1.0 &&
                          std::abs(scale.sign.y) == 1.0;
        if (!sane || name != key)
            continue;
        scale.measured = true;
        found = scale;
    }
    return found;
}

StickScale kept_stick_scale(const std::filesystem::path& file, std::string_view key) {
    if (file.empty() || key.empty())
        return {};
    const Result<std::string> text = read_whole(file, largest_scale_file);
    return text.ok() ? stick_scale_in(*text, key).value_or(StickScale{}) : StickScale{};
}

std::filesystem::path stick_scale_file() {
    if (const char* const config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && config[0] == '/')
        return std::filesystem::path(config) / "touchphoto" / "sticks.txt";
    if (const char* const home = std::getenv("HOME"); home != nullptr && home[0] == '/')
        return std::filesystem::path(home) / ".config" / "touchphoto" / "sticks.txt";
    return {};
}

} // namespace tp
