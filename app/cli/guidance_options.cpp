// SPDX-License-Identifier: Apache-2.0
#include "app/cli/guidance_options.hpp"

#include "app/cli/long_work.hpp"
#include "core/files/file_name.hpp"
#include "core/files/file_words.hpp"
#include "core/svg/contour_sheet.hpp"

namespace tp {

void add_guidance_options(VerbLine& line) {
    line.option("law", "How the force is computed: exact, or published (Algorithm 1 of the paper).", "name",
                "exact")
        .option("stiffness", "K, the slope of the pull.", "N/mm", "0.2")
        .option("range", "d, the distance of the strongest pull; none beyond twice that.", "mm", "4")
        .option("blend", "Turns the force over a disc of this radius where the nearest contour changes.",
                "mm")
        .option("corner-cue", "A short tick at corners.");
}

Result<GuidanceOptions> guidance_options(const VerbLine& line) {
    const auto law = law_named(line.text("law").toStdString());
    if (!law)
        return Error{"--law is exact or published, not \"" + line.text("law").toStdString() + "\"."};
    const Result<double> stiffness = line.positive("stiffness");
    if (!stiffness)
        return Error{stiffness.error()};
    const Result<double> range = line.positive("range");
    if (!range)
        return Error{range.error()};
    GuidanceOptions options{*law, {*stiffness, *range}, {}};
    if (line.has("blend")) {
        const Result<double> blend = line.positive("blend");
        if (!blend)
            return Error{blend.error()};
        options.continuity.blend_mm = *blend;
    }
    options.continuity.corner_cue = line.has("corner-cue");
    return options;
}

Result<LoadedScene> load_scene(const QString& file, const GuidanceOptions& options) {
    LongWork::step("reading " + quoted(path_named(file.toStdString()).filename()));
    const Result<ContourSheet> sheet = read_sheet(file.toStdString());
    if (!sheet)
        return Error{sheet.error()};
    LongWork::step("preparing the scene to be felt");
    LoadedScene loaded{scene_from_sheet(*sheet), nullptr};
    auto haptic = make_haptic_scene(loaded.scene, options.profile, options.law, options.continuity);
    if (!haptic)
        return Error{haptic.error()};
    loaded.haptic = std::move(haptic).value();
    return loaded;
}

} // namespace tp
