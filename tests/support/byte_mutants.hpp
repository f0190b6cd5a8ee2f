// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "corpus.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace tp::test {

/// Changes binary files of a corpus, each a little: bits, bytes, numbers that a size may not be, cuts,
/// copies; seeded.
class ByteMutator {
public:
    explicit ByteMutator(std::uint64_t seed) : random_(seed) {}

    std::string mutant(const std::vector<Seed>& seeds) {
        std::string bytes = seeds[below(seeds.size())].text;
        for (std::size_t steps = 1 + below(4); steps > 0; --steps)
            change(bytes, seeds);
        return bytes;
    }

private:
    std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random_() % n); }

    /// Most often near the beginning, where a file's head is.
    std::size_t place_in(const std::string& bytes) {
        return below(below(3) == 0 ? bytes.size() + 1 : std::min<std::size_t>(bytes.size(), 128) + 1);
    }

    void change(std::string& bytes, const std::vector<Seed>& seeds) {
        static constexpr std::array<std::uint32_t, 10> sizes{
            0, 1, 0xFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF, 0x40000000, 0x00FFFFFF};
        const std::size_t at = place_in(bytes);
        switch (below(8)) {
        case 0:
        case 1:
            if (at < bytes.size())
                bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1u << below(8)));
            break;
        case 2:
            if (at < bytes.size())
                bytes[at] = static_cast<char>(random_() & 0xFFu);
            break;
        case 3:
        case 4: { // four bytes, either end first
            const std::uint32_t size = sizes[below(sizes.size())];
            const bool turned = below(2) == 0;
            for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i)
                bytes[at + i] = static_cast<char>(size >> (8 * (turned ? 3 - i : i)) & 0xFFu);
            break;
        }
        case 5:
            bytes.resize(below(bytes.size() + 1));
            break;
        case 6:
            bytes.erase(at, below(20));
            break;
        default: {
            const std::string& other = seeds[below(seeds.size())].text;
            bytes.insert(at, other.substr(below(other.size()), below(120)));
        }
        }
    }

    std::mt19937_64 random_;
};

} // namespace tp::test
