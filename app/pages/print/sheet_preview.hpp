// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/tactile/tactile_sheet.hpp"

#include <QString>

namespace tp {

/// The sheet as a picture on a page, a data URL.
QString sheet_preview(const TactileSheet& sheet);

} // namespace tp
