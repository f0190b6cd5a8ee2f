// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes `import TouchPhoto.Mend` (and the controls) work; call it once before any QML is loaded.
void register_mend();

} // namespace tp
