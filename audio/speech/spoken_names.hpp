// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <vector>

namespace tp {

/// A name whose own language is known, such as Giulia in Italian.
struct SpokenName {
    QString name;     ///< as it stands in sentences
    QString language; ///< BCP 47

    bool operator==(const SpokenName&) const = default;
};

using SpokenNames = std::vector<SpokenName>;

} // namespace tp
