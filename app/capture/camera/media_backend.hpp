// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Qt reaches cameras through FFmpeg's back end, unless the person has set QT_MEDIA_BACKEND: through GStreamer's, Qt 6.4 may
/// stand still for ever where a camera is switched off, and gives no pictures when it is switched on again. What that back end
/// tells its makers while it works is not shown. Before the first use of Qt Multimedia.
void use_steady_media_backend();

} // namespace tp
