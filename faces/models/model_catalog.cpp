// SPDX-License-Identifier: Apache-2.0
#include "faces/models/model_catalog.hpp"

#include "faces/models/embedded_memory.hpp"
#include "faces/models/packed_onnx.hpp"

// Where embedded_models.S puts them.
#define TP_MODELS(MODEL)                                                                                     \
    MODEL(detector, "finds faces", "Apache-2.0")                                                             \
    MODEL(contours, "places the points of a face", "Apache-2.0")                                             \
    MODEL(eye, "looks closely at an eye", "Apache-2.0")                                                      \
    MODEL(mouth, "looks closely at the mouth", "Apache-2.0")                                                 \
    MODEL(outline, "looks closely at the outline", "Apache-2.0")                                             \
    MODEL(dark_glasses, "tells dark glasses", "Apache-2.0")                                                  \
    MODEL(hidden_jaw, "tells beards, and hair before the jaw", "Apache-2.0")                                 \
    MODEL(mesh, "places the points of a face of which the others are not sure", "Apache-2.0")                \
    MODEL(yunet, "finds faces where the other detector finds none", "MIT")                                   \
    MODEL(descriptor, "describes a face, to tell whether two show one person", "CC0-1.0, MIT")

#define TP_DECLARE(name, purpose, licence) extern const char tp_model_##name[], tp_model_##name##_end[];
extern "C" {
TP_MODELS(TP_DECLARE)
}
#undef TP_DECLARE

namespace tp {
namespace {

/// An embedded file and what a person reads about it.
struct Embedded {
    const char* begin;
    const char* end;
    EmbeddedModelFacts facts;
};

/// In the order of EmbeddedModel.
const std::vector<Embedded>& embedded_files() {
#define TP_ENTRY(name, purpose, licence)                                                                     \
    {tp_model_##name,                                                                                        \
     tp_model_##name##_end,                                                                                  \
     {#name, purpose, licence, static_cast<std::size_t>(tp_model_##name##_end - tp_model_##name)}},
    static const std::vector<Embedded> files{TP_MODELS(TP_ENTRY)};
#undef TP_ENTRY
    return files;
}

} // namespace

std::vector<EmbeddedModelFacts> embedded_models() {
    std::vector<EmbeddedModelFacts> facts;
    for (const Embedded& file : embedded_files())
        facts.push_back(file.facts);
    return facts;
}

cv::dnn::Net embedded_net(EmbeddedModel model) {
    const Embedded& file = embedded_files().at(static_cast<std::size_t>(model));
    const auto unpacked = unpacked_onnx({file.begin, file.facts.bytes});
    cv::dnn::Net net = unpacked ? cv::dnn::readNetFromONNX(unpacked->data(), unpacked->size())
                                : cv::dnn::readNetFromONNX(file.begin, file.facts.bytes);
    let_go_of_memory(file.begin, file.end);
    return net;
}

} // namespace tp
