// SPDX-License-Identifier: Apache-2.0
// learn_edge_look TRUTH.json PHOTOS [--keep GROUP]...: prints faces/edges/edge_look_weights.inc, learned
// from the people who are not held out of training (faces/training/holdout.txt), from where the embedded
// nets and the face mesh put their lines. The rows of a group that is kept (eyes, outer_lip,
// shut_mouth, open_mouth) are those that are compiled in; these have no other influence on what is printed.
//
// The weights of a kind of edge are a share of the likeliest ones (place_choice.hpp): points of a line see
// nearly the same picture and err together, so that each is worth only a part of what it says. How dear it
// is to leave the line and to bend it, and the ridge, are chosen by the contour error of people who were left
// out in turn. Figures of this on stderr.
#include "faces/base/face.hpp"
#include "faces/contours/contour_nets.hpp"
#include "faces/contours/mesh_model.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/edges/edge_fit.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/edge_pupils.hpp"
#include "faces/evaluation/edge_table.hpp"
#include "faces/evaluation/located_face.hpp"
#include "faces/evaluation/placed_truth.hpp"
#include "faces/evaluation/training_half.hpp"
#include "faces/models/model_catalog.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace tp;

namespace {

constexpr std::size_t folds = 8; ///< person i is left out in turn i mod 8
constexpr double ridges[] = {10.0, 100.0, 1000.0};
constexpr double price_levels[] = {0.35, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0}; ///< times the prices below

constexpr const char* kind_names[edge_kind_count] = {"lower lid",       "upper lid",      "outer lower lip",
                                                     "outer upper lip", "shut lower lip", "shut upper lip",
                                                     "open lower lip",  "open upper lip"};

/// Two kinds of edge at a time are judged by a contour.
enum GroupIndex : std::size_t { eyes, outer_lip, shut_mouth, open_mouth, group_count };
/// Only the ratio of share and prices decides where a line goes; the share sets the scale of clarity(), which
/// quality.cpp has limits for. These shares keep the mean clarity of each group near that of the earlier fit.
struct Group {
    const char* name;
    double share;       ///< of the likeliest weights
    double stray, bend; ///< prices, of which `price_levels` are multiples
};
constexpr Group groups[group_count] = {{"eyes", 0.4, 0.467, 8.0},
                                       {"outer_lip", 0.3, 0.12, 2.0},
                                       {"shut_mouth", 0.3, 0.04, 2.0},
                                       {"open_mouth", 0.3, 0.4, 2.0}};
constexpr GroupIndex group_of(std::size_t kind) { return static_cast<GroupIndex>(kind / 2); }

/// Mean contour errors of a group, percent of the outer inter-ocular distance.
struct Errors {
    std::array<double, group_count> sum{};
    std::array<int, group_count> count{};

