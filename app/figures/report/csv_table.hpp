// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// Rows of text under named columns, written as CSV (RFC 4180).
class CsvTable {
public:
    explicit CsvTable(std::vector<std::string> columns) : rows_{std::move(columns)} {}
    /// As many cells as there are columns.
    void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
    std::size_t row_count() const { return rows_.size() - 1; }
    Result<std::filesystem::path> write(const std::filesystem::path& file) const;

private:
    std::vector<std::vector<std::string>> rows_;
};

/// A number with `digits` significant digits, as a CSV cell; "nan" and "inf" spelled so.
std::string cell(double value, int digits = 6);

} // namespace tp
