// SPDX-License-Identifier: Apache-2.0
#include "device/hid_handles.hpp"

#include "device/open_problem.hpp"

#include <cerrno>
#include <utility>

#if defined(__unix__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace tp {

namespace {

/// hidapi says what went wrong only in the system's own words; opening the file once more tells the cause.
OpenProblem why_not([[maybe_unused]] const std::string& path) {
#if defined(__unix__)
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0)
        return open_problem_of(errno);
    ::close(file);
    return OpenProblem::wrong_driver; // a file that opens and is no hidraw device
#else
    return OpenProblem::other;
#endif
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
