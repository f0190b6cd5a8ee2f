// SPDX-License-Identifier: Apache-2.0
#include "app/photo/towns/town_list.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

extern "C" const char tp_towns[], tp_towns_end[];

namespace tp {

namespace {

constexpr std::size_t field_count = 6;
using Fields = std::array<std::string_view, field_count>;

Fields fields_of(std::string_view line) {
    Fields fields;
    for (std::string_view& field : fields) {
        const std::size_t end = std::min(line.find('\t'), line.size());
        field = line.substr(0, end);
        line.remove_prefix(std::min(end + 1, line.size()));
    }
    return fields;
}

template <typename Number>
bool read(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size();
}

} // namespace

std::vector<Town> towns_in(std::string_view text) {
    std::vector<Town> towns;
    towns.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')));
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const Fields fields = fields_of(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        Town town{0.0, 0.0, 0, fields[3], fields[4], fields[5]};
        if (read(fields[0], town.latitude) && read(fields[1], town.longitude) &&
            read(fields[2], town.thousands) && !town.name.empty())
            towns.push_back(town);
    }
    return towns;
}

const std::vector<Town>& all_towns() {
    static const std::vector<Town> towns =
        towns_in({tp_towns, static_cast<std::size_t>(tp_towns_end - tp_towns)});
    return towns;
}

} // namespace tp
