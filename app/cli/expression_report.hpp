// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/study/expression_cues.hpp"
#include "core/study/expression_table.hpp"

#include <QByteArray>

#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// One face as the observer saw it.
struct JudgedFace {
    std::string photo;
    int number = 1; ///< of the faces of its photograph, from 1
    std::string person;
    std::optional<Expression> shown; ///< nothing: not said, and in no table
    ExpressionCues cues{};
    ExpressionShares exact{}; ///< how likely each answer is where the cues are known exactly
    ExpressionShares felt{};  ///< how often each is given where a finger felt them
};

/// All of what one run found, in the answers' order.
struct ExpressionReport {
    ExpressionChoices choices = paper_choices;
    std::vector<JudgedFace> faces;
    ExpressionTable exact;
    ExpressionTable felt;
};

/// "sad 98 %, angry 2 %": what has at least half a percent, the largest first.
std::string words_for(const ExpressionShares& shares);

/// A line to read, and a line of JSON, about one face.
std::string line_about(const JudgedFace& face);
QByteArray json_line(const JudgedFace& face, const ExpressionChoices& choices);

/// The confusion table beside the paper's, to read.
std::string words_for(const ExpressionTable& table, const ExpressionChoices& choices,
                      const std::string& title);

/// Writes expressions.csv, the tables, and cues.csv, the faces; columns stand in app/cli/VERBS.md.
Result<std::filesystem::path> write_expressions(const std::filesystem::path& folder,
                                                const ExpressionReport& report);

} // namespace tp
