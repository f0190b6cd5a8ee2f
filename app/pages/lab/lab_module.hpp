// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes `import TouchPhoto.Lab` (and the controls) work; call it once before any QML is loaded.
void register_lab();

} // namespace tp
