// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes `import TouchPhoto.Capture` work; to be called before QML is loaded.
void register_capture();

} // namespace tp
