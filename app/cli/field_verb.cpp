// SPDX-License-Identifier: Apache-2.0
#include "app/cli/guidance_options.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/verbs.hpp"
#include "app/photo/picture/field_picture.hpp"
#include "app/photo/picture/picture_file.hpp"

namespace tp {

int field_verb(const QStringList& words) {
    VerbLine line("field",
                  "Draws the force field of a scene: the size of the force as colour, arrows along it, the\n"
                  "contours, a scale in newtons and millimetres.");
    line.option("scene", "The scene.", "SCENE.svg")
        .output("out", "Where the picture goes; its ending says which kind.", "FIELD.png")
        .option("scale", "Pixels a millimetre.", "px/mm", "5");
    add_guidance_options(line);
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    if (!line.has("scene") || !line.has("out"))
        return wrong_usage("field", "--scene SCENE.svg and --out FIELD.png are both needed.");
    const auto options = guidance_options(line);
    const auto scale = line.positive("scale");
    if (!options || !scale)
        return wrong_usage("field", options ? scale.error() : options.error());
    const auto out = line.output_file(line.text("out"));
    if (!out)
        return refused(out.error());
    const auto loaded = load_scene(line.text("scene"), *options);
    if (!loaded) {
        say_problem(loaded.error(), line.text("scene").toStdString());
        return exit_bad_input;
    }
    LongWork::step("drawing the force field");
    const QImage drawn = draw_force_field(*loaded->haptic, loaded->scene.surface(), *scale, {},
                                          LongWork::stop_token(), LongWork::share);
    LongWork::step("writing the picture");
    const ForeignFolder held = held_around(*out);
    const auto written = write_image(*out, drawn);
    return written ? int{exit_done} : refused(written.error());
}

} // namespace tp
