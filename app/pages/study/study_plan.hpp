// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/experiment/experiment.hpp"
#include "core/trials/study_trial.hpp"

#include <filesystem>
#include <memory>

namespace tp {

/// What the researcher has set up for a sitting.
struct StudyPlan {
    Experiment experiment;
    std::filesystem::path folder;
    int participant = 1;
    bool device = false;                     ///< a force device moves the finger; else it is drawn
    bool force_allowed = false; ///< the researcher lets the pull be as strong as the experiment asks for
    bool show_scene = false;                 ///< to try it out; then nothing is kept
    std::shared_ptr<const StudyFaces> faces; ///< null: the experiment has none
};

} // namespace tp
