// SPDX-License-Identifier: Apache-2.0
#include "app/pages/start/start_module.hpp"

#include "app/parts/folders/folders_module.hpp"

extern void qml_register_types_TouchPhoto_Start();

namespace tp {

void register_start() {
    register_folders();
    qml_register_types_TouchPhoto_Start();
}

} // namespace tp
