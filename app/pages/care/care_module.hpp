// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Makes `import TouchPhoto.Care` work; call it once before any QML is loaded.
void register_care();

} // namespace tp
