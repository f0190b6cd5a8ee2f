// SPDX-License-Identifier: Apache-2.0
#include "app/start/start_module.hpp"

#include "app/folders/folders_module.hpp"

extern void qml_register_types_TouchPhoto_Start();

namespace tp {

void register_start() {
    register_folders();
    qml_register_types_TouchPhoto_Start();
}

} // namespace tp
