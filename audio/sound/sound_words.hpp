// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace tp {

/// "1 hour 20 minutes", "3 minutes", "1 minute 5 seconds", "12 seconds"; seconds only below ten minutes.
QString duration_words(double seconds);

} // namespace tp
