// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/contours/contour_nets.hpp"
#include "faces/contours/mesh_model.hpp"

#include <array>
#include <memory>
#include <optional>

namespace tp {

/// What comes of two opinions about a face.
struct Opinions {
    Landmarks settled;
    Landmarks mesh; ///< where the face would lie if nothing of our nets were believed
};

/// The face mesh, asked where our own nets are not sure: these are the more exact, it is the sturdier. It is
/// loaded when it is first asked.
class SecondOpinion {
public:
    /// `nets` must outlive it.
    explicit SecondOpinion(ContourNets& nets) : nets_(nets) {}
    /// What comes of the mesh's points and of ours (`ours`; null: our nets saw no face), settled(). Nothing
    /// where the mesh is not sure of a face there, or our close looks see other features than it does.
    std::optional<Opinions> about(const cv::Mat& picture, const Detection& face, const Landmarks* ours);

    /// Gives its memory back until it is asked again: before a search that needs much.
    void rest();

private:
    ContourNets& nets_;
    std::unique_ptr<MeshModel> mesh_;
};

/// How much clearer the lids of an eye are where our close look sees them than where the mesh does; below 0:
/// less clear.
using LidEvidence = std::array<double, 2>; ///< of right and left eye, differences of clarity()

/// Feature by feature the mean of the mesh's points and of ours: of `ours` (null: none) and of those of the
/// close looks that began at the mesh's, whichever lie nearer to it. The farther these are from the mesh's,
/// the less they count: our nets err seldom, but then by much, as at a feature that something covers. Where
/// the picture shows the lids of an eye that ours see, the mesh's do not count: it sees shut eyes open.
Landmarks settled(const Landmarks* ours, const Landmarks& mesh, const Landmarks& close,
                  const LidEvidence& evidence = {});

} // namespace tp
