// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_work.hpp"

#include "app/photo/scene/corrections.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tp {

namespace {

constexpr std::array usual_features{feature::left_eye, feature::right_eye, feature::outer_lip, feature::inner_lip,
                                    feature::outline};

const Contour* named(const std::vector<Contour>& contours, const std::string& name) {
    const auto own =
        std::find_if(contours.begin(), contours.end(), [&](const Contour& c) { return c.name == name; });
    return own == contours.end() ? nullptr : &*own;
}

std::optional<MendContour> mendable_or_none(const Contour* contour) {
    return contour ? mendable(*contour) : std::nullopt;
}

MendFace mend_face(const Face* found, const Face& shown) {
    MendFace face{shown.box, {}};
    std::vector<std::string> names(usual_features.begin(), usual_features.end());
    const auto add_names = [&](const std::vector<Contour>& contours) {
        for (const Contour& contour : contours)
            if (std::find(names.begin(), names.end(), contour.name) == names.end())
                names.push_back(contour.name);
    };
    add_names(shown.contours);
    add_names(shown.extras);
    for (const std::string& name : names) {
        MendFeature own;
        own.name = name;
        own.line = mendable_or_none(named(shown.contours, name));
        if (found)
            own.found = mendable_or_none(named(found->contours, name));
        own.found_felt = own.found.has_value();
        own.mended = std::find(shown.mended.begin(), shown.mended.end(), name) != shown.mended.end();
        if (!own.found && found) // brows, nose, irises: where they are, should they be wanted
            own.found = mendable_or_none(named(found->extras, name));
        face.features.push_back(std::move(own));
    }
    return face;
}

/// Where usual features lie: x in shares of a head's width from its middle (positive: the person's left), y of
/// its height from its middle, down. Corners first and last where two are named.
MendContour at(const MendFace& face, std::string name, bool closed, const std::vector<MendNode>& shares) {
    MendContour contour{std::move(name), shares, closed};
    for (MendNode& node : contour.nodes)
        node.at = face.box.centre() + node.at * Vec2(face.box.width(), face.box.height());
    return contour;
}

constexpr auto corner = MendNode::Kind::corner;
constexpr auto smooth = MendNode::Kind::smooth;
constexpr auto control = MendNode::Kind::control;

/// Two corners with an arc of two quadratics above and below.
std::vector<MendNode> almond(Vec2 middle, double half_width, double above, double below) {
    const auto place = [&](double x, double y) { return middle + Vec2(x * half_width, y); };
    return {{place(-1, 0), corner},         {place(-0.5, -above), control}, {place(0, -above), smooth},
            {place(0.5, -above), control},  {place(1, 0), corner},          {place(0.5, below), control},
            {place(0, below), smooth},      {place(-0.5, below), control}};
}

std::vector<MendNode> usual_places(const std::string& name) {
    if (name == feature::left_eye)
        return almond({0.19, -0.12}, 0.11, 0.045, 0.035);
    if (name == feature::right_eye)
        return almond({-0.19, -0.12}, 0.11, 0.045, 0.035);
    if (name == feature::inner_lip)
        return almond({0.0, 0.25}, 0.13, 0.012, 0.012);
    if (name == feature::outline)
        return {{{-0.46, -0.1}, corner}, {{-0.45, 0.2}, control},  {{-0.3, 0.35}, smooth}, {{-0.15, 0.5}, control},
                {{0.0, 0.5}, smooth},    {{0.15, 0.5}, control},   {{0.3, 0.35}, smooth},  {{0.45, 0.2}, control},
                {{0.46, -0.1}, corner}};
    return almond({0.0, 0.25}, 0.17, 0.055, 0.06); // the lips
}

std::string counterpart(const std::string& name) {
    if (name.starts_with("left_"))
        return "right_" + name.substr(5);
    if (name.starts_with("right_"))
        return "left_" + name.substr(6);
    return {};
}

const MendFeature* feature_named(const MendFace& face, const std::string& name) {
    for (const MendFeature& own : face.features)
        if (own.name == name)
            return &own;
    return nullptr;
}

/// x of the line that a face is alike on both sides of.
double middle_of(const MendFace& face) {
    for (const char* name : {feature::outer_lip, feature::inner_lip, feature::outline})
        if (const MendFeature* own = feature_named(face, name); own && own->line)
            return bounds_of(*own->line).centre().x;
    return face.box.centre().x;
}

} // namespace

MendWork work_on(const Extraction& found, const Extraction& corrected) {
    MendWork work{static_cast<double>(corrected.width), static_cast<double>(corrected.height), {}};
    for (const Face& shown : corrected.faces) {
        const auto same = std::find_if(found.faces.begin(), found.faces.end(), [&](const Face& face) {
            return face.box.min == shown.box.min && face.box.max == shown.box.max;
        });
        work.faces.push_back(mend_face(same == found.faces.end() ? nullptr : &*same, shown));
    }
    return work;
}

ContourSheet sheet_of(const MendWork& work) {
    ContourSheet sheet{work.width, work.height, ContourSheet::Unit::pixel, {}};
    for (std::size_t i = 0; i < work.faces.size(); ++i)
        for (const MendFeature& own : work.faces[i].features) {
            const std::string name =
                work.faces.size() > 1 ? "face " + std::to_string(i + 1) + " " + own.name : own.name;
            if (!own.mended)
                continue;
            if (own.line) {
                sheet.contours.push_back(contour_of(*own.line));
                sheet.contours.back().name = name;
            } else if (own.found) {
                sheet.contours.push_back(
                    contour_through(removed_name(name), {bounds_of(*own.found).centre()}, false));
            }
        }
    return sheet;
}

std::vector<Face> faces_of(const MendWork& work) {
    std::vector<Face> faces;
    for (const MendFace& own : work.faces) {
        Face face;
        face.box = own.box;
        for (const MendFeature& each : own.features)
            if (each.line) {
                face.contours.push_back(contour_of(*each.line));
                face.contours.back().name = each.name;
            }
        faces.push_back(std::move(face));
    }
    return faces;
}

MendContour template_for(const MendFace& face, const std::string& name) {
    const bool inner = name == feature::inner_lip;
    if (inner || name == feature::outer_lip)
        if (const MendFeature* lips = feature_named(face, inner ? feature::outer_lip : feature::inner_lip);
            lips && lips->line) { // one round the other
            const Rect box = bounds_of(*lips->line);
            const double half_width = (inner ? 0.36 : 0.68) * box.width();
            const double half_height = inner ? 0.12 * box.height() : 0.17 * box.width() + 0.5 * box.height();
            return {name, almond(box.centre(), half_width, half_height, half_height), true};
        }
    const MendFeature* other = feature_named(face, counterpart(name));
    if (!other || !other->line)
        return at(face, name, name != feature::outline, usual_places(name));
    MendContour mirrored = *other->line;
    mirrored.name = name;
    const double middle = middle_of(face);
    for (MendNode& node : mirrored.nodes)
        node.at.x = 2.0 * middle - node.at.x;
    return mirrored;
}

MendFace usual_face(Vec2 centre, double height) {
    const Vec2 half(0.4 * height, 0.5 * height);
    MendFace face{{centre - half, centre + half}, {}};
    for (const char* name : usual_features)
        face.features.push_back({name, template_for(face, name), std::nullopt, false, true});
    return face;
}

} // namespace tp
