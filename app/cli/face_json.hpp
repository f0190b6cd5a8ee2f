// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/face.hpp"

#include <QByteArray>

#include <string>

namespace tp {

/// One photograph's result as one line of JSON, without the line's end. Contours are dense polylines in
/// pixels of the upright picture; a closed one does not repeat its first point. Fields are documented in
/// app/cli/VERBS.md and are only ever added to.
QByteArray json_line(const std::string& photo, const Extraction& extraction);

} // namespace tp
