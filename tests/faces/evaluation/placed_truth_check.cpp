// SPDX-License-Identifier: Apache-2.0
#include "placed_truth_check.hpp"

#include "faces/evaluation/placed_truth.hpp"
#include "memory_folder.hpp"

#include <algorithm>

namespace tp::test {

std::string complaint_about_placed_truth(std::string_view bytes) {
    static const MemoryFolder folder;
    const auto people = read_placed_truth(folder.file("truth.json", bytes), "/photos");
    if (!people)
        return people.error().size() > 10 ? "" : "no sentence: " + people.error();
    if (people->empty())
        return "nobody";
    for (const PlacedPortrait& person : *people) {
        if (person.truth.size() != 5)
            return "a photograph without its five contours";
        for (const Contour& contour : person.truth)
            if (contour.pieces.size() < 2 ||
                !std::ranges::all_of(contour.pieces, [](const Piece& piece) { return is_finite(piece); }))
                return "a contour that is nowhere";
    }
    return {};
}

} // namespace tp::test
