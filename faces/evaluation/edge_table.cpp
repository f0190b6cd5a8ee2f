// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/edge_table.hpp"

#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace tp {
namespace {

void add(std::string& row, std::initializer_list<double> values) {
    const char* before = "";
    for (double value : values) {
        char number[64];
        const double rounded = std::round(100.0 * value) / 100.0 + 0.0; // no -0.00
        std::snprintf(number, sizeof number, "%s%.2f", before, rounded);
        row += number;
        before = ", ";
    }
}

void add(std::string& row, const ChannelLook& look) {
    row += "{";
    add(row, {look.fine_slope, look.fine_bend, look.coarse_slope, look.coarse_bend});
    row += "}, ";
}

} // namespace

std::string edge_table_row(const EdgeLook& look, const std::string& comment) {
    std::string row = "    {";
    add(row, look.brightness);
    add(row, look.redness);
    add(row, {look.stray, look.bend});
    return row + "}, // " + comment;
}

} // namespace tp
