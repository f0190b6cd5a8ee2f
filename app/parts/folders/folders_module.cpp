// SPDX-License-Identifier: Apache-2.0
#include "app/parts/folders/folders_module.hpp"

#include "app/parts/controls/controls_module.hpp"

extern void qml_register_types_TouchPhoto_Folders();

namespace tp {

void register_folders() {
    register_controls();
    qml_register_types_TouchPhoto_Folders();
}

} // namespace tp
