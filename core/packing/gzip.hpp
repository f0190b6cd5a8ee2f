// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace tp {

/// The bytes as a gzip file (RFC 1952) without a name, a time or a system: the same bytes give the same file with the same zlib.
/// Empty where there is not enough memory; a gzip file never is.
std::string gzipped(std::string_view bytes);

/// The bytes of a gzip file. An error is the end of a sentence: the file ends too soon, is damaged (its checksum is verified),
/// has something behind its end, or holds more than `most_bytes`, of which no more is ever unpacked.
Result<std::string> gunzipped(std::string_view file, std::size_t most_bytes);

} // namespace tp
