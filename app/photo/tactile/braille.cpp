// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/braille.hpp"

#include "core/files/file_words.hpp"

#include <liblouis.h>

#include <algorithm>
#include <array>
#include <mutex>

namespace tp {

namespace {

struct BrailleTable {
    const char* language;
    const char* file; ///< of liblouis-data; uncontracted
};
constexpr std::array<BrailleTable, 3> tables{{{"en", "en-ueb-g1.ctb"}, {"de", "de-g0.utb"}, {"ko", "ko-g1.ctb"}}};

constexpr std::size_t longest_text = 1000;        ///< characters; names are shorter
constexpr widechar first_pattern = 0x2800;        ///< U+2800, the blank of Unicode's braille patterns
constexpr BrailleCell six_dots = 0x3f;

const BrailleTable* table_for(const std::string& language) {
    const std::string primary = language.substr(0, language.find_first_of("-_"));
    const auto table = std::find_if(tables.begin(), tables.end(),
                                    [&](const BrailleTable& t) { return primary == t.language; });
    return table == tables.end() ? nullptr : &*table;
}

/// What is UTF-8 is decoded; `readable` has made all of it so.
std::vector<widechar> characters_of(const std::string& text) {
    std::vector<widechar> characters;
    for (std::size_t i = 0; i < text.size() && characters.size() < longest_text;) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t more = lead < 0x80 ? 0 : lead < 0xe0 ? 1 : lead < 0xf0 ? 2 : 3;
        widechar value = more == 0 ? lead : lead & (0x3fu >> more);
        for (std::size_t k = 1; k <= more && i + k < text.size(); ++k)
            value = value << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3fu);
        i += more + 1;
        if (value != ' ' || (!characters.empty() && characters.back() != ' '))
            characters.push_back(value);
    }
    while (!characters.empty() && characters.back() == ' ')
        characters.pop_back();
    return characters;
}

/// liblouis keeps its tables in one place for the whole process and guards it by nothing. It writes to the
/// terminal unless it is given another place for its words.
class Louis {
public:
    Louis() : lock_(mutex()) {
        lou_registerLogCallback([](logLevels, const char*) {});
    }
    bool has(const char* table) const { return lou_checkTable(table) != 0; }
    std::vector<BrailleCell> cells(const char* table, const std::vector<widechar>& text) const {
        std::vector<widechar> out(8 * text.size() + 32);
        int in_length = static_cast<int>(text.size());
        int out_length = static_cast<int>(out.size());
        if (!lou_translateString(table, text.data(), &in_length, out.data(), &out_length, nullptr, nullptr,
                                 dotsIO | ucBrl | noUndefined))
            return {};
        std::vector<BrailleCell> cells;
        for (int i = 0; i < out_length; ++i)
            cells.push_back(static_cast<BrailleCell>((out[static_cast<std::size_t>(i)] - first_pattern) & six_dots));
        return cells;
    }
    int without_braille(const char* table, const std::vector<widechar>& text) const {
        return static_cast<int>(std::count_if(text.begin(), text.end(), [&](widechar character) {
            return character != ' ' && cells(table, {character}).empty();
        }));
    }

private:
    static std::mutex& mutex() {
        static std::mutex one;
        return one;
    }
    std::lock_guard<std::mutex> lock_;
};

bool is_hangul(widechar character) {
    return (character >= 0xac00 && character <= 0xd7a3) || (character >= 0x1100 && character <= 0x11ff);
}

} // namespace

std::vector<std::string> braille_languages() {
    std::vector<std::string> languages;
    for (const BrailleTable& table : tables)
        languages.emplace_back(table.language);
    return languages;
}

Result<BrailleText> braille_of(std::string_view text, const std::string& language) {
    const BrailleTable* table = table_for(language);
    if (!table)
        return Error{"There is no braille for the language " + quoted_readable(language) +
                     "; there is for en, de and ko."};
    const std::vector<widechar> characters = characters_of(readable(text));
    if (characters.empty())
        return BrailleText{};
    const Louis louis;
    if (std::any_of(characters.begin(), characters.end(), is_hangul))
        table = table_for("ko");
    if (!louis.has(table->file))
        return Error{std::string("The braille table ") + table->file +
                     " was not found; names cannot be written in braille. Install the package liblouis-data."};
    return BrailleText{louis.cells(table->file, characters), louis.without_braille(table->file, characters)};
}

std::string as_unicode(const std::vector<std::vector<BrailleCell>>& lines) {
    std::string text;
    for (const auto& line : lines) {
        if (&line != &lines.front())
            text += '\n';
        for (const BrailleCell cell : line) { // U+2800 + cell, three bytes
            text += '\xe2';
            text += static_cast<char>(0xa0 | (cell >> 6));
            text += static_cast<char>(0x80 | (cell & 0x3f));
        }
    }
    return text;
}

std::vector<std::vector<BrailleCell>> wrapped(const std::vector<BrailleCell>& cells, std::size_t most) {
    std::vector<std::vector<BrailleCell>> lines;
    for (std::size_t from = 0; from < cells.size();) {
        if (cells[from] == 0) {
            ++from;
            continue;
        }
        std::size_t to = std::min(from + most, cells.size());
        if (to < cells.size() && cells[to] != 0)
            for (std::size_t i = to; i > from; --i)
                if (cells[i] == 0) {
                    to = i;
                    break;
                }
        std::size_t end = to;
        while (end > from && cells[end - 1] == 0)
            --end;
        lines.emplace_back(cells.begin() + static_cast<std::ptrdiff_t>(from),
                           cells.begin() + static_cast<std::ptrdiff_t>(end));
        from = to;
    }
    return lines;
}

Vec2 size_of(const std::vector<std::vector<BrailleCell>>& lines) {
    std::size_t longest = 0;
    for (const auto& line : lines)
        longest = std::max(longest, line.size());
    if (longest == 0)
        return Vec2(0.0);
    return {static_cast<double>(longest - 1) * braille::cell_pitch_mm + braille::dot_pitch_mm + braille::dot_diameter_mm,
            static_cast<double>(lines.size() - 1) * braille::line_pitch_mm + 2.0 * braille::dot_pitch_mm +
                braille::dot_diameter_mm};
}

std::vector<Vec2> dots_of(const std::vector<std::vector<BrailleCell>>& lines, Vec2 corner) {
    std::vector<Vec2> dots;
    const Vec2 first = corner + Vec2(0.5 * braille::dot_diameter_mm);
    for (std::size_t row = 0; row < lines.size(); ++row)
        for (std::size_t column = 0; column < lines[row].size(); ++column)
            for (int dot = 0; dot < 6; ++dot)
                if (lines[row][column] >> dot & 1)
                    dots.push_back(first + Vec2(static_cast<double>(column) * braille::cell_pitch_mm +
                                                    (dot / 3) * braille::dot_pitch_mm,
                                                static_cast<double>(row) * braille::line_pitch_mm +
                                                    (dot % 3) * braille::dot_pitch_mm));
    return dots;
}

} // namespace tp
