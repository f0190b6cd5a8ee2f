// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace tp::test {

/// Writes into a folder what keeps each verb of touchphoto-lab at work for more than two seconds; a few hundred megabytes by
/// their names, most of which take no place on the disk. What cannot be written ends the program.
void write_long_inputs(const QString& folder);

} // namespace tp::test
