// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes `import TouchPhoto.Browse` (and the controls) work; call it once before any QML is loaded.
void register_browse();

} // namespace tp
