// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/haply_2diy/pantograph.hpp"

#include <filesystem>
#include <string>

namespace tp {

/// That a person has homed a board which still counts from there: kept in a file for as long as the person is
/// logged in, so that the board need not be homed each time the program opens it.
class HomedNote {
public:
    HomedNote() = default; ///< of no file: never homed
    HomedNote(std::filesystem::path file, HaplyGeneration generation);
    /// Of a board by its serial number, in the folder for what ends with the log-in.
    static HomedNote of_board(const std::string& serial_number, HaplyGeneration generation);

    bool holds() const;
    void put() const;
    void forget() const noexcept;

private:
    std::filesystem::path file_;
    std::string words_;
};

} // namespace tp
