// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <opencv2/dnn/dnn.hpp>

#include <filesystem>
#include <string>

namespace tp {

/// The nets that are part of the program (resources/models/README.md says what each was trained on).
enum class EmbeddedModel { detector, contours, eye, mouth };

/// A fresh copy of an embedded net, ready to run on the CPU. Throws cv::Exception where the program was built
/// with a file that is not a net.
cv::dnn::Net embedded_net(EmbeddedModel model);

/// A kind of net that a user can plug in: how it is called, which file holds it, how it is described.
struct PluggableModel {
    const char* name;        ///< as given in ExtractorChoice, e.g. "yunet"
    const char* file;        ///< looked up under this name, e.g. "yunet.onnx"
    const char* description; ///< e.g. "a YuNet face detector"
};

/// The file that `choice` means: a path (something with a slash or the ending .onnx) is taken as it is, the
/// model's name is looked up in $TOUCHPHOTO_MODELS, then in $XDG_DATA_HOME/touchphoto/models (default
/// ~/.local/share/touchphoto/models). An error names what was looked for and where.
Result<std::filesystem::path> find_model(const std::string& choice, const PluggableModel& model);

} // namespace tp
