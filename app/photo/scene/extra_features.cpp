// SPDX-License-Identifier: Apache-2.0
#include "app/photo/scene/extra_features.hpp"

#include "core/base/words.hpp"

#include <algorithm>
#include <string>

namespace tp {

namespace {

bool is_chosen(const std::string& name, const ExtraFeatures& chosen) {
    if (name == feature::left_brow || name == feature::right_brow)
        return chosen.brows;
    if (name == feature::left_iris || name == feature::right_iris)
        return chosen.irises;
    return name == feature::nose && chosen.nose;
}

} // namespace

Result<ExtraFeatures> extra_features_named(std::string_view words) {
    ExtraFeatures chosen;
    while (!words.empty()) {
        const std::size_t comma = std::min(words.find(','), words.size());
        const std::string_view word = words.substr(0, comma);
        if (word == "brows")
            chosen.brows = true;
        else if (word == "nose")
            chosen.nose = true;
        else if (word == "irises")
            chosen.irises = true;
        else
            return Error{quoted(word) + " cannot be added to a face; brows, nose and irises can."};
        words.remove_prefix(std::min(comma + 1, words.size()));
    }
    return chosen;
}

Extraction with_extras(Extraction extraction, const ExtraFeatures& chosen) {
    for (Face& face : extraction.faces)
        for (const Contour& extra : face.extras) {
            const bool there = std::any_of(face.contours.begin(), face.contours.end(),
                                           [&](const Contour& c) { return c.name == extra.name; });
            const bool taken_away =
                std::find(face.mended.begin(), face.mended.end(), extra.name) != face.mended.end();
            if (is_chosen(extra.name, chosen) && !there && !taken_away)
                face.contours.push_back(extra);
        }
    return extraction;
}

} // namespace tp
