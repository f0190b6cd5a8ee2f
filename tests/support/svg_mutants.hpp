// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "corpus.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace tp::test {

/// What a blind change of bytes would take long to hit upon.
inline constexpr std::array<std::string_view, 44> words = {"<path d=\"M0 0L1 1Z\"/>",
                                                           "<g transform=\"scale(2)\">",
                                                           "</g>",
                                                           "<circle r=\"5\"/>",
                                                           "<rect width=\"3\" height=\"4\" rx=\"1\"/>",
                                                           " transform=\"rotate(30 1 2)\"",
                                                           " transform=\"skewX(89.9999999)\"",
                                                           " transform=\"matrix(1 0 0 0 0 0)\"",
                                                           " viewBox=\"0 0 1e300 1e-300\"",
                                                           " viewBox=\"-5 -5 10 20\"",
                                                           " preserveAspectRatio=\"none\"",
                                                           " preserveAspectRatio=\"xMaxYMin slice\"",
                                                           " width=\"1e308mm\"",
                                                           " height=\"50%\"",
                                                           " id=\"a b\"",
                                                           " data-name=\"a%20b\"",
                                                           " id=\"a_b\"",
                                                           " style=\"display:none\"",
                                                           "display:inline",
                                                           "1e400",
                                                           "1e-400",
                                                           "-0",
                                                           "nan",
                                                           "inf",
                                                           "1e308",
                                                           "-1e308",
                                                           "4.9e-324",
                                                           "A 5 3 20 1 0 9 9",
                                                           "a1 1 0 0 1 1e-9 0",
                                                           "A1e-300 1e300 0 1 1 5 5",
                                                           "z",
                                                           "m",
                                                           "T 3 4",
                                                           "s 1 2 3 4",
                                                           "C0 0 0 0 0 0",
                                                           "Q 1e200 1e200 0 0",
                                                           "&#0;",
                                                           "&#1;",
                                                           "&amp;",
                                                           "&lol;",
                                                           "]]>",
                                                           "<![CDATA[",
                                                           std::string_view("\0", 1),
                                                           "\xFF"};

/// Changes texts of a corpus, each a little; seeded.
class Mutator {
public:
    explicit Mutator(std::uint64_t seed) : random_(seed) {}

    std::string mutant(const std::vector<Seed>& seeds) {
        std::string text = seeds[below(seeds.size())].text;
        const std::size_t steps = 1 + below(3);
        for (std::size_t i = 0; i < steps; ++i)
            change(text, seeds);
        text.resize(std::min(text.size(), longest));
        return text;
    }

private:
    static constexpr std::size_t longest = 16'384;

    std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random_() % n); }

    void change(std::string& text, const std::vector<Seed>& seeds) {
        const std::size_t at = below(text.size() + 1);
        switch (below(10)) {
        case 0:
            if (at < text.size())
                text[at] = static_cast<char>(random_() & 0xFFu);
            break;
        case 1:
            if (at < text.size())
                text[at] = static_cast<char>(text[at] ^ static_cast<char>(1u << below(8)));
            break;
        case 2:
            text.erase(at, below(20));
            break;
        case 3:
            text.insert(at, text.substr(at, below(60)));
            break;
        case 4: { // another seed's middle
            const std::string& other = seeds[below(seeds.size())].text;
            text.insert(at, other.substr(below(other.size()), below(120)));
            break;
        }
        case 5: // in place of a number, most often
            if (const std::size_t digit = text.find_first_of("0123456789", at); digit != std::string::npos)
                text.replace(digit, 1, words[below(words.size())]);
            break;
        case 6:
        case 7:
        case 8:
            if (const std::size_t digit = text.find_first_of("0123456789", at); digit != std::string::npos)
                text[digit] = static_cast<char>('0' + below(10));
            break;
        default:
            text.insert(at, words[below(words.size())]);
        }
    }

    std::mt19937_64 random_;
};

} // namespace tp::test
