// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/face_square.hpp"

#include "core/geometry/flatten.hpp"
#include "core/geometry/polyline.hpp"
#include "faces/contours/crop.hpp"
#include "faces/contours/shrunk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace tp {
namespace {

constexpr std::size_t points_of_contour = 64;
/// Of the square's side, as the net was trained (see the header).
constexpr Vec2 right_eye_at(0.33, 0.33), left_eye_at(0.67, 0.33), mouth_at(0.5, 0.74);
constexpr double shrunk_to_px = 2.0 * face_square_px; ///< from there on by exact areas

std::optional<Vec2> middle(const Face& face, const char* name) {
    const auto contour = std::ranges::find(face.contours, name, &Contour::name);
    if (contour == face.contours.end() ||
        !std::ranges::all_of(contour->pieces, [](const Piece& piece) { return is_finite(piece); }))
        return std::nullopt;
    const Polyline line = flatten(*contour);
    if (line.points.empty())
        return std::nullopt;
    Vec2 sum(0.0);
    for (const Vec2 point : resampled(line, points_of_contour).points)
        sum += point;
    return sum / static_cast<double>(points_of_contour);
}

using Complex = std::complex<double>;
Complex complex_of(Vec2 v) { return {v.x, v.y}; }

/// The window whose corners are those of the square: least squares over the similarities, which are z ↦ a·z + b.
CropFrame window_of(const FacePlaces& places) {
    const std::array from{complex_of(right_eye_at), complex_of(left_eye_at), complex_of(mouth_at)};
    const std::array to{complex_of(places.right_eye), complex_of(places.left_eye), complex_of(places.mouth)};
    const Complex from_middle = (from[0] + from[1] + from[2]) / 3.0,
                  to_middle = (to[0] + to[1] + to[2]) / 3.0;
    Complex both = 0.0;
    double own = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        both += std::conj(from[i] - from_middle) * (to[i] - to_middle);
        own += std::norm(from[i] - from_middle);
    }
    const Complex a = both / own;
    const Complex centre = to_middle + a * (Complex(0.5, 0.5) - from_middle);
    return {Vec2(centre.real(), centre.imag()), std::abs(a), std::arg(a), false};
}

} // namespace

std::optional<FacePlaces> face_places(const Face& face) {
    const auto right = middle(face, feature::right_eye), left = middle(face, feature::left_eye),
               mouth = middle(face, feature::outer_lip);
    if (!right || !left || !mouth || !(length(*left - *right) > 0.0))
        return std::nullopt;
    return FacePlaces{*right, *left, *mouth};
}

std::optional<cv::Mat> face_square(const cv::Mat& picture, const FacePlaces& places) {
    CropFrame window = window_of(places);
    if (picture.empty() || !is_sane(window, picture))
        return std::nullopt;
    const Vec2 half(0.5 * window.side);
    const Shrunk surroundings = shrunk_around(
        picture, {{window.centre - half, window.centre + half}, places.right_eye, places.left_eye, 1.0},
        shrunk_to_px);
    window.centre = (window.centre - surroundings.to_picture.offset) / surroundings.scale();
    window.side /= surroundings.scale();
    return take_crop(surroundings.pixels, window, face_square_px).pixels;
}

} // namespace tp
