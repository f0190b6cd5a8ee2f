// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/servo/fault.hpp"

#include <QString>

#include <string>

namespace tp {

/// A fault of the servo as a sentence in the person's language; empty for none.
QString fault_words(Fault fault);

/// What a device says of itself (ListedDevice::about, why it cannot be opened, why its motors are off), in the person's
/// language where a translator knows it; others, a maker's name for his device above all, stay as they are.
QString device_words(const std::string& words);

} // namespace tp
