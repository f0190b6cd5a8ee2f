// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/plugged_boards.hpp"

#include "device/guard/guard_process.hpp"
#include "device/haply_2diy/haply_2diy.hpp"
#include "device/haply_2diy/serial_port.hpp"

#include <memory>
#include <utility>

namespace tp {

namespace {

Result<Haply2diy::Board> open_board(const FoundBoard& found, HaplyGeneration generation) {
    Result<std::unique_ptr<SerialPort>> line = open_serial_port(found.path, "Haply 2diy");
    if (!line)
        return Error{line.error()};
    const Pantograph arms(generation);
    Result<std::unique_ptr<ForceGuard>> guard =
        start_force_guard(force_guard_program(), (*line)->handle(),
                          {"board", guard_word(encode(arms.set_up(arms.reference_deg())).view())});
    if (!guard)
        return Error{guard.error()};
    return Haply2diy::Board{std::move(*line),
                            std::move(*guard),
                            HomedNote::of_board(found.serial_number, generation),
                            {}}; // as plugged() has it
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

std::vector<PluggedDevice> plugged_boards() { return as_either_generation(find_boards()); }

std::vector<PluggedDevice> as_either_generation(const std::vector<FoundBoard>& boards) {
    std::vector<PluggedDevice> devices;
    for (const FoundBoard& found : boards)
        for (const HaplyGeneration generation : {HaplyGeneration::third, HaplyGeneration::first})
            devices.push_back(plugged(found, generation));
    return devices;
}

} // namespace tp
