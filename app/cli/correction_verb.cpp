// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/figures/report/field_difference.hpp"
#include "app/photo/picture/field_picture.hpp"
#include "app/photo/picture/picture_file.hpp"
#include "app/photo/scene/corrections.hpp"
#include "app/photo/scene/scene_builder.hpp"
#include "core/files/file_words.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/extract/face_extractor.hpp"

#include <cstdio>

namespace tp {

namespace {

using HapticPtr = std::unique_ptr<HapticScene>;

std::string percent(const std::optional<double>& value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value.value_or(0.0));
    return value ? text : "";
}

void print_features(const Extraction& found, const Extraction& mended,
                    const std::optional<Extraction>& truth) {
    print("feature,moved_percent,error_before_percent,error_after_percent\n");
    for (std::size_t i = 0; i < mended.faces.size(); ++i) {
        const Face& after = mended.faces[i];
        const Face* before = nullptr; // the face of the program that lies in the same place
        for (const Face& face : found.faces)
            if (face.box.min == after.box.min && face.box.max == after.box.max)
                before = &face;
        const std::vector<Contour>* right =
            truth && i < truth->faces.size() ? &truth->faces[i].contours : nullptr;
        const auto error = [&](const std::vector<Contour>& of, const std::string& name) {
            return right ? contour_error_percent(*right, of, name) : std::nullopt;
        };
        for (const std::string& name : after.mended)
            print(
                "%s%s,%s,%s,%s\n",
                mended.faces.size() > 1 ? ("face " + std::to_string(i + 1) + " ").c_str() : "",
                readable(name).c_str(),
                percent(before ? contour_error_percent(after.contours, before->contours, name) : std::nullopt)
                    .c_str(),
                percent(before ? error(before->contours, name) : std::nullopt).c_str(),
                percent(error(after.contours, name)).c_str());
    }
}

/// The field of `extraction` as it lies on the surface under `photo_to_surface`.
Result<HapticPtr> field_of(const Extraction& extraction, const SurfaceSize& surface,
                           const Affine& photo_to_surface) {
    return make_haptic_scene(scene_of(extraction.faces, surface, photo_to_surface));
}

std::string sentence_about(const FieldDifference& difference) {
    char text[240];
    std::snprintf(text, sizeof text,
                  "The force differs by %.3f N on average where there is one, by at most %.2f N, and by more "
                  "than a finger notices (%.2f N) on %.1f %% of the surface.",
                  difference.mean_n, difference.max_n, FieldDifference::noticed_n,
                  100.0 * difference.felt_share);
    return text;
}

std::string judgement(const FieldDifference& before, const FieldDifference& after) {
    char text[240];
    std::snprintf(text, sizeof text,
                  "Against the truth the mean force error is %.4f N before and %.4f N after: the correction "
                  "%s what is felt.",
                  before.mean_n, after.mean_n,
                  after.mean_n < before.mean_n   ? "improves"
                  : after.mean_n > before.mean_n ? "does not improve"
                                                 : "does not change");
    return text;
}

class CorrectionVerb {
public:
    explicit CorrectionVerb(const VerbLine& line)
        : line_(line), photo_(line.arguments().first().toStdString()) {}

    /// A sentence where something is wrong; else empty.
    std::string run() {
        LongWork::step("looking at " + photo_);
        auto extractor = FaceExtractor::create();
        if (!extractor)
            return extractor.error();
        const Extraction found = extractor->extract(photo_);
        if (found.width == 0)
            return found.problem;
        const auto sheet = read_sheet(correction_file(photo_), ContourSheet::Unit::pixel);
        if (!sheet)
            return sheet.error();
        const auto mended = corrected(found, *sheet);
        if (!mended)
            return "The mended contours cannot be used: " + mended.error();
        std::optional<Extraction> truth;
        if (line_.has("truth")) {
            const auto true_sheet = read_sheet(line_.text("truth").toStdString(), ContourSheet::Unit::pixel);
            if (!true_sheet)
                return true_sheet.error();
            const auto placed = corrected(found, *true_sheet);
            if (!placed)
                return "The true contours cannot be used: " + placed.error();
            truth = *placed;
        }
        LongWork::step("comparing the force fields");
        print_features(found, *mended, truth);
        return compare_fields(found, *mended, truth);
    }

private:
    std::string compare_fields(const Extraction& found, const Extraction& mended,
                               const std::optional<Extraction>& truth) {
        const SurfaceSize surface;
        const auto built = build_scene(mended, surface);
        if (!built)
            return built.error();
        const auto after = field_of(mended, surface, built->photo_to_surface);
        const auto before = field_of(found, surface, built->photo_to_surface);
        if (!after || !before)
            return after ? "Without the correction there is nothing to feel: " + found.problem
                         : after.error();
        const Rect area = built->scene.surface();
        say(sentence_about(difference_between(*(*before)->law, *(*after)->law, area)));
        if (truth) {
            const auto right = field_of(*truth, surface, built->photo_to_surface);
            if (!right)
                return right.error();
            say(judgement(difference_between(*(*right)->law, *(*before)->law, area),
                          difference_between(*(*right)->law, *(*after)->law, area)));
        }
        if (!line_.has("out"))
            return {};
        HapticScene drawn;
        drawn.flat = (*after)->flat;
        drawn.profile = (*after)->profile;
        drawn.law = difference_law(*(*before)->law, *(*after)->law);
        const auto out = line_.output_file(line_.text("out"));
        if (!out)
            return out.error();
        const ForeignFolder held = held_around(*out);
        return write_image(*out, draw_force_field(drawn, area)).error();
    }

    const VerbLine& line_;
    std::string photo_;
};

} // namespace

int correction_verb(const QStringList& words) {
    VerbLine line("correction",
                  "Says what the corrections beside a photograph (PHOTO.contours.svg) change: how far each\n"
                  "mended contour moved, in percent of the distance between the outer eye corners, and how\n"
                  "differently it feels on the surface of the Explore page.");
    line.option("truth", "True contours: then also whether the correction improves what is felt.",
                "TRUTH.svg")
        .output("out", "Draws the difference of the force fields.", "DIFFERENCE.png")
        .argument("PHOTO", "JPEG, PNG or WebP.");
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    const std::string problem = CorrectionVerb(line).run();
    if (problem.empty())
        return exit_done;
    say_problem(problem, line.arguments().first().toStdString());
    return exit_bad_input;
}

} // namespace tp
