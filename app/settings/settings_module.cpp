// SPDX-License-Identifier: Apache-2.0
#include "app/settings/settings_module.hpp"

#include "app/folders/folders_module.hpp"

extern void qml_register_types_TouchPhoto_Settings();

namespace tp {

void register_settings() {
    register_folders();
    qml_register_types_TouchPhoto_Settings();
}

} // namespace tp
