// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/training_half.hpp"

#include <fstream>

namespace tp {

Result<std::set<std::string>> held_out_people(const std::filesystem::path& list) {
    std::ifstream file(list);
    std::set<std::string> people;
    for (std::string line; std::getline(file, line);) {
        while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
            line.pop_back();
        if (!line.empty() && line.front() != '#')
            people.insert(line);
    }
    if (people.empty())
        return Error{"The file \"" + list.string() + "\" does not say who is held out of training."};
    return people;
}

std::string person_in(const std::filesystem::path& photo) {
    const std::string name = photo.stem().string();
    return name.substr(0, name.find('_'));
}

} // namespace tp
