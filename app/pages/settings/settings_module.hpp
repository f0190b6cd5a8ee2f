// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes `import TouchPhoto.Settings` work; to be called before QML is loaded.
void register_settings();

} // namespace tp
