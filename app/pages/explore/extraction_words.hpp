// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/face.hpp"

#include <QString>
#include <QStringList>

#include <vector>

namespace tp {

/// What was found in a photograph and can be felt, as a person is told: "Anna. One face. Eyes, mouth and outline
/// can be felt.", followed by what is wrong with it, if anything. `names` has one for each face, empty where nobody
/// said whose it is; or none at all.
QString describe(const Extraction& extraction, const std::vector<QString>& names = {});

/// "Anna", "Anna and Tom", "Anna, Tom and Clara".
QString listed(QStringList items);

} // namespace tp
