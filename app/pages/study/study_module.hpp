// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes `import TouchPhoto.Study` work; to be called before QML is loaded.
void register_study();

} // namespace tp
