// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_module.hpp"

#include "app/parts/controls/controls_module.hpp"

extern void qml_register_types_TouchPhoto_Capture();

namespace tp {

void register_capture() {
    register_controls();
    qml_register_types_TouchPhoto_Capture();
}

} // namespace tp