    void add(GroupIndex group, double error) {
        sum[group] += error;
        ++count[group];
    }
    double mean(std::size_t group) const {
        return count[group] ? sum[group] / count[group] : std::numeric_limits<double>::infinity();
    }
};

/// Adds the errors of a person; without looks those of the lines as the models saw them.
void judge(const EdgePupil& pupil, const EdgeLooks* looks, Errors& errors) {
    const auto add_errors = [&](const LinedPortrait& portrait, const cv::Mat& view, const FaceLines& lines,
                                std::initializer_list<std::pair<GroupIndex, const char*>> judged) {
        const auto found = contours_of(looks ? on_edges(view, lines, nullptr, *looks) : lines);
        for (const auto& [group, name] : judged)
            errors.add(group, *contour_error_percent(portrait.truth, found, name));
    };
    for (const cv::Mat& view : pupil.neutral.views)
        for (const FaceLines& lines : pupil.neutral.seen)
            add_errors(pupil.neutral, view, lines,
                       {{eyes, feature::right_eye},
                        {eyes, feature::left_eye},
                        {outer_lip, feature::outer_lip},
                        {shut_mouth, feature::inner_lip}}); // nobody is neutral with an open mouth
    // The mesh's lines are the truth of smiles: only the nets' ones can be judged by it.
    if (pupil.smiles_openly())
        for (const cv::Mat& view : pupil.smiling.views)
            add_errors(pupil.smiling, view, pupil.smiling.seen.front(), {{open_mouth, feature::inner_lip}});
}

std::vector<PlaceChoice> lessons_of(const std::vector<EdgePupil>& pupils, std::size_t kind,
                                    std::size_t left_out = folds) {
    std::vector<PlaceChoice> lessons;
    for (std::size_t i = 0; i < pupils.size(); ++i)
        if (i % folds != left_out)
            lessons.insert(lessons.end(), pupils[i].lessons[kind].begin(), pupils[i].lessons[kind].end());
    return lessons;
}

struct Setting {
    double ridge = 0.0, price_level = 1.0, error = std::numeric_limits<double>::infinity();
};

/// From the likeliest weights.
EdgeLook priced(const cv::Mat1d& weights, std::size_t kind, double level) {
    const Group& group = groups[group_of(kind)];
    return look_with(cv::Mat1d(group.share * weights), level * group.stray, level * group.bend);
}

/// For each group the setting that errs least where it has not learned.
std::array<Setting, group_count> best_settings(const std::vector<EdgePupil>& pupils) {
    std::array<Setting, group_count> best;
    for (double ridge : ridges) {
        std::array<std::array<cv::Mat1d, edge_kind_count>, folds> weights;
        for (std::size_t fold = 0; fold < folds; ++fold)
            for (std::size_t kind = 0; kind < edge_kind_count; ++kind)
                weights[fold][kind] = likeliest_weights(lessons_of(pupils, kind, fold), edge_features, ridge);
        for (double level : price_levels) {
            Errors errors;
            for (std::size_t i = 0; i < pupils.size(); ++i) {
                EdgeLooks looks;
                for (std::size_t kind = 0; kind < edge_kind_count; ++kind)
                    looks[kind] = priced(weights[i % folds][kind], kind, level);
                judge(pupils[i], &looks, errors);
            }
            for (std::size_t group = 0; group < group_count; ++group)
                if (errors.mean(group) < best[group].error)
                    best[group] = {ridge, level, errors.mean(group)};
        }
    }
    return best;
}

/// What holds before and after, of the people learned from.
void tell(const std::vector<EdgePupil>& pupils, const std::array<Setting, group_count>& settings) {
    Errors without, with_present;
    for (const EdgePupil& pupil : pupils) {
        judge(pupil, nullptr, without);
        judge(pupil, &edge_looks, with_present);
    }
    for (std::size_t group = 0; group < group_count; ++group)
        std::fprintf(stderr,
                     "%s: %.3f %% without edges, %.3f with the table compiled in, %.3f learned from others "
                     "(ridge %.0f, prices times %.2f)\n",
                     groups[group].name, without.mean(group), with_present.mean(group), settings[group].error,
                     settings[group].ridge, settings[group].price_level);
}

/// Which groups the arguments from the third on want to keep; nothing where they cannot be understood.
std::optional<std::array<bool, group_count>> kept_groups(int argc, char** argv) {
    std::array<bool, group_count> kept{};
    for (int i = 3; i < argc; i += 2) {
        const auto named = [&](const Group& group) {
            return i + 1 < argc && group.name == std::string_view(argv[i + 1]);
        };
        const auto found = std::find_if(std::begin(groups), std::end(groups), named);
        if (argv[i] != std::string_view("--keep") || found == std::end(groups))
            return std::nullopt;
        kept[static_cast<std::size_t>(found - std::begin(groups))] = true;
    }
    return kept;
}

} // namespace

int main(int argc, char** argv) {
    const auto kept = kept_groups(argc, argv);
    if (argc < 3 || !kept) {
        std::fputs("learn_edge_look TRUTH.json PHOTOS [--keep "
                   "eyes|outer_lip|shut_mouth|open_mouth]... > TABLE\n",
                   stderr);
        return 2;
    }
    quiet_opencv();
    const auto refused = [](const std::string& sentence) {
        std::fprintf(stderr, "%s\n", sentence.c_str());
        return 1;
    };
    const auto held_out = held_out_people(TP_HOLDOUT_LIST);
    if (!held_out)
        return refused(held_out.error());
    const auto portraits = read_placed_truth(argv[1], argv[2]);
    if (!portraits)
        return refused(portraits.error());
    ContourNets nets;
    MeshModel mesh(embedded_net(EmbeddedModel::mesh));
    const auto pupils = edge_pupils(*portraits, *held_out, nets, mesh);
    if (!pupils)
        return refused(pupils.error());

    const auto settings = best_settings(*pupils);
    tell(*pupils, settings);
    std::puts("// SPDX-License-Identifier: Apache-2.0");
    std::puts(
        "// By learn_edge_look (faces/LEARNING.md): slopes and bends of brightness, of redness; stray, bend.");
    for (std::size_t kind = 0; kind < edge_kind_count; ++kind) {
        const GroupIndex group = group_of(kind);
        EdgeLook look = edge_looks[kind];
        std::string comment = kind_names[kind];
        if ((*kept)[group]) {
            comment += ", kept";
        } else {
            const auto lessons = lessons_of(*pupils, kind);
            look = priced(likeliest_weights(lessons, edge_features, settings[group].ridge), kind,
                          settings[group].price_level);
            comment += ", " + std::to_string(lessons.size()) + " places";
        }
        std::puts(edge_table_row(look, comment).c_str());
    }
    return 0;
}
