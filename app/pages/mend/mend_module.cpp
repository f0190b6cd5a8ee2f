// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_module.hpp"

#include "app/parts/controls/controls_module.hpp"

extern void qml_register_types_TouchPhoto_Mend();

namespace tp {

void register_mend() {
    register_controls();
    qml_register_types_TouchPhoto_Mend();
}

} // namespace tp
