// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/fault.hpp"

#include <QString>

namespace tp {

/// A fault of the servo as a sentence in the person's language; empty for none.
QString fault_words(Fault fault);

} // namespace tp
