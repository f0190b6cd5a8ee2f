// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/browse_module.hpp"

#include "app/parts/controls/controls_module.hpp"

extern void qml_register_types_TouchPhoto_Browse();

namespace tp {

void register_browse() {
    register_controls();
    qml_register_types_TouchPhoto_Browse();
}

} // namespace tp
