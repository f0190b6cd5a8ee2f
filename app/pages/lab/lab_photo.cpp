// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_photo.hpp"

#include "app/photo/scene/corrections.hpp"
#include "faces/decode/picture.hpp"
#include "faces/extract/face_extractor.hpp"

#include <exception>
#include <utility>

namespace tp {

LabPhoto read_photo(const std::string& file, const SurfaceSize& surface,
                    std::unique_ptr<FaceExtractor>& extractor, const std::stop_token& stop) {
    try {
        const Result<cv::Mat> picture = read_picture(file);
        if (!picture)
            return {{}, picture.error()};
        if (!extractor) {
            Result<FaceExtractor> made = FaceExtractor::create();
            if (!made)
                return {{}, made.error()};
            extractor = std::make_unique<FaceExtractor>(std::move(made).value());
        }
        const Result<BuiltScene> built =
            build_scene(with_corrections(extractor->extract(*picture, stop), file), surface);
        if (!built)
            return {{}, built.error()};
        return {flatten(built->scene), {}};
    } catch (const std::exception&) { // out of memory, mostly
        return {{}, "This picture could not be worked on. It may be too large for this computer."};
    }
}

} // namespace tp
