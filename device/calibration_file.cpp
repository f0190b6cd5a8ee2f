// SPDX-License-Identifier: Apache-2.0
#include "device/calibration_file.hpp"

#include "core/files/durable_file.hpp"
#include "core/files/whole_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace tp {

namespace {

constexpr std::string_view first_line = "touchphoto calibrations 1\n";
constexpr std::size_t largest_file = 1 << 20;
constexpr double most_stretch = 2.0;
constexpr double farthest_mm = 1e5;

bool is_key(std::string_view key) {
    return !key.empty() && key.front() != ' ' &&
           std::ranges::none_of(key, [](char c) { return static_cast<unsigned char>(c) < 0x20u || c == 0x7F; });
}

/// The next word of a line as a number; takes it and the space behind it away.
template <typename Number>
bool take(std::string_view& line, Number& number) {
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    const auto length = static_cast<std::size_t>(end - line.data());
    if (error != std::errc{} || length >= line.size() || line[length] != ' ')
        return false;
    line.remove_prefix(length + 1);
    return true;
}

template <typename Number>
void put(std::string& text, Number number) {
    std::array<char, 32> word{};
    text.append(word.data(), std::to_chars(word.data(), word.data() + word.size(), number).ptr);
    text += ' ';
}

} // namespace

bool is_plausible(const Affine& map) {
    const double trace = glm::dot(map.linear[0], map.linear[0]) + glm::dot(map.linear[1], map.linear[1]);
    const double det = map.determinant();
    const double root = std::sqrt(std::max(0.0, trace * trace - 4.0 * det * det));
    const double most = std::sqrt(0.5 * (trace + root)); // the singular values
    const double least = std::sqrt(0.5 * std::max(0.0, trace - root));
    return most <= most_stretch && least >= 1.0 / most_stretch && std::abs(map.offset.x) < farthest_mm &&
           std::abs(map.offset.y) < farthest_mm;
}

std::string text_of(const Calibrations& calibrations) {
    std::string text(first_line);
    for (const auto& [key, calibration] : calibrations) {
        if (!is_key(key))
            continue;
        const Affine& map = calibration.device_to_surface;
        for (const double number : {map.linear[0].x, map.linear[0].y, map.linear[1].x, map.linear[1].y, map.offset.x,
                                    map.offset.y, calibration.residual_mm})
            put(text, number);
        put(text, calibration.used);
        text += key;
        text += '\n';
    }
    return text;
}

Calibrations calibrations_in(std::string_view text) {
    Calibrations found;
    if (!text.starts_with(first_line))
        return found;
    text.remove_prefix(first_line.size());
    while (!text.empty()) {
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        Calibration one;
        Affine& map = one.device_to_surface;
        const bool whole = take(line, map.linear[0].x) && take(line, map.linear[0].y) && take(line, map.linear[1].x) &&
                           take(line, map.linear[1].y) && take(line, map.offset.x) && take(line, map.offset.y) &&
                           take(line, one.residual_mm) && take(line, one.used) && is_key(line);
        if (whole && is_plausible(map) && one.residual_mm >= 0.0 && one.residual_mm <= most_residual_mm)
            found.insert_or_assign(std::string(line), one);
    }
    return found;
}

std::optional<Calibration> kept_calibration(const std::filesystem::path& file, const std::string& key) {
    const Result<std::string> text = read_whole(file, largest_file);
    if (!text)
        return std::nullopt;
    const Calibrations all = calibrations_in(*text);
    const auto found = all.find(key);
    return found == all.end() ? std::nullopt : std::optional(found->second);
}

std::string keep_calibration(const std::filesystem::path& file, const std::string& key, const Calibration& calibration) {
    const auto not_kept = [](const std::string& why) { return "The calibration could not be saved: " + why; };
    if (!is_key(key))
        return not_kept("the device has no name to keep it by.");
    Calibrations all;
    if (!is_gone(file)) {
        const Result<std::string> text = read_whole(file, largest_file);
        if (!text)
            return not_kept(text.error());
        all = calibrations_in(*text);
    }
    all.insert_or_assign(key, calibration);
    std::string why = make_folder(file.parent_path(), Readers::owner_only);
    if (why.empty())
        why = replace_file(file, text_of(all), Readers::owner_only);
    return why.empty() ? std::string() : not_kept(why);
}

} // namespace tp
