// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/study_module.hpp"

#include "app/parts/controls/controls_module.hpp"
#include "app/parts/folders/folders_module.hpp"

extern void qml_register_types_TouchPhoto_Study();

namespace tp {

void register_study() {
    register_controls();
    register_folders();
    qml_register_types_TouchPhoto_Study();
}

} // namespace tp
