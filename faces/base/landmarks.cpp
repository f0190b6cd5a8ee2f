// SPDX-License-Identifier: Apache-2.0
#include "faces/base/landmarks.hpp"

namespace tp {

void map_points(Landmarks& landmarks, const Affine& map, double scale) {
    for (std::vector<Vec2>* line :
         {&landmarks.right_eye, &landmarks.left_eye, &landmarks.outer_lip, &landmarks.inner_lip,
          &landmarks.outline, &landmarks.right_brow, &landmarks.left_brow, &landmarks.nose})
        for (Vec2& p : *line)
            p = map(p);
    for (Iris* iris : {&landmarks.right_iris, &landmarks.left_iris})
        *iris = {map(iris->centre), scale * iris->radius};
    for (auto* moved :
         {&landmarks.between_passes_px, &landmarks.between_nets_px, &landmarks.between_mirrors_px,
          &landmarks.between_models_px, &landmarks.between_close_px})
        for (double& px : *moved)
            px *= scale;
}

double openness(const std::vector<Vec2>& eye) {
    const double width = length(eye[eye_corner] - eye[0]);
    return width > 0.0 ? length(eye[eye_corner / 2] - eye[eye_corner * 3 / 2]) / width : 0.0;
}

} // namespace tp
