// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/scene/scene_builder.hpp"

#include <memory>
#include <stop_token>
#include <string>

namespace tp {

class FaceExtractor;

/// The lines of a photograph as the explore page would let them be felt, or why there are none.
struct LabPhoto {
    FlatScene flat;
    std::string problem;
};

/// Makes `extractor` where there is none yet.
LabPhoto read_photo(const std::string& file, const SurfaceSize& surface,
                    std::unique_ptr<FaceExtractor>& extractor, const std::stop_token& stop);

} // namespace tp
