// SPDX-License-Identifier: Apache-2.0
#include "faces/contours/second_opinion.hpp"

#include "faces/base/freed_memory.hpp"
#include "faces/edges/edge_fit.hpp"
#include "faces/models/model_catalog.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tp {
namespace {

/// Of the mesh, to be believed.
constexpr double least_presence = 0.9;
/// Between the close looks and the mesh's points at which they began, percent of the eyes' distance, mean
/// over the features but the outline: at faces below 5 (99 of 100), at what is none far above.
constexpr double most_apart_percent = 8.0;

/// Difference of clarity from which the picture has decided: shut eyes show 0.3 and more, covered ones below
/// 0.1.
constexpr double enough_evidence = 0.3;

/// How the points of a feature are weighed.
struct Weighing {
    double mesh_share; ///< where both agree
    double agree,
        differ; ///< percent of the eyes' distance: up to `agree` that share, from `differ` on the mesh alone
};
/// As FeatureIndex.
constexpr std::array<Weighing, feature_count> weighings{
    {{0.3, 3.0, 5.0}, {0.3, 3.0, 5.0}, {0.5, 5.0, 8.0}, {0.45, 5.0, 8.0}, {0.5, 5.0, 9.0}}};

using Points = std::vector<Vec2>;

std::array<Points*, feature_count> lines_of(Landmarks& face) {
    return {&face.right_eye, &face.left_eye, &face.outer_lip, &face.inner_lip, &face.outline};
}
std::array<const Points*, feature_count> lines_of(const Landmarks& face) {
    return {&face.right_eye, &face.left_eye, &face.outer_lip, &face.inner_lip, &face.outline};
}

/// Mean distance of points of the same number, px.
double apart_px(const Points& one, const Points& other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i)
        sum += length(one[i] - other[i]);
    return sum / static_cast<double>(one.size());
}

double unit_of(const Landmarks& face) { return length(face.left_eye[0] - face.right_eye[0]); }

double mesh_share(const Weighing& weighing, double apart_percent) {
    const double beyond =
        std::clamp((apart_percent - weighing.agree) / (weighing.differ - weighing.agree), 0.0, 1.0);
    return weighing.mesh_share + beyond * (1.0 - weighing.mesh_share);
}

/// Whether our close looks see eyes and mouth where the mesh does.
bool bears_out(const Landmarks& mesh, const Landmarks& close) {
    const auto one = lines_of(mesh), other = lines_of(close);
    double sum = 0.0;
    for (std::size_t f = 0; f < at_outline; ++f)
        sum += apart_px(*one[f], *other[f]);
    return sum / double(std::size_t(at_outline)) <= most_apart_percent / 100.0 * unit_of(mesh);
}

LidEvidence lid_evidence(const cv::Mat& picture, const Landmarks& mesh, const Landmarks& close) {
    EdgeReports at_mesh, at_close;
    on_edges(picture, lines_through(mesh), &at_mesh);
    on_edges(picture, lines_through(close), &at_close);
    return {at_close.right_eye.clearest() - at_mesh.right_eye.clearest(),
            at_close.left_eye.clearest() - at_mesh.left_eye.clearest()};
}

} // namespace

Landmarks settled(const Landmarks* ours, const Landmarks& mesh, const Landmarks& close,
                  const LidEvidence& evidence) {
    Landmarks result = ours ? *ours : close;
    const double unit = unit_of(mesh);
    const auto to = lines_of(result);
    const auto of_mesh = lines_of(mesh), of_close = lines_of(close);
    for (std::size_t f = 0; f < feature_count; ++f) {
        const double close_apart = apart_px(*of_close[f], *of_mesh[f]);
        const double apart = ours ? apart_px(*to[f], *of_mesh[f]) : close_apart;
        result.between_models_px[f] = apart;
        result.between_close_px[f] = close_apart;
        if (close_apart < apart)
            *to[f] = *of_close[f];
        double share =
            unit > 0.0 ? mesh_share(weighings[f], 100.0 * std::min(apart, close_apart) / unit) : 1.0;
        if (f < evidence.size())
            share *= 1.0 - std::clamp(evidence[f] / enough_evidence, 0.0, 1.0);
        for (std::size_t i = 0; i < to[f]->size(); ++i)
            (*to[f])[i] += share * ((*of_mesh[f])[i] - (*to[f])[i]);
    }
    for (const auto& [own, other] :
         {std::pair{&result.right_brow, &mesh.right_brow}, std::pair{&result.left_brow, &mesh.left_brow},
          std::pair{&result.nose, &mesh.nose}})
        *own = *other;
    result.right_iris = mesh.right_iris;
    result.left_iris = mesh.left_iris;
    result.has_second_opinion = true;
    return result;
}

std::optional<Opinions> SecondOpinion::about(const cv::Mat& picture, const Detection& face,
                                             const Landmarks* ours) {
    if (!mesh_)
        mesh_ = std::make_unique<MeshModel>(embedded_net(EmbeddedModel::mesh));
    const auto mesh = mesh_->locate(picture, face);
    if (!mesh || mesh->confidence < least_presence)
        return std::nullopt;
    const auto close = nets_.look_closely(picture, face, *mesh);
    if (!close || !bears_out(*mesh, *close))
        return std::nullopt;
    return Opinions{settled(ours, *mesh, *close, lid_evidence(picture, *mesh, *close)), *mesh};
}

void SecondOpinion::rest() {
    mesh_.reset();
    give_back_freed_memory();
}

} // namespace tp
