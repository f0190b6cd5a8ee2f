// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/photo/scene/corrections.hpp"
#include "app/photo/scene/extra_features.hpp"
#include "app/photo/scene/scene_builder.hpp"
#include "core/files/file_words.hpp"
#include "core/guidance/spacing.hpp"
#include "core/svg/contour_sheet.hpp"
#include "faces/extract/face_extractor.hpp"

#include <cstdio>

namespace tp {

namespace {

constexpr double smallest_surface_mm = 20.0; // something is left inside the margins
constexpr double largest_surface_mm = 2000.0;

void print_spacing(const Scene& scene) {
    const FlatScene flat = flatten(scene);
    print("gap_mm,peak_n,tellable,first,second\n");
    const TentProfile profile;
    const std::vector<Closeness> pairs = closeness(flat, profile);
    for (const Closeness& pair : pairs)
        print("%.3f,%.3f,%d,%s,%s\n", pair.gap, pair.peak, pair.tellable ? 1 : 0,
              readable(flat.names[static_cast<std::size_t>(pair.first)]).c_str(),
              readable(flat.names[static_cast<std::size_t>(pair.second)]).c_str());
    if (const auto better = proposed_profile(pairs, profile)) {
        char sentence[160];
        std::snprintf(sentence, sizeof sentence,
                      "With --range %.1f --stiffness %.2f fewer pulls would meet between the contours.",
                      better->range, better->stiffness);
        say(sentence);
    }
}

void say_narrow_eyes(const BuiltScene& built) {
    const std::optional<double> width = narrowest_eye_mm(built);
    if (!width || *width >= least_eye_mm)
        return;
    char sentence[160];
    std::snprintf(
        sentence, sizeof sentence,
        "An eye is %.1f mm wide here, and a finger wants %.0f mm: a single face (--face) or a larger surface "
        "makes it wider.",
        *width, least_eye_mm);
    say(sentence);
}

} // namespace

int scene_verb(const QStringList& words) {
    const SurfaceSize usual;
    VerbLine line("scene", "Writes the scene that the Explore page would render for a photograph.");
    line.output("out", "Where the scene goes.", "SCENE.svg")
        .option("width", "Width of the touch surface.", "mm", QString::number(usual.width_mm))
        .option("height", "Height of the touch surface.", "mm", QString::number(usual.height_mm))
        .option(
            "spacing",
            "Writes to stdout which contours come close to each other: gap in mm, the strongest pull\n"
            "left between them in N, whether a finger can tell them apart, and their names. Proposes\n"
            "another range and stiffness to stderr where that would help, and says there where an eye is\n"
            "narrower than 25 mm.")
        .option("with", "Adds features to eyes, lips and outline: brows, nose, irises.", "LIST")
        .option("face", "Fits this face (1 is the largest) instead of all of them.", "number")
        .argument("PHOTO", "JPEG, PNG or WebP.");
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    if (!line.has("out"))
        return wrong_usage("scene", "--out SCENE.svg is missing.");
    const auto out = line.output_file(line.text("out"));
    if (!out)
        return refused(out.error());
    const Result<double> width = line.positive("width");
    const Result<double> height = line.positive("height");
    if (!width || !height)
        return wrong_usage("scene", width ? height.error() : width.error());
    for (const double side : {*width, *height})
        if (side < smallest_surface_mm || side > largest_surface_mm)
            return wrong_usage("scene", "--width and --height of a touch surface are from 20 to 2000 mm.");
    std::optional<std::size_t> face;
    if (line.has("face")) {
        const int number = line.text("face").toInt();
        if (number < 1)
            return wrong_usage("scene", "--face needs a number from 1 on.");
        face = static_cast<std::size_t>(number - 1);
    }

    const auto extras = extra_features_named(line.text("with").toStdString());
    if (!extras)
        return wrong_usage("scene", extras.error());

    LongWork::step("looking at " + line.arguments().first().toStdString());
    auto extractor = FaceExtractor::create();
    if (!extractor) {
        say_problem(extractor.error());
        return exit_bad_input;
    }
    const std::string photo = line.arguments().first().toStdString();
    const Extraction found = with_extras(with_corrections(extractor->extract(photo), photo), *extras);
    const auto built = build_scene(found, {*width, *height, usual.margin_mm, {}}, face);
    if (!built) {
        say_problem(built.error(), photo);
        return exit_bad_input;
    }
    if (!found.problem.empty())
        say_problem(found.problem, photo);
    const ForeignFolder held = held_around(*out);
    const auto written = write_sheet(*out, sheet_from_scene(built->scene));
    if (!written) {
        say_problem(written.error());
        return exit_bad_input;
    }
    if (line.has("spacing")) {
        print_spacing(built->scene);
        say_narrow_eyes(*built);
    }
    return found.problem.empty() ? exit_done : exit_bad_input;
}

} // namespace tp
