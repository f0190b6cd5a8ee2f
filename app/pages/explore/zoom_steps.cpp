// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/zoom_steps.hpp"

#include <algorithm>

namespace tp {

namespace {

bool has_part(const Face& face, FacePart part) {
    return std::ranges::any_of(face.contours, [&](const Contour& contour) { return belongs_to(part, contour.name); });
}

bool shows_all(const Extraction& extraction, const Subject& subject) {
    return !subject.face && extraction.faces.size() > 1;
}

} // namespace

Subject zoomed_in(const Extraction& extraction, const Subject& now, std::size_t here) {
    if (extraction.faces.empty())
        return now;
    if (shows_all(extraction, now))
        return {std::min(here, extraction.faces.size() - 1), FacePart::whole};
    const std::size_t face = now.face.value_or(0);
    const bool before_eyes = now.part == FacePart::whole;
    if (before_eyes && has_part(extraction.faces[face], FacePart::eyes))
        return {face, FacePart::eyes};
    if (now.part != FacePart::mouth && has_part(extraction.faces[face], FacePart::mouth))
        return {face, FacePart::mouth};
    return {};
}

std::optional<Subject> zoomed_out(const Extraction& extraction, const Subject& now) {
    if (now.part == FacePart::left_eye || now.part == FacePart::right_eye)
        return Subject{now.face, FacePart::eyes};
    if (now.part != FacePart::whole)
        return extraction.faces.size() > 1 ? Subject{now.face, FacePart::whole} : Subject{};
    if (now.face && extraction.faces.size() > 1)
        return Subject{};
    return std::nullopt;
}

std::optional<Subject> zoomed_to(const Extraction& extraction, const Subject& now, const SceneFeature& there) {
    if (shows_all(extraction, now) && now.part == FacePart::whole)
        return Subject{there.face, FacePart::whole};
    if (now.part == FacePart::whole)
        for (const FacePart part : {FacePart::eyes, FacePart::mouth})
            if (belongs_to(part, there.name))
                return Subject{there.face, part};
    if (now.part == FacePart::eyes)
        for (const FacePart part : {FacePart::left_eye, FacePart::right_eye})
            if (belongs_to(part, there.name))
                return Subject{there.face, part};
    return std::nullopt;
}

} // namespace tp
