// SPDX-License-Identifier: Apache-2.0
#include "device/hid_pid/joystick_scale_file.hpp"

#include "core/base/result.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/whole_file.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <locale>
#include <sstream>
#include <system_error>

namespace tp {

namespace {

constexpr std::string_view joystick_scale_head = "touchphoto sticks 1\n";
constexpr std::size_t largest_scale_file = 1 << 16;

/// One line's key and what it says, where it makes sense.
struct JoystickLine {
    JoystickScale scale;
    std::string key;
};

std::optional<JoystickLine> joystick_line(const std::string& line) {
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    JoystickLine found;
    JoystickScale& scale = found.scale;
    if (!(words >> scale.newtons_at_full >> scale.sign.x >> scale.sign.y >> std::ws) ||
        !std::getline(words, found.key))
        return std::nullopt;
    const bool sane = scale.newtons_at_full >= least_joystick_newtons &&
                      scale.newtons_at_full <= greatest_joystick_newtons && std::abs(scale.sign.x) == 1.0 &&
                      std::abs(scale.sign.y) == 1.0;
    scale.measured = true;
    return sane ? std::optional(found) : std::nullopt;
}

bool is_key(std::string_view key) {
    return !key.empty() && key.front() != ' ' && key.find_first_of("\n\r") == std::string_view::npos;
}

} // namespace

std::optional<JoystickScale> joystick_scale_in(std::string_view text, std::string_view key) {
    std::optional<JoystickScale> found;
    if (!text.starts_with(joystick_scale_head))
        return found;
    std::istringstream lines{std::string(text.substr(joystick_scale_head.size()))};
    std::string line;
    while (std::getline(lines, line))
        if (const std::optional<JoystickLine> one = joystick_line(line); one && one->key == key)
            found = one->scale;
    return found;
}

JoystickScale kept_joystick_scale(const std::filesystem::path& file, std::string_view key) {
    if (file.empty() || key.empty())
        return {};
    const Result<std::string> text = read_whole(file, largest_scale_file);
    return text.ok() ? joystick_scale_in(*text, key).value_or(JoystickScale{}) : JoystickScale{};
}

std::string keep_joystick_scale(const std::filesystem::path& file, const std::string& key,
                                const JoystickScale& scale) {
    const auto not_kept = [](const std::string& why) {
        return "What was measured of the stick could not be saved: " + why;
    };
    if (file.empty() || !is_key(key))
        return not_kept(file.empty() ? "there is no folder for settings."
                                     : "the stick has no name to keep it by.");
    std::string before;
    if (!is_gone(file)) {
        const Result<std::string> text = read_whole(file, largest_scale_file);
        if (!text.ok())
            return not_kept(text.error());
        before = *text;
    }
    std::ostringstream after;
    after.imbue(std::locale::classic());
    after << joystick_scale_head;
    if (before.starts_with(joystick_scale_head)) {
        std::istringstream lines(before.substr(joystick_scale_head.size()));
        for (std::string line; std::getline(lines, line);)
            if (const std::optional<JoystickLine> one = joystick_line(line); !one || one->key != key)
                after << line << '\n';
    }
    after << scale.newtons_at_full << ' ' << scale.sign.x << ' ' << scale.sign.y << ' ' << key << '\n';
    std::string why = make_folder(file.parent_path(), Readers::owner_only);
    if (why.empty())
        why = replace_file(file, after.str(), Readers::owner_only);
    return why.empty() ? std::string() : not_kept(why);
}

std::filesystem::path joystick_scale_file() {
    // NOLINTBEGIN(concurrency-mt-unsafe): nothing in the program changes its environment
    if (const char* const config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && config[0] == '/')
        return std::filesystem::path(config) / "touchphoto" / "sticks.txt";
    if (const char* const home = std::getenv("HOME"); home != nullptr && home[0] == '/')
        return std::filesystem::path(home) / ".config" / "touchphoto" / "sticks.txt";
    // NOLINTEND(concurrency-mt-unsafe)
    return {};
}

} // namespace tp
