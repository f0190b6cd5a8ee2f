// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tp {

/// A date with or without its time and offset, as EXIF ("2026:05:01 10:15:00"), IPTC ("20260501",
/// "101500+0200") and XMP ("2026-05-01T10:15:00.5+02:00") write it, as ISO 8601 without parts of a second:
/// "2026-05-01T10:15:00+02:00". None where no calendar or clock has it, such as 30 February or zeros for a
/// clock that was never set.
std::optional<std::string> exif_time(std::string_view date_time, std::string_view offset);
std::optional<std::string> iptc_time(std::string_view date, std::string_view time);
std::optional<std::string> xmp_time(std::string_view text);

} // namespace tp
