// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/geometry/transform.hpp"
#include "core/guidance/scene.hpp"
#include "faces/base/face.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// The touch surface on which a photograph is felt.
struct SurfaceSize {
    double width_mm = 200.0; ///< a 10-inch tablet held across
    double height_mm = 150.0;
    double margin_mm = 8.0; ///< left free on every side: the pull of a line reaches 2d = 8 mm beyond it
    /// Polygon of the places that the device in use reaches, mm, surface frame; empty: all of the surface.
    std::vector<Vec2> reach;
};

/// How much of a face fills the surface. Left and right are the person's own.
enum class FacePart { whole, eyes, left_eye, right_eye, mouth };

/// Whether the contour of that name (as in `feature`) is felt where the part fills the surface: lips belong
/// to the mouth, a brow and an iris to their eye.
bool belongs_to(FacePart part, std::string_view contour_name);

/// What is fitted into the surface.
struct Subject {
    std::optional<std::size_t> face; ///< index into Extraction::faces; none: all of them
    FacePart part = FacePart::whole; ///< of that face, or of each

    bool operator==(const Subject&) const = default;
};

/// So wide an eye's two lids can be followed with a finger, mm.
inline constexpr double least_eye_mm = 25.0;

/// Whose contour a contour of a scene is.
struct SceneFeature {
    std::size_t face = 0; ///< index into Extraction::faces
    std::string name;     ///< as in `feature`
};

/// A photograph's faces as a finger can feel them, and where the photograph lies under the finger.
struct BuiltScene {
    Scene scene;                        ///< contours in the surface frame, mm
    Affine photo_to_surface;            ///< pixels of the upright picture → mm
    std::vector<SceneFeature> features; ///< one for each contour
};

/// Fits the subject into the surface: the face with index `face`, or all faces together. Contours are named
/// as in `feature`, with several faces in the scene "face 1 left_eye" and so on. What is too narrow to be
/// told apart by force, a shut eye or shut lips, becomes one line. Where the device reaches less than the
/// surface, all of the subject lies at least 4 mm inside its reach. An error where there is no face or no
/// such face, or where the surface leaves no room inside its margin.
Result<BuiltScene> build_scene(const Extraction& extraction, const SurfaceSize& surface = {},
                               std::optional<std::size_t> face = std::nullopt);

/// The same for a part of a face; an error, too, where nothing of that part was found.
Result<BuiltScene> build_scene(const Extraction& extraction, const SurfaceSize& surface,
                               const Subject& subject);

/// Width of the narrowest eye of the scene, mm, the way the eye lies; nothing where there is none.
std::optional<double> narrowest_eye_mm(const BuiltScene& built);

/// The faces' contours on the surface under a given map, named and thinned as by build_scene.
Scene scene_of(const std::vector<Face>& faces, const SurfaceSize& surface, const Affine& photo_to_surface);

} // namespace tp
