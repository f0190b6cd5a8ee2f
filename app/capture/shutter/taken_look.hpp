// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/capture/seeing/face_namer.hpp"
#include "app/photo/seen/seen_photo.hpp"
#include "app/photo/words/photo_view.hpp"
#include "core/geometry/vec.hpp"
#include "faces/extract/face_extractor.hpp"

#include <QLocale>

#include <opencv2/core/mat.hpp>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// A face of somebody who is known.
struct NamedFace {
    Rect box; ///< shares of the picture, as it is kept
    std::string name;
};

/// What a photograph shows, and whom.
struct TakenSight {
    SeenPhoto seen;
    std::vector<NamedFace> known;
};

/// A face of a mirrored picture in the picture that is kept.
inline Rect turned_back(const Rect& box) {
    return {{1.0 - box.max.x, box.min.y}, {1.0 - box.min.x, box.max.y}};
}

/// All of a picture whose mean is below that, 0 black … 1 white, is a little dark: by all of it, and not by how light a face is.
inline constexpr double dark_picture = 0.22;

/// Looks at a photograph that was just taken, with nets of its own. One thread.
class TakenLook {
public:
    /// Who may be known.
    explicit TakenLook(std::shared_ptr<const KnownPeople> people = std::make_shared<KnownPeople>())
        : namer_(std::move(people)) {}

    /// Of the picture as it is kept, 8-bit BGR. Some ten ms, and as many for each face where somebody may be known; one without
    /// a size could not be looked at. Never throws.
    TakenSight see(const cv::Mat& picture);

private:
    FaceNamer namer_;
    std::optional<FaceExtractor> extractor_; ///< made at the first picture
};

/// What `taken_words` makes a sentence of.
PhotoView taken_view(const TakenSight& sight, QLocale::Language language);

} // namespace tp
