// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tp {

/// "0.1.0": the number of the whole of TouchPhoto, as the root's CMakeLists.txt has it.
const char* version_number();

/// What a program of ours says of itself, in one line without its end: "touchphoto 0.1.0
/// (195ab4802c72)"; without the commit in brackets where it is built from sources that do not know theirs.
std::string version_line(const std::string& program);

} // namespace tp
