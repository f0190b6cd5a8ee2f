// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/processes/message.hpp"
#include "faces/decode/shared_pixels.hpp"

#include <opencv2/core/mat.hpp>

#include <functional>
#include <optional>

namespace tp {

/// Load every library that decodes HEIC and AVIF, or any other picture: afterwards no file is opened for that
/// any more.
void load_heif_decoders();
void load_picture_decoders();

/// The helper's end of foreign_picture.hpp: decodes what it is handed.
class PictureService {
public:
    /// None where none is wanted.
    std::optional<Message> answer(MessageReader& question);

private:
    std::function<Result<cv::Mat>()> whole_; ///< of the picture that was shrunk last
    PixelTray tray_;
};

} // namespace tp
