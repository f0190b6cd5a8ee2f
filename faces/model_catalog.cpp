// SPDX-License-Identifier: Apache-2.0
#include "faces/model_catalog.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>

extern "C" {
extern const char tp_model_detector[], tp_model_detector_end[];
extern const char tp_model_contours[], tp_model_contours_end[];
extern const char tp_model_eye[], tp_model_eye_end[];
extern const char tp_model_mouth[], tp_model_mouth_end[];
extern const char tp_model_outline[], tp_model_outline_end[];
}

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

/// Lets the system take back the memory of a file's bytes inside the program, which it reads again when they
/// are wanted.
void let_go(const char* begin, const char* end) {
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
    const auto last = reinterpret_cast<std::uintptr_t>(end) / page * page;
    if (first < last)
        madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED); // failing, it costs memory only
}

cv::dnn::Net net_between(const char* begin, const char* end) {
    cv::dnn::Net net = cv::dnn::readNetFromONNX(begin, static_cast<std::size_t>(end - begin));
    let_go(begin, end);
    return net;
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
    const auto bytes = [](const char* begin, const char* end) {
        return static_cast<std::size_t>(end - begin);
    };
    return {{"detector", "finds faces", "Apache-2.0", bytes(tp_model_detector, tp_model_detector_end)},
            {"contours", "places the points of a face", "Apache-2.0",
             bytes(tp_model_contours, tp_model_contours_end)},
            {"eye", "looks closely at an eye", "Apache-2.0", bytes(tp_model_eye, tp_model_eye_end)},
            {"mouth", "looks closely at the mouth", "Apache-2.0", bytes(tp_model_mouth, tp_model_mouth_end)},
            {"outline", "looks closely at the outline", "Apache-2.0",
             bytes(tp_model_outline, tp_model_outline_end)}};
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
    switch (model) {
    case EmbeddedModel::detector:
        return net_between(tp_model_detector, tp_model_detector_end);
    case EmbeddedModel::contours:
        return net_between(tp_model_contours, tp_model_contours_end);
    case EmbeddedModel::eye:
        return net_between(tp_model_eye, tp_model_eye_end);
    case EmbeddedModel::mouth:
        return net_between(tp_model_mouth, tp_model_mouth_end);
    case EmbeddedModel::outline:
        return net_between(tp_model_outline, tp_model_outline_end);
    }
    return {};
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
        return not_installed(*model);
    }
    return Error{"There is no model named \"" + choice + "\" here: choose \"embedded\"" + names +
                 " or the path of a file that holds " + descriptions + "."};
}

} // namespace tp
