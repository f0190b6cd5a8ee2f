// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/settings_module.hpp"

#include "app/parts/folders/folders_module.hpp"

extern void qml_register_types_TouchPhoto_Settings();

namespace tp {

void register_settings() {
    register_folders();
    qml_register_types_TouchPhoto_Settings();
}

} // namespace tp
