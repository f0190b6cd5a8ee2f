// SPDX-License-Identifier: Apache-2.0
#include "core/processes/our_programs.hpp"

#include <system_error>

namespace tp {
namespace {

constexpr const char* ending = ".exe"; ///< of programs on Windows

} // namespace

std::filesystem::path beside_this_program(const std::string& name) {
    const std::filesystem::path own = this_program();
    return own.parent_path() / (name + (own.extension() == ending ? ending : ""));
}

std::filesystem::path helper_program(const std::string& name) {
    const std::filesystem::path own = this_program();
    const std::filesystem::path beside = beside_this_program(name);
    std::error_code problem;
    return std::filesystem::exists(beside, problem)
               ? beside
               : own.parent_path().parent_path() / "libexec" /
                     (own.extension() == ending ? own.stem() : own.filename()) / beside.filename();
}

} // namespace tp
