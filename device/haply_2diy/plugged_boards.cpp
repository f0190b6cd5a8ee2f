// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/plugged_boards.hpp"

#include "device/guard/guard_process.hpp"
#include "device/haply_2diy/haply_2diy.hpp"
#include "device/haply_2diy/posix_serial.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>

namespace tp {

namespace {

std::string first_word(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string word;
    in >> word;
    return word;
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

Result<Haply2diy::Board> open_board(const FoundBoard& found, HaplyGeneration generation) {
    Result<std::unique_ptr<PosixSerial>> line = PosixSerial::open(found.path, "Haply 2diy");
    if (!line)
        return Error{line.error()};
    const Pantograph arms(generation);
    Result<std::unique_ptr<ForceGuard>> guard =
        start_force_guard(force_guard_program(), (*line)->descriptor(),
                          {"board", guard_word(encode(arms.set_up(arms.reference_deg())).view())});
    if (!guard)
        return Error{guard.error()};
    return Haply2diy::Board{std::move(*line), std::move(*guard),
                            HomedNote::of_board(found.serial_number, generation), {}}; // as plugged() has it
}

PluggedDevice plugged(const FoundBoard& found, HaplyGeneration generation) {
    const bool first = generation == HaplyGeneration::first;
    const std::string& number = found.serial_number.empty() ? found.path : found.serial_number;
    PluggedDevice device;
    device.name = (first ? "2diy1:" : "2diy3:") + number;
    device.about = first ? "Arduino board: a Haply 2diy of the first generation?"
                         : "Arduino board: a Haply 2diy of the third generation?";
    // No serial number: the board is listed once for each generation, and only the name tells them apart.
    device.only_when_chosen = true; // any Arduino looks like one
    device.interface = [] { return std::string("serial"); };
    device.make = [found, generation]() -> std::unique_ptr<ForceDevice> {
        return std::make_unique<Haply2diy>(generation,
                                           [found, generation] { return open_board(found, generation); });
    };
    return device;
}

} // namespace

std::vector<FoundBoard> find_boards(const std::filesystem::path& ttys, const std::filesystem::path& ports) {
    std::vector<FoundBoard> boards;
    std::error_code problem;
    for (std::filesystem::directory_iterator at(ttys, problem), end; !problem && at != end;
         at.increment(problem)) {
        const std::filesystem::path usb = usb_device_of(at->path());
        const std::string vendor = usb.empty() ? "" : first_word(usb / "idVendor");
        if (vendor == "2341" || vendor == "2a03")
            boards.push_back({(ports / at->path().filename()).string(), first_word(usb / "serial")});
    }
    std::sort(boards.begin(), boards.end(),
              [](const FoundBoard& a, const FoundBoard& b) { return a.path < b.path; });
    return boards;
}

std::vector<PluggedDevice> plugged_boards() {
    std::vector<PluggedDevice> devices;
    for (const FoundBoard& found : find_boards())
        for (const HaplyGeneration generation : {HaplyGeneration::third, HaplyGeneration::first})
            devices.push_back(plugged(found, generation));
    return devices;
}

} // namespace tp
