// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_module.hpp"

#include "app/parts/controls/controls_module.hpp"

extern void qml_register_types_TouchPhoto_Explore();

namespace tp {

void register_explore() {
    register_controls();
    qml_register_types_TouchPhoto_Explore();
}

} // namespace tp
