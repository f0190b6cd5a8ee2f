// SPDX-License-Identifier: Apache-2.0
#include "app/cli/expression_report.hpp"

#include "app/cli/json_number.hpp"
#include "app/cli/terminal.hpp"
#include "app/figures/report/csv_table.hpp"
#include "core/files/file_words.hpp"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tp {

namespace {

bool chosen(const ExpressionChoices& choices, Expression expression) {
    return choices[static_cast<std::size_t>(expression)];
}

double share(const ExpressionShares& shares, Expression expression) {
    return shares[static_cast<std::size_t>(expression)];
}

std::string name(Expression expression) { return std::string(name_of(expression)); }

QString text(std::string_view view) {
    return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

template <typename... Values>
std::string formatted(const char* format, Values... values) {
    char line[160];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

std::string paper_cell(Expression shown) {
    const auto paper = paper_percent_right(shown);
    return paper ? formatted("%.1f", *paper) : "";
}

QJsonObject json(const ExpressionShares& shares, const ExpressionChoices& choices) {
    QJsonObject object;
    for (const Expression expression : all_expressions)
        if (chosen(choices, expression))
            object.insert(text(name_of(expression)), in_thousandths(share(shares, expression)));
    return object;
}

std::vector<std::string> table_columns(const ExpressionChoices& choices) {
    std::vector<std::string> columns{"measured", "expression", "faces"};
    for (const Expression answered : all_expressions)
        if (chosen(choices, answered))
            columns.push_back("as_" + name(answered));
    columns.insert(columns.end(), {"right_percent", "paper_percent"});
    return columns;
}

void add_rows(CsvTable& csv, const char* measured, const ExpressionTable& table,
              const ExpressionChoices& choices) {
    for (const Expression shown : all_expressions) {
        if (table.faces(shown) == 0)
            continue;
        std::vector<std::string> row{measured, name(shown), std::to_string(table.faces(shown))};
        for (const Expression answered : all_expressions)
            if (chosen(choices, answered))
                row.push_back(formatted("%.1f", table.percent(shown, answered)));
        row.push_back(chosen(choices, shown) ? formatted("%.1f", table.percent(shown, shown)) : "");
        row.push_back(paper_cell(shown));
        csv.add(std::move(row));
    }
}

CsvTable cue_table(const ExpressionReport& report) {
    std::vector<std::string> columns{"photo", "face", "person", "expression"};
    for (const CueKind& kind : cue_kinds)
        columns.emplace_back(kind.name);
    for (const char* measured : {"exact_", "felt_"})
        for (const Expression answered : all_expressions)
            if (chosen(report.choices, answered))
                columns.push_back(measured + name(answered));
    CsvTable csv(std::move(columns));
    for (const JudgedFace& face : report.faces) {
        std::vector<std::string> row{face.photo, std::to_string(face.number), face.person,
                                     face.shown ? name(*face.shown) : ""};
        for (const double cue : face.cues)
            row.push_back(formatted("%.2f", cue));
        for (const ExpressionShares* shares : {&face.exact, &face.felt})
            for (const Expression answered : all_expressions)
                if (chosen(report.choices, answered))
                    row.push_back(formatted("%.3f", share(*shares, answered)));
        csv.add(std::move(row));
    }
    return csv;
}

} // namespace

std::string words_for(const ExpressionShares& shares) {
    std::array<Expression, expression_count> order = all_expressions;
    std::stable_sort(order.begin(), order.end(),
                     [&](Expression a, Expression b) { return share(shares, a) > share(shares, b); });
    std::string words;
    for (const Expression expression : order)
        if (share(shares, expression) >= 0.005)
            words += (words.empty() ? "" : ", ") + name(expression) +
                     formatted(" %.0f %%", 100.0 * share(shares, expression));
    return words;
}

std::string line_about(const JudgedFace& face) {
    std::string line = readable(face.photo) +
                       (face.number > 1 ? " face " + std::to_string(face.number) : "") + ": " +
                       words_for(face.exact) + "; felt: " + words_for(face.felt) + ";";
    for (std::size_t i = 0; i < cue_count; ++i)
        line += formatted("%s %s %.1f", i > 0 ? "," : "", cue_kinds[i].name, face.cues[i]);
    return line;
}

QByteArray json_line(const JudgedFace& face, const ExpressionChoices& choices) {
    QJsonObject cues;
    for (std::size_t i = 0; i < cue_count; ++i)
        cues.insert(text(cue_kinds[i].name), in_thousandths(face.cues[i]));
    const QJsonObject line{
        {"photo", QString::fromStdString(face.photo)},
        {"face", face.number},
        {"person", QString::fromStdString(face.person)},
        {"expression", face.shown ? QJsonValue(text(name_of(*face.shown))) : QJsonValue(QJsonValue::Null)},
        {"answer", text(name_of(answer_of(face.exact)))},
        {"exact", json(face.exact, choices)},
        {"felt", json(face.felt, choices)},
        {"cues", cues}};
    return compact_json(line);
}

std::string words_for(const ExpressionTable& table, const ExpressionChoices& choices,
                      const std::string& title) {
    std::string words = formatted("%-22s %6s", title.c_str(), "faces");
    for (const Expression answered : all_expressions)
        if (chosen(choices, answered))
            words += formatted(" %9s", name(answered).c_str());
    words += formatted(" %8s\n", "people");
    for (const Expression shown : all_expressions) {
        if (table.faces(shown) == 0)
            continue;
        words += formatted("%-22s %6d", name(shown).c_str(), table.faces(shown));
        for (const Expression answered : all_expressions)
            if (chosen(choices, answered))
                words += formatted(" %9.1f", table.percent(shown, answered));
        words += formatted(" %8s\n", paper_cell(shown).c_str());
    }
    if (const auto right = table.percent_right(choices))
        words += formatted("right in the mean      %.1f %%\n", *right);
    return words;
}

Result<std::filesystem::path> write_expressions(const std::filesystem::path& folder,
                                                const ExpressionReport& report) {
    CsvTable tables(table_columns(report.choices));
    add_rows(tables, "exact", report.exact, report.choices);
    add_rows(tables, "felt", report.felt, report.choices);
    if (auto written = tables.write(folder / "expressions.csv"); !written)
        return written;
    return cue_table(report).write(folder / "cues.csv");
}

} // namespace tp
