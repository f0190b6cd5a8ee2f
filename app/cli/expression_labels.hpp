// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/study/expression.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace tp {

/// Whose face a file shows, and with which expression.
struct ExpressionLabel {
    std::string person;
    std::optional<Expression> shown; ///< nothing: not said
};

/// What people say that files show: a table, else the files' names.
class ExpressionLabels {
public:
    ExpressionLabels() = default;
    /// Reads CSV (RFC 4180) whose first line names its columns: `photo`, `expression` and, if wanted,
    /// `person`; others are passed over. The error names the line that cannot be used.
    static Result<ExpressionLabels> read(const std::filesystem::path& file);
    static Result<ExpressionLabels> from_csv(std::string_view text);

    /// The table's word on the file, by its path as given or else by its name alone. Where the table says
    /// nothing: PERSON_EXPRESSION.jpg (.truth.svg, .jpg.contours.svg …) shows that expression, and any other
    /// name says just the person, up to the last _.
    ExpressionLabel of(const std::filesystem::path& file) const;

private:
    std::map<std::string, ExpressionLabel> table_;
};

} // namespace tp
