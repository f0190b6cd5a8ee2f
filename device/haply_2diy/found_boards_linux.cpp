// SPDX-License-Identifier: Apache-2.0
#include "core/files/first_line.hpp"
#include "device/haply_2diy/found_boards.hpp"
#include "device/told_name.hpp"

#include <algorithm>
#include <system_error>

namespace tp {

namespace {

std::string first_word(const std::filesystem::path& file) {
    const std::string words = told_name(first_line(file));
    return words.substr(0, words.find(' '));
}

/// The folder of the USB device that a port belongs to: the nearest one above it with a vendor id. Empty
/// where there is none.
std::filesystem::path usb_device_of(const std::filesystem::path& tty) {
    constexpr int most_levels = 6; // tty, interface, device and a hub's
    std::error_code problem;
    std::filesystem::path folder = std::filesystem::canonical(tty / "device", problem);
    for (int i = 0; i < most_levels && !problem && folder.has_relative_path();
         ++i, folder = folder.parent_path())
        if (std::filesystem::exists(folder / "idVendor", problem))
            return folder;
    return {};
}

} // namespace

std::vector<FoundBoard> find_boards() { return find_boards_below("/sys/class/tty", "/dev"); }

std::vector<FoundBoard> find_boards_below(const std::filesystem::path& ttys,
                                          const std::filesystem::path& ports) {
    std::vector<FoundBoard> boards;
    std::error_code problem;
    for (std::filesystem::directory_iterator at(ttys, problem), end; !problem && at != end;
         at.increment(problem)) {
        const std::filesystem::path usb = usb_device_of(at->path());
        if (!usb.empty() && is_arduino(first_word(usb / "idVendor")))
            boards.push_back({(ports / at->path().filename()).string(), first_word(usb / "serial")});
    }
    std::sort(boards.begin(), boards.end(),
              [](const FoundBoard& a, const FoundBoard& b) { return a.path < b.path; });
    return boards;
}

} // namespace tp
