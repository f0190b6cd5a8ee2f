// SPDX-License-Identifier: Apache-2.0
#include "device/hid_handles.hpp"

#include "core/files/open_file.hpp"
#include "device/open_problem.hpp"

#include <cerrno>
#include <utility>

namespace tp {

namespace {

/// hidapi says what went wrong only in the system's own words; opening the file once more tells the cause.
OpenProblem why_not(const std::string& path) {
    if (!OpenFile(path, {.write = true}).ok())
        return open_problem_of(errno);
    return OpenProblem::wrong_driver; // a file that opens and is no hidraw device
}

} // namespace

Result<HidHandles> open_hid_handles(const std::string& path, const std::string& name) {
    HidHandle reader(hid_open_path(path.c_str()));
    if (!reader)
        return Error{sentence(why_not(path), this_system(), name)};
    return HidHandles{std::move(reader), HidHandle(hid_open_path(path.c_str()))};
}

std::string plain_hid_text(const wchar_t* text) {
    std::string plain;
    for (; text != nullptr && *text != 0; ++text)
        plain += *text > 0x1F && *text < 0x7F ? static_cast<char>(*text) : '?';
    return plain;
}

} // namespace tp
