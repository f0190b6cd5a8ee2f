// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/path_file.hpp"

#include "core/experiment/number_text.hpp"
#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"
#include "core/packing/gzip.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace tp {
namespace {

constexpr std::string_view path_columns = "time_s,x_mm,y_mm,fx_n,fy_n\n";
constexpr double most_value = 1e6; // s, mm, N

struct Column {
    double FingerSample::*value;
    int decimals;
};
constexpr std::array<Column, 5> columns{{{&FingerSample::time_s, 4},
                                         {&FingerSample::x_mm, 3},
                                         {&FingerSample::y_mm, 3},
                                         {&FingerSample::fx_n, 4},
                                         {&FingerSample::fy_n, 4}}};

std::string padded(int number, std::size_t digits) {
    std::string text = std::to_string(number);
    return text.insert(0, text.size() < digits ? digits - text.size() : 0, '0');
}

void put_number(std::string& text, double value, int decimals) {
    std::array<char, 32> digits;
    const char* const end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals)
            .ptr;
    std::string_view written(digits.data(), static_cast<std::size_t>(end - digits.data()));
    if (written.starts_with('-') && written.find_first_not_of("-0.") == std::string_view::npos)
        written.remove_prefix(1); // no "-0.000"
    text += written;
}

/// Whether the line has the numbers of a sample and nothing else.
bool take_sample(std::string_view line, FingerSample& sample) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string_view cell = line.substr(0, line.find(','));
        const auto value = number_in(cell, -most_value, most_value);
        if (!value)
            return false;
        sample.*columns[i].value = *value;
        line.remove_prefix(cell.size());
        if (line.empty())
            return i + 1 == columns.size();
        line.remove_prefix(1);
    }
    return false;
}

} // namespace

std::string path_file_name(int participant, int trial) {
    return "participant-" + padded(participant, 3) + "-trial-" + padded(trial, 4) + ".csv.gz";
}

bool is_path(std::span<const FingerSample> path) {
    double before = 0.0;
    for (const FingerSample& sample : path) {
        for (const Column& column : columns)
            if (!(std::abs(sample.*column.value) <= most_value))
                return false;
        if (sample.time_s < before)
            return false;
        before = sample.time_s;
    }
    return path.size() <= most_path_samples;
}

std::string path_text(std::span<const FingerSample> path) {
    std::string csv(path_columns);
    csv.reserve(csv.size() + path.size() * 40);
    for (const FingerSample& sample : path)
        for (const Column& column : columns) {
            put_number(csv, sample.*column.value, column.decimals);
            csv += &column == &columns.back() ? '\n' : ',';
        }
    return csv;
}

std::string path_bytes(std::span<const FingerSample> path) { return gzipped(path_text(path)); }

Result<std::vector<FingerSample>> read_path_text(std::string_view csv) {
    if (!csv.starts_with(path_columns))
        return Error{"The finger's path has other columns than time_s,x_mm,y_mm,fx_n,fy_n."};
    csv.remove_prefix(path_columns.size());
    std::vector<FingerSample> path;
    for (int line_number = 2; !csv.empty(); ++line_number) {
        const std::size_t end = csv.find('\n');
        if (end == std::string_view::npos)
            return Error{"The last line of the finger's path is not whole."};
        FingerSample sample;
        if (!take_sample(csv.substr(0, end), sample))
            return Error{"Line " + std::to_string(line_number) +
                         " of the finger's path has no five numbers."};
        if (sample.time_s < (path.empty() ? 0.0 : path.back().time_s))
            return Error{"Line " + std::to_string(line_number) + " of the finger's path goes back in time."};
        if (path.size() == most_path_samples)
            return Error{"The finger's path has more than " + std::to_string(most_path_samples) +
                         " samples."};
        path.push_back(sample);
        csv.remove_prefix(end + 1);
    }
    return path;
}

Result<std::vector<FingerSample>> read_path_bytes(std::string_view gzip) {
    const auto csv = gunzipped(gzip, most_path_bytes);
    if (!csv)
        return Error{"The finger's path cannot be unpacked: " + csv.error()};
    return read_path_text(*csv);
}

Result<std::vector<FingerSample>> read_path(const std::filesystem::path& file) {
    const auto bytes = read_whole(file, most_packed_path_bytes);
    if (!bytes)
        return Error{bytes.error()};
    auto path = read_path_bytes(*bytes);
    return path ? std::move(path) : Error{quoted(file) + ": " + path.error()};
}

} // namespace tp
