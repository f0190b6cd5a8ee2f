// SPDX-License-Identifier: Apache-2.0
#include "app/cli/guidance_options.hpp"
#include "app/cli/input_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "core/files/file_words.hpp"

#include <charconv>
#include <cstdio>
#include <iostream>
#include <string>

namespace tp {

namespace {

constexpr long places_a_word = 10'000;

/// Whoever writes the places may take their time.
bool next_place(std::string& text) {
    const PersonsTurn turn;
    return next_line(std::cin, text);
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }

/// Two numbers and nothing else but blanks between and round them.
std::optional<Vec2> parse_place(const std::string& text) {
    double numbers[2];
    const char* at = text.data();
    const char* const end = at + text.size();
    for (double& number : numbers) {
        while (at != end && is_blank(*at))
            ++at;
        if (at != end && *at == '+' && at + 1 != end && at[1] != '-')
            ++at;
        const auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc{})
            return std::nullopt;
        at = next;
    }
    while (at != end && is_blank(*at))
        ++at;
    return at == end ? std::optional(Vec2(numbers[0], numbers[1])) : std::nullopt;
}

/// The shortest text that reads back as the same number.
std::string exact_text(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value == 0.0 ? 0.0 : value).ptr;
    return {text, end};
}

} // namespace

int force_verb(const QStringList& words) {
    VerbLine line(
        "force",
        "Reads lines \"x y\" (mm, surface frame: origin at the scene's centre, y up) from stdin and\n"
        "writes \"fx fy distance contour-name\" (N, mm) for each; the name is - where the scene\n"
        "gives none. The scene's size is in mm, or 1 user unit is 1 mm; its named paths are the\n"
        "contours.");
    line.option("scene", "The scene.", "SCENE.svg");
    add_guidance_options(line);
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    if (!line.has("scene"))
        return wrong_usage("force", "--scene SCENE.svg is missing.");
    const auto options = guidance_options(line);
    if (!options)
        return wrong_usage("force", options.error());
    const auto loaded = load_scene(line.text("scene"), *options);
    if (!loaded) {
        say_problem(loaded.error(), line.text("scene").toStdString());
        return exit_bad_input;
    }

    LongWork::step("answering places");
    const HapticScene& haptic = *loaded->haptic;
    std::string text;
    for (long number = 1; next_place(text); ++number) {
        if (LongWork::stop_asked())
            return LongWork::stop_code();
        if (number % places_a_word == 0)
            LongWork::step("answered " + std::to_string(number) + " places");
        if (text.size() > most_line_bytes) {
            std::fflush(stdout);
            say_problem("Line " + std::to_string(number) +
                        " of the input is longer than two numbers can be.");
            return exit_bad_input;
        }
        if (text.find_first_not_of(" \t\r") == std::string::npos)
            continue;
        const auto place = parse_place(text);
        if (!place) {
            std::fflush(stdout);
            say_problem("Line " + std::to_string(number) + " of the input is not two numbers: \"" + text +
                        "\".");
            return exit_bad_input;
        }
        const Guidance at = haptic.law->at(*place);
        const std::string name =
            at.contour < 0 ? "-" : readable(haptic.flat.names[static_cast<std::size_t>(at.contour)]);
        print("%s %s %s %s\n", exact_text(at.force.x).c_str(), exact_text(at.force.y).c_str(),
              exact_text(at.distance).c_str(), name.c_str());
    }
    return exit_done;
}

} // namespace tp
