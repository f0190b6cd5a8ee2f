// SPDX-License-Identifier: Apache-2.0
#include "device/haply_2diy/homed_note.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace tp {

HomedNote::HomedNote(std::filesystem::path file, HaplyGeneration generation)
    : file_(std::move(file)), words_(generation == HaplyGeneration::first ? "homed_1\n" : "homed_3\n") {}

HomedNote HomedNote::of_board(const std::string& serial_number, HaplyGeneration generation) {
    const char* const folder = std::getenv("XDG_RUNTIME_DIR");
    if (folder == nullptr || serial_number.empty())
        return {};
    std::string name = "touchphoto-2diy-";
    for (const char letter : serial_number)
        name += letter == '/' ? '_' : letter;
    return HomedNote(std::filesystem::path(folder) / name, generation);
}

bool HomedNote::holds() const {
    if (file_.empty())
        return false;
    std::ifstream note(file_);
    return std::string(std::istreambuf_iterator<char>(note), {}) == words_;
}

void HomedNote::put() const {
    if (!file_.empty())
        std::ofstream(file_) << words_;
}

void HomedNote::forget() const noexcept {
    std::error_code none;
    if (!file_.empty())
        std::filesystem::remove(file_, none);
}

} // namespace tp
