// SPDX-License-Identifier: Apache-2.0
#include "app/cli/expression_labels.hpp"

#include "core/base/words.hpp"
#include "core/files/photo_endings.hpp"
#include "core/files/whole_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace tp {

namespace {

constexpr std::size_t most_bytes = 16 << 20;

using Row = std::vector<std::string>;

/// The rows of a CSV text, with the empty ones. Nothing where a quotation mark is left open.
std::optional<std::vector<Row>> rows_of(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    std::vector<Row> rows{{""}};
    bool in_quotes = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_quotes && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
            rows.back().back() += text[++i];
        else if (c == '"')
            in_quotes = !in_quotes;
        else if (in_quotes)
            rows.back().back() += c;
        else if (c == ',')
            rows.back().emplace_back();
        else if (c == '\n')
            rows.push_back({""});
        else if (c != '\r')
            rows.back().back() += c;
    }
    return in_quotes ? std::nullopt : std::optional(std::move(rows));
}

/// The file's name without what says how the file is written.
std::string bare_name(const std::filesystem::path& file) {
    constexpr std::array<std::string_view, 3> endings{".svg", ".truth", ".contours"};
    std::filesystem::path name = file.filename();
    for (;;) {
        std::string ending = name.extension().string();
        std::transform(ending.begin(), ending.end(), ending.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        if (std::find(endings.begin(), endings.end(), ending) == endings.end() && !has_photo_ending(name))
            return name.string();
        name = name.stem();
    }
}

std::string up_to_last_underscore(const std::string& name) { return name.substr(0, name.rfind('_')); }

} // namespace

Result<ExpressionLabels> ExpressionLabels::read(const std::filesystem::path& file) {
    const auto text = read_whole(file, most_bytes);
    if (!text)
        return Error{"The labels cannot be read: " + text.error()};
    auto labels = from_csv(*text);
    return labels ? std::move(labels) : Error{file.string() + ": " + labels.error()};
}

Result<ExpressionLabels> ExpressionLabels::from_csv(std::string_view text) {
    const auto rows = rows_of(text);
    if (!rows)
        return Error{"A quotation mark is left open."};
    const Row& head = rows->front();
    const auto column = [&](std::string_view name) {
        return static_cast<std::size_t>(std::find(head.begin(), head.end(), name) - head.begin());
    };
    const std::size_t photo = column("photo"), expression = column("expression"), person = column("person");
    if (photo == head.size() || expression == head.size())
        return Error{"The first line must name the columns photo and expression."};
    ExpressionLabels labels;
    for (std::size_t i = 1; i < rows->size(); ++i) {
        const Row& row = (*rows)[i];
        if (row.size() == 1 && row.front().empty())
            continue;
        const std::string line = "Line " + std::to_string(i + 1);
        if (row.size() != head.size())
            return Error{line + " has " + std::to_string(row.size()) + " columns where the first has " +
                         std::to_string(head.size()) + "."};
        const auto shown = expression_named(row[expression]);
        if (!shown)
            return Error{line + " says " + tp::quoted(row[expression]) +
                         ", which is not smiling, surprised, sad, angry or neutral."};
        labels.table_[row[photo]] = {person < head.size() && !row[person].empty()
                                         ? row[person]
                                         : up_to_last_underscore(bare_name(row[photo])),
                                     shown};
    }
    return labels;
}

ExpressionLabel ExpressionLabels::of(const std::filesystem::path& file) const {
    for (const std::string& key : {file.string(), file.filename().string()})
        if (const auto found = table_.find(key); found != table_.end())
            return found->second;
    const std::string name = bare_name(file);
    const std::size_t underscore = name.rfind('_');
    if (underscore == std::string::npos)
        return {name, std::nullopt};
    return {name.substr(0, underscore), expression_named(std::string_view(name).substr(underscore + 1))};
}

} // namespace tp
