// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <opencv2/dnn/dnn.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// The nets that are part of the program (resources/models/ORIGINS.md says where each comes from).
enum class EmbeddedModel {
    detector,
    contours,
    eye,
    mouth,
    outline,
    dark_glasses,
    hidden_jaw,
    mesh,
    yunet,
    descriptor
};

/// A fresh copy of an embedded net, ready to run on the CPU. Throws cv::Exception where the program was built
/// with a file that is not a net.
cv::dnn::Net embedded_net(EmbeddedModel model);

/// An embedded net, for a person.
struct EmbeddedModelFacts {
    const char* name;
    const char* purpose; ///< e.g. "finds faces"
    const char* licence;
    std::size_t bytes;
};
std::vector<EmbeddedModelFacts> embedded_models();

/// A kind of net that a user can plug in: how it is called, which file holds it, and the file of that kind
/// that we know. Any other file of the kind may be plugged in too.
struct PluggableModel {
    enum class Role { detector, landmarks };

    const char* name;        ///< as given in ExtractorChoice, e.g. "yunet"
    const char* file;        ///< looked up under this name, e.g. "yunet.onnx"
    const char* description; ///< e.g. "a YuNet face detector"
    Role role;

    // The known file.
    const char* licence;
    const char* address; ///< http or https; empty: no public one is known
    const char* origin;  ///< where it comes from, a sentence
    std::uintmax_t bytes;
    const char* sha256; ///< in hexadecimal digits; empty: not known, and so there is no address either
    const char* of_system = ""; ///< where a package of Debian puts it; empty: none has it
    std::optional<EmbeddedModel> inside =
        {}; ///< the program has it, for those who bring no file of their own
};

inline constexpr PluggableModel yunet_model{
    "yunet",
    "yunet.onnx",
    "a YuNet face detector",
    PluggableModel::Role::detector,
    "MIT",
    "https://github.com/opencv/opencv_zoo/raw/c71f7a40d34cd3830086ee9b7a01174e013ad42a/models/"
    "face_detection_yunet/face_detection_yunet_2022mar.onnx",
    "It is face_detection_yunet_2022mar.onnx of the OpenCV Zoo; later ones need a later OpenCV.",
    345'478,
    "50ef07f702a31741ca46a4c0d947773b64143b9362780237bf0d427d6c79bab7",
    "",
    EmbeddedModel::yunet};

inline constexpr PluggableModel haar_model{
    "haar",
    "haarcascade_frontalface_default.xml",
    "a Haar cascade for frontal faces",
    PluggableModel::Role::detector,
    "Intel License Agreement for Open Source Computer Vision Library (as BSD-3-Clause)",
    "https://github.com/opencv/opencv/raw/4.6.0/data/haarcascades/haarcascade_frontalface_default.xml",
    "It is the one of OpenCV 4.6; Debian's package opencv-data has it too, and then it is found there.",
    930'127,
    "0f7d4527844eb514d4a4948e822da90fbb16a34a0bbbbc6adc6498747a5aafb0",
    "/usr/share/opencv4/haarcascades/haarcascade_frontalface_default.xml"};

inline constexpr PluggableModel mesh_model{
    "mesh",
    "face_mesh.onnx",
    "a 478-point face mesh",
    PluggableModel::Role::landmarks,
    "Apache-2.0",
    "",
    "It is the landmark net of MediaPipe's face landmarker v2 (face_landmarker.task) converted to ONNX, and "
    "no "
    "public address of that is known: convert the published one, with outputs t473 and t472.",
    4'825'994,
    "8f419ac71e28589a66b2835cc5084951829a1b919e156c261bb4f9582d116e72",
    "",
    EmbeddedModel::mesh};

inline constexpr PluggableModel lbf_model{
    "lbf",
    "lbfmodel.yaml",
    "a 68-point LBF facemark",
    PluggableModel::Role::landmarks,
    "BSD-3-Clause, says its author; of the portraits it learned from (HELEN) no terms are known",
    "",
    "It is data/lbfmodel.yaml of github.com/kurnianggoro/GSOC2017, or another that OpenCV's FacemarkLBF "
    "wrote; no checksum of it is known, so get it yourself and give it with --from FILE.",
    56'375'857, // what FacemarkLBF writes with its own parameters
    ""};

inline constexpr std::array<const PluggableModel*, 4> pluggable_models{&yunet_model, &haar_model, &mesh_model,
                                                                       &lbf_model};

/// Folders where a model's file is looked for, in this order; a new one belongs into the first. Empty where
/// the environment names none.
std::vector<std::filesystem::path> model_folders();

/// The file that the model's name means at present.
std::optional<std::filesystem::path> installed_file(const PluggableModel& model);

/// A kind of model and the file that holds it; no file: the one inside the program.
struct ChosenModel {
    const PluggableModel* kind;
    std::filesystem::path file;
};

/// What `choice` means where a model of that role is wanted: a path (something with a slash or the ending
/// .onnx, .yaml or .xml) is taken as it is, its ending saying of which kind it is; a model's name is looked
/// up in $TOUCHPHOTO_MODELS, then in $XDG_DATA_HOME/touchphoto/models (default
/// ~/.local/share/touchphoto/models), then where a package of the system puts it, then inside the program. An
/// error names what was looked for and where.
Result<ChosenModel> find_model(const std::string& choice, PluggableModel::Role role);

} // namespace tp
