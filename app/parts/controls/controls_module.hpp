// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes `import TouchPhoto.Controls` work; call it once before any QML is loaded.
void register_controls();

} // namespace tp
