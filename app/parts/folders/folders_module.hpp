// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes `import TouchPhoto.Folders` work; to be called before QML is loaded.
void register_folders();

} // namespace tp
