// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp {

/// The Debian package of a shared library, after its file: libavformat59 for libavformat.so.59 (Debian Policy 4.6,
/// section 8.1). Such a name goes on with another version in another Debian.
std::string debian_package(std::string_view library_file);

} // namespace tp
