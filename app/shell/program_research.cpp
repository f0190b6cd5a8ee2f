// SPDX-License-Identifier: Apache-2.0
// The pages for researchers.
#include "app/shell/program.hpp"

#include <QCoreApplication>

#include <utility>

namespace tp {

LabSession& Program::lab() {
    if (!lab_) {
        LabSettings settings;
        settings.folder = parts_.documents / "Lab";
        lab_ = std::make_unique<LabSession>(narrator_, preferences_, settings);
        connect(lab_.get(), &LabSession::pageAsked, &shell_, &Shell::open);
    }
    return *lab_;
}

StudySession& Program::study() {
    if (!study_) {
        StudySettings settings;
        settings.folder = parts_.documents.parent_path() / "TouchPhoto studies";
        settings.devices = parts_.explore.devices;
        settings.device_servo = parts_.explore.device_servo;
        settings.servo = parts_.explore.servo;
        settings.plant = parts_.explore.plant;
        settings.version =
            (QCoreApplication::applicationName() + ' ' + QCoreApplication::applicationVersion())
                .toStdString();
        study_ =
            std::make_unique<StudySession>(narrator_, earcons_, guide_, preferences_, std::move(settings));
    }
    return *study_;
}

} // namespace tp
