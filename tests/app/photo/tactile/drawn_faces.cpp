// SPDX-License-Identifier: Apache-2.0
#include "drawn_faces.hpp"

#include "faces/pieces/contour_fit.hpp"

#include <random>
#include <vector>

using namespace tp;

namespace {

Contour opening(const char* name, Vec2 middle, double half_width, double half_height) {
    const auto at = [&](double x, double y) { return middle + Vec2(x * half_width, y * half_height); };
    return fit_contour(name,
                       {at(-1, 0), at(-0.5, -0.8), at(0, -1), at(0.5, -0.8), at(1, 0), at(0.5, 0.8), at(0, 1),
                        at(-0.5, 0.8)},
                       true, {0, 4});
}

/// `open` 0 … 1; in a face `height` px high.
Face drawn_face(Vec2 middle, double height, double eyes_open, double mouth_open, bool extras) {
    const auto at = [&](double x, double y) { return middle + height * Vec2(x, y); };
    Face face;
    face.box = {at(-0.4, -0.5), at(0.4, 0.5)};
    face.score = 1.0;
    face.contours = {opening(feature::left_eye, at(0.16, -0.1), 0.08 * height, 0.035 * height * eyes_open),
                     opening(feature::right_eye, at(-0.16, -0.1), 0.08 * height, 0.035 * height * eyes_open),
                     opening(feature::outer_lip, at(0.0, 0.25), 0.15 * height, (0.04 + 0.06 * mouth_open) * height),
                     opening(feature::inner_lip, at(0.0, 0.25), 0.12 * height, 0.07 * mouth_open * height),
                     fit_contour(feature::outline,
                                 {at(-0.4, -0.15), at(-0.36, 0.2), at(-0.18, 0.44), at(0.0, 0.5), at(0.18, 0.44),
                                  at(0.36, 0.2), at(0.4, -0.15)},
                                 false)};
    if (extras) {
        face.contours.push_back(fit_contour(feature::nose, {at(-0.06, 0.08), at(0.0, 0.12), at(0.06, 0.08)}, false));
        face.contours.push_back(opening(feature::left_brow, at(0.16, -0.19), 0.1 * height, 0.012 * height));
        face.contours.push_back(opening(feature::left_iris, at(0.16, -0.1), 0.025 * height, 0.025 * height));
    }
    return face;
}

} // namespace

Extraction one_drawn_face() {
    Extraction extraction;
    extraction.width = 600;
    extraction.height = 700;
    extraction.faces = {drawn_face({300, 350}, 500, 1.0, 0.6, false)};
    return extraction;
}

Extraction drawn_faces(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    Extraction extraction;
    extraction.width = 4000;
    extraction.height = 3000;
    const auto count = 1 + random() % (seed % 2 ? 3 : 7);
    for (unsigned i = 0; i < count; ++i)
        extraction.faces.push_back(drawn_face({500.0 + 3000.0 * share(random), 500.0 + 2000.0 * share(random)},
                                              300.0 + 900.0 * share(random), share(random), share(random),
                                              random() % 3 == 0));
    return extraction;
}
