// SPDX-License-Identifier: Apache-2.0
#include "app/parts/controls/controls_module.hpp"

#include <QtGlobal>

extern void qml_register_types_TouchPhoto_Controls();

namespace tp {

void register_controls() { qml_register_types_TouchPhoto_Controls(); }

} // namespace tp
