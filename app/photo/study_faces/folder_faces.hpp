// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/experiment.hpp"
#include "core/trials/study_trial.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// The faces of a folder, for experiments in which expressions are named. Its files are named PERSON_EXPRESSION, such as
/// anna_smiling.jpg: photographs, whose largest face is taken with what a person has mended of it, or drawings of contours (.svg),
/// which are taken before a photograph of the same name. People are numbered in the order of their names.
class FolderFaces final : public StudyFaces {
public:
    /// The faces that `experiment` needs of `folder`; takes a second or so for each photograph. An error, in one sentence, where
    /// one is not there or has no face. It may be stopped; then the error is empty.
    static Result<std::shared_ptr<const FolderFaces>>
    read(const std::filesystem::path& folder, const Experiment& experiment, const std::stop_token& stop = {});

    Result<std::vector<Contour>> contours(std::string_view expression, std::string_view face) const override;
    std::size_t count() const { return faces_.size(); }

private:
    std::map<std::pair<std::string, std::string>, std::vector<Contour>> faces_; ///< by expression and face
};

/// The experiment shows faces, which somebody has to bring.
bool needs_faces(const Experiment& experiment);

} // namespace tp
