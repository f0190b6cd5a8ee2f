// SPDX-License-Identifier: Apache-2.0
#include "app/cli/guidance_options.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/verbs.hpp"
#include "app/photo/picture/friction_map.hpp"
#include "app/photo/picture/picture_file.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace tp {

namespace {

Result<FrictionChoices> friction_choices(const VerbLine& line) {
    FrictionChoices choices;
    const auto shape = ridge_named(line.text("ridge").toStdString());
    if (!shape)
        return Error{"--ridge is flat, tent or rounded, not " +
                     quoted_readable(line.text("ridge").toStdString()) + "."};
    choices.ridge = *shape;
    for (const auto& [name, value] : {std::pair("width", &choices.width_mm),
                                      {"strength", &choices.strength},
                                      {"stripes", &choices.texture_mm},
                                      {"stripe-strength", &choices.texture}}) {
        const auto given = line.positive(name);
        if (!given)
            return Error{given.error()};
        *value = *given;
    }
    for (const QString& name : line.text("texture").split(',', Qt::SkipEmptyParts))
        choices.textured.push_back(name.trimmed().toStdString());
    if (const std::string problem = choices.problem(); !problem.empty())
        return Error{problem};
    return choices;
}

/// A sentence where a name is none of the scene's closed contours.
std::string unknown_texture(const FlatScene& scene, const std::vector<std::string>& textured) {
    std::vector<std::string> closed;
    for (std::size_t i = 0; i < scene.names.size(); ++i)
        if (scene.lines[i].closed)
            closed.push_back(scene.names[i]);
    for (const std::string& name : textured) {
        if (std::ranges::find(closed, name) != closed.end())
            continue;
        std::string known;
        for (const std::string& other : closed)
            known += (known.empty() ? "it has " : ", ") + quoted_readable(other);
        return "The scene has no closed contour " + quoted_readable(name) + " for --texture; " +
               (known.empty() ? "it has none" : known) + ".";
    }
    return {};
}

} // namespace

int friction_verb(const QStringList& words) {
    VerbLine line(
        "friction",
        "Writes the friction of a scene as a grey picture, for electrostatic displays whose software\n"
        "takes one: 0 no friction, 255 all of it, true to scale. Such a display can only resist a\n"
        "finger that moves: the map says how much, where.");
    line.option("scene", "The scene.", "SCENE.svg")
        .output("out", "Where the picture goes; a PNG, because that keeps each grey.", "MAP.png")
        .option("dots", "Dots a millimetre.", "dots/mm", "10")
        .option("ridge", "How friction rises to a line: flat, tent or rounded.", "name", "rounded")
        .option("width", "Of the ridge on a line, edge to edge.", "mm", "2")
        .option("strength", "Friction on a line, above 0, at most 1.", "share", "1")
        .option("texture", "Closed contours with stripes inside: names with commas between.", "LIST")
        .option("stripes", "From stripe to stripe.", "mm", "2")
        .option("stripe-strength", "Friction on a stripe, above 0, at most 1.", "share", "0.4");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    if (!line.has("scene") || !line.has("out"))
        return wrong_usage("friction", "--scene SCENE.svg and --out MAP.png are both needed.");
    if (!line.text("out").endsWith(".png", Qt::CaseInsensitive))
        return wrong_usage("friction", "--out ends in .png: other pictures do not keep each grey as it is.");
    const auto choices = friction_choices(line);
    const auto dots = line.positive("dots");
    if (!choices || !dots)
        return wrong_usage("friction", choices ? dots.error() : choices.error());
    const auto out = line.output_file(line.text("out"));
    if (!out)
        return refused(out.error());
    const auto loaded = load_scene(line.text("scene"), {});
    if (!loaded) {
        say_problem(loaded.error(), line.text("scene").toStdString());
        return exit_bad_input;
    }
    if (const std::string problem = unknown_texture(loaded->haptic->flat, choices->textured);
        !problem.empty())
        return refused(problem);
    LongWork::step("drawing the friction map");
    const auto drawn = draw_friction_map(loaded->haptic->flat, *choices, loaded->scene.surface(), *dots,
                                         LongWork::stop_token(), LongWork::share);
    if (LongWork::stop_asked())
        return LongWork::stop_code();
    if (!drawn)
        return refused(drawn.error());
    LongWork::step("writing the picture");
    const ForeignFolder held = held_around(*out);
    const auto written = write_image(*out, *drawn);
    return written ? int{exit_done} : refused(written.error());
}

} // namespace tp
