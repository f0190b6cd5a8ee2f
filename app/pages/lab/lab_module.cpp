// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_module.hpp"

#include "app/parts/controls/controls_module.hpp"

extern void qml_register_types_TouchPhoto_Lab();

namespace tp {

void register_lab() {
    register_controls();
    qml_register_types_TouchPhoto_Lab();
}

} // namespace tp
