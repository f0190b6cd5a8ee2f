// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_file.hpp"
#include "app/pages/mend/mend_work.hpp"

#include <QImage>
#include <QString>

#include <memory>
#include <stop_token>
#include <string>

namespace tp {

class FaceExtractor;

/// A photograph whose contours are to be mended.
struct MendPhoto {
    QString file;        ///< with its folder
    QImage image;        ///< upright, at most 4 096 px on its longer side; null where it could not be read
    MendWork work;       ///< what was found, with the corrections that there are
    MendFile contours;   ///< where they are kept
    std::string problem; ///< why nothing can be mended, or why the corrections were left out; else empty
    bool usable = false; ///< whether there is something to work on
};

/// Reads a photograph, finds its faces and lays its corrections over them. Never throws; `extractor` is made
/// where it is not there yet.
MendPhoto read_for_mending(const QString& file, std::unique_ptr<FaceExtractor>& extractor,
                           const std::stop_token& stop) noexcept;

} // namespace tp
