// SPDX-License-Identifier: Apache-2.0
#include "core/study_folder/study_terms.hpp"

#include "core/base/utf8.hpp"
#include "core/experiment/number_text.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace tp {
namespace {

constexpr std::string_view sitting_columns = "participant,from_trial,date,software,device,calibration";
constexpr std::size_t most_words = 1000; // bytes
constexpr int most_number = 1'000'000;

/// Without blanks and the other system's end of line.
std::string_view stripped(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Takes the next line off `rest`.
std::string_view next_line(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    return line;
}

std::string in_quotation_marks(std::string_view words) {
    std::string text = readable(words.substr(0, most_words));
    text.resize(std::min(text.size(), most_words));
    while (!is_utf8(text)) // a letter was cut in two
        text.pop_back();
    std::string cell(1, '"');
    for (const char c : text)
        cell.append(c == '"' ? 2 : 1, c);
    cell += '"';
    return cell;
}

/// Takes a cell off `rest`, up to its comma or the end; nothing where it is no cell.
std::optional<std::string> next_cell(std::string_view& rest) {
    std::string cell;
    if (!rest.starts_with('"')) {
        cell = rest.substr(0, rest.find(','));
        rest.remove_prefix(cell.size());
    } else {
        for (rest.remove_prefix(1);; rest.remove_prefix(1)) {
            if (rest.empty())
                return std::nullopt;
            if (rest.starts_with("\"\""))
                rest.remove_prefix(1);
            else if (rest.front() == '"')
                break;
            cell += rest.front();
        }
        rest.remove_prefix(1);
    }
    if (!rest.empty() && rest.front() != ',')
        return std::nullopt;
    if (cell.size() > most_words)
        return std::nullopt;
    return cell;
}

/// What is wrong with a line, the end of a sentence; empty: it is in `sitting`.
std::string take_sitting(std::string_view line, StudySitting& sitting) {
    std::array<std::string, 6> cells;
    for (std::string& cell : cells) {
        const bool is_first = &cell == &cells.front();
        if (!is_first && !line.starts_with(','))
            return "has another number of cells than there are columns";
        line.remove_prefix(is_first ? 0 : 1);
        auto text = next_cell(line);
        if (!text)
            return "has another number of cells than there are columns";
        cell = std::move(*text);
    }
    if (!line.empty())
        return "has another number of cells than there are columns";
    for (const auto& [into, cell] :
         {std::pair(&sitting.participant, &cells[0]), std::pair(&sitting.from_trial, &cells[1])}) {
        const auto number = number_in(std::string_view(*cell), 1, most_number);
        if (!number)
            return "needs whole numbers from 1 to 1000000 in its first two cells";
        *into = *number;
    }
    sitting.machine = {cells[2], cells[3], cells[4], cells[5]};
    return {};
}

} // namespace

std::string terms_text(const StudyTerms& terms) {
    return "# What holds for the whole study; README.txt explains it.\nseed: " + std::to_string(terms.seed) +
           "\nparticipants: " + (terms.simulated ? "simulated" : "people") + "\n";
}

Result<StudyTerms> read_terms(std::string_view text) {
    if (text.size() > most_terms_bytes)
        return Error{"The terms of the study are longer than " + std::to_string(most_terms_bytes / 1024) +
                     " KB."};
    std::optional<std::uint64_t> seed;
    std::optional<bool> simulated;
    int line_number = 0;
    while (!text.empty()) {
        ++line_number;
        const std::string_view line = stripped(next_line(text));
        if (line.empty() || line.starts_with('#'))
            continue;
        const std::string_view key = line.substr(0, line.find(':'));
        const std::string_view value = key.size() == line.size() ? "" : stripped(line.substr(key.size() + 1));
        std::string problem;
        if (key == "seed" && !seed) {
            seed = number_in(value, std::uint64_t{0}, ~std::uint64_t{0});
            problem = seed ? "" : "needs a whole number";
        } else if (key == "participants" && !simulated) {
            simulated = value == "simulated";
            problem = *simulated || value == "people" ? "" : "needs people or simulated";
        } else {
            problem = key == "seed" || key == "participants" ? "says it a second time" : "is not understood";
        }
        if (!problem.empty())
            return Error{"Line " + std::to_string(line_number) + " of the study's terms " + problem + "."};
    }
    if (!seed)
        return Error{"The study's terms have no seed: a line \"seed: NUMBER\" is missing."};
    if (!simulated)
        return Error{"The study's terms do not say who takes part: a line \"participants: people\" or "
                     "\"participants: simulated\" is missing."};
    return StudyTerms{*seed, *simulated};
}

std::string sittings_text(const std::vector<StudySitting>& sittings) {
    std::string csv = std::string(sitting_columns) + "\n";
    for (const StudySitting& sitting : sittings) {
        csv += std::to_string(sitting.participant) + "," + std::to_string(sitting.from_trial);
        for (const std::string* const words : {&sitting.machine.date, &sitting.machine.software,
                                               &sitting.machine.device, &sitting.machine.calibration}) {
            csv += ',';
            csv += in_quotation_marks(*words);
        }
        csv += "\n";
    }
    return csv;
}

Result<std::vector<StudySitting>> read_sittings(std::string_view csv) {
    if (csv.size() > most_sittings_bytes)
        return Error{"The table of sittings is longer than " + std::to_string(most_sittings_bytes >> 20) +
                     " MB."};
    if (stripped(next_line(csv)) != sitting_columns)
        return Error{"The table of sittings has other columns than " + std::string(sitting_columns) + "."};
    std::vector<StudySitting> sittings;
    for (int line_number = 2; !csv.empty(); ++line_number) {
        std::string_view line = next_line(csv);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        StudySitting sitting;
        if (const std::string problem = take_sitting(line, sitting); !problem.empty())
            return Error{"Line " + std::to_string(line_number) + " of the table of sittings " + problem +
                         "."};
        sittings.push_back(std::move(sitting));
    }
    return sittings;
}

} // namespace tp
