// SPDX-License-Identifier: Apache-2.0
#include "app/pages/print/print_module.hpp"

#include "app/parts/controls/controls_module.hpp"

extern void qml_register_types_TouchPhoto_Print();

namespace tp {

void register_print() {
    register_controls();
    qml_register_types_TouchPhoto_Print();
}

} // namespace tp
