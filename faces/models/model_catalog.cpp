// SPDX-License-Identifier: Apache-2.0
#include "faces/models/model_catalog.hpp"

#include "faces/models/embedded_memory.hpp"
#include "faces/models/packed_onnx.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <system_error>

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

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

bool is_file(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

bool looks_like_a_path(const std::string& choice) {
    return choice.find('/') != std::string::npos || choice.ends_with(".onnx") || choice.ends_with(".yaml") ||
           choice.ends_with(".xml");
}

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

Error not_installed(const PluggableModel& model) {
    std::string searched;
    for (const std::filesystem::path& folder : model_folders())
        searched += (searched.empty() ? "" : " or ") + folder.string();
    return {std::string("The model \"") + model.name + "\" is not installed: put " + model.description +
            " as " + model.file + " into " + (searched.empty() ? "$TOUCHPHOTO_MODELS" : searched) +
            "; \"touchphoto-lab models fetch " + model.name + "\" helps." +
            (*model.of_system ? std::string(" ") + model.origin : "")};
}

} // namespace

std::vector<EmbeddedModelFacts> embedded_models() {
    std::vector<EmbeddedModelFacts> facts;
    for (const Embedded& file : embedded_files())
        facts.push_back(file.facts);
    return facts;
}

std::vector<std::filesystem::path> model_folders() {
    std::vector<std::filesystem::path> folders;
    if (const std::string own = environment("TOUCHPHOTO_MODELS"); !own.empty())
        folders.emplace_back(own);
    if (const std::string data = environment("XDG_DATA_HOME"); !data.empty())
        folders.push_back(std::filesystem::path(data) / "touchphoto/models");
    else if (const std::string home = environment("HOME"); !home.empty())
        folders.push_back(std::filesystem::path(home) / ".local/share/touchphoto/models");
    return folders;
}

std::optional<std::filesystem::path> installed_file(const PluggableModel& model) {
    for (const std::filesystem::path& folder : model_folders())
        if (is_file(folder / model.file))
            return folder / model.file;
    if (is_file(model.of_system))
        return model.of_system;
    return std::nullopt;
}

cv::dnn::Net embedded_net(EmbeddedModel model) {
    const Embedded& file = embedded_files().at(static_cast<std::size_t>(model));
    const auto unpacked = unpacked_onnx({file.begin, file.facts.bytes});
    cv::dnn::Net net = unpacked ? cv::dnn::readNetFromONNX(unpacked->data(), unpacked->size())
                                : cv::dnn::readNetFromONNX(file.begin, file.facts.bytes);
    let_go_of_memory(file.begin, file.end);
    return net;
}

Result<ChosenModel> find_model(const std::string& choice, PluggableModel::Role role) {
    std::vector<const PluggableModel*> kinds;
    std::copy_if(pluggable_models.begin(), pluggable_models.end(), std::back_inserter(kinds),
                 [&](const PluggableModel* model) { return model->role == role; });
    if (looks_like_a_path(choice)) {
        if (!is_file(choice))
            return Error{"There is no model file \"" + choice + "\"."};
        const auto same_ending = std::find_if(kinds.begin(), kinds.end(), [&](const PluggableModel* model) {
            return std::filesystem::path(choice).extension() ==
                   std::filesystem::path(model->file).extension();
        });
        return ChosenModel{same_ending == kinds.end() ? kinds.front() : *same_ending, choice};
    }
    std::string names, descriptions;
    for (const PluggableModel* model : kinds) {
        names += ", \"" + std::string(model->name) + "\"";
        descriptions += (descriptions.empty() ? "" : " or ") + std::string(model->description);
        if (choice != model->name)
            continue;
        if (const auto file = installed_file(*model))
            return ChosenModel{model, *file};
        return model->inside ? Result<ChosenModel>(ChosenModel{model, {}}) : not_installed(*model);
    }
    return Error{"There is no model named \"" + choice + "\" here: choose \"embedded\"" + names +
                 " or the path of a file that holds " + descriptions + "."};
}

} // namespace tp
