// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes `import TouchPhoto.Start` work; to be called before QML is loaded.
void register_start();

} // namespace tp
