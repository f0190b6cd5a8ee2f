// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/media_backend.hpp"

#include <QLoggingCategory>
#include <QtGlobal>

namespace tp {

void use_steady_media_backend() {
    if (!qEnvironmentVariableIsSet("QT_MEDIA_BACKEND"))
        qputenv("QT_MEDIA_BACKEND", "ffmpeg");
    QLoggingCategory::setFilterRules("default.debug=false"); // QT_LOGGING_RULES counts more
}

} // namespace tp
