// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/care_module.hpp"

#include "app/parts/folders/folders_module.hpp"

extern void qml_register_types_TouchPhoto_Care();

namespace tp {

void register_care() {
    register_folders();
    qml_register_types_TouchPhoto_Care();
}

} // namespace tp
