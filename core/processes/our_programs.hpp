// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace tp {

/// Where the program lies that runs. Where another one lies in its place by now, because TouchPhoto was brought up
/// to date meanwhile: that one.
std::filesystem::path this_program();

/// Where a program lies that lies beside the one that runs. Its name is without what Windows puts behind it.
std::filesystem::path beside_this_program(const std::string& name);

/// Where one of our programs lies that is not for people: beside the one that runs, as they are built; where it
/// is not there, in ../libexec/PROGRAM from it, as it is installed (cmake/Install.cmake), PROGRAM being the file
/// name of the one that runs, without what Windows puts behind it.
std::filesystem::path helper_program(const std::string& name);

} // namespace tp
