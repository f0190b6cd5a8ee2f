// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/face_regions.hpp"

#include "app/album/metadata/number_text.hpp"
#include "app/album/metadata/xmp_names.hpp"
#include "core/base/words.hpp"
#include "core/files/file_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace tp {

namespace {

/// A region whose centre lies that far outside is no slip of rounding.
constexpr double edge_tolerance = 0.01;
/// As far apart as rounding by another program may bring the same region.
constexpr double same_place = 1e-3;
/// Aspect ratios that differ by less are those of one picture, scaled.
constexpr double same_aspect = 0.02;

std::string text_of(const XmpValue* value) {
    return value != nullptr && !value->is_list() ? value->text : std::string{};
}

std::optional<double> number_of(const XmpValue* value) {
    return value == nullptr ? std::nullopt : number_from(value->text);
}

bool is_face(const XmpValue& region) {
    const XmpValue* type = region.field(xmp::region_type);
    return type == nullptr || type->text.empty() || type->text == "Face";
}

/// An area as it would be in the stored picture when it was marked in the one turned by an orientation.
FaceRegion turned_back(FaceRegion face, int orientation) {
    const double x = face.x;
    const double y = face.y;
    switch (orientation) {
    case 5:
        face.x = y;
        face.y = x;
        break;
    case 6:
        face.x = y;
        face.y = 1.0 - x;
        break;
    case 7:
        face.x = 1.0 - y;
        face.y = 1.0 - x;
        break;
    case 8:
        face.x = 1.0 - y;
        face.y = x;
        break;
    default:
        return face;
    }
    std::swap(face.width, face.height);
    return face;
}

/// What the areas of a list of regions refer to.
struct Frame {
    double width = 0.0, height = 0.0; ///< px; 0 where nothing says so
    int turned_by = 1;                ///< the orientation to be undone; 1: none
    bool cropped = false;             ///< another part of the picture than the stored one
};

Frame frame_of(const XmpValue& regions, const PictureShape& shape) {
    Frame frame{static_cast<double>(shape.width), static_cast<double>(shape.height)};
    const XmpValue* applied = regions.field(xmp::applied_to);
    if (applied == nullptr)
        return frame;
    const double width = number_of(applied->field(xmp::dimensions_width)).value_or(0.0);
    const double height = number_of(applied->field(xmp::dimensions_height)).value_or(0.0);
    if (!(width > 0.0) || !(height > 0.0))
        return frame;
    frame.width = width;
    frame.height = height;
    if (shape.width <= 0 || shape.height <= 0)
        return frame;
    const double stored = std::log(static_cast<double>(shape.width) / static_cast<double>(shape.height));
    const double applied_to = std::log(width / height);
    const bool upright = std::abs(applied_to - stored) < same_aspect;
    const bool turned = shape.orientation >= 5 && std::abs(applied_to + stored) < same_aspect;
    if (!upright && turned)
        frame.turned_by = shape.orientation;
    frame.cropped = !upright && !turned;
    return frame;
}

/// Within the picture, or none.
std::optional<FaceRegion> sound(FaceRegion face) {
    const auto outside = [](double place) {
        return !(place >= -edge_tolerance) || !(place <= 1.0 + edge_tolerance);
    };
    if (outside(face.x) || outside(face.y) || !(face.width >= 0.0) || !(face.height >= 0.0))
        return std::nullopt;
    face.x = std::clamp(face.x, 0.0, 1.0);
    face.y = std::clamp(face.y, 0.0, 1.0);
    face.width = std::min(face.width, 1.0);
    face.height = std::min(face.height, 1.0);
    return face;
}

/// Rectangles, circles (a diameter relative to the shorter side) and points, in the stored picture.
std::optional<FaceRegion> area_of(const XmpValue& region, const Frame& frame) {
    const XmpValue* area = region.field(xmp::region_area);
    if (area == nullptr)
        return std::nullopt;
    const auto x = number_of(area->field(xmp::area_x));
    const auto y = number_of(area->field(xmp::area_y));
    if (!x || !y)
        return std::nullopt;
    FaceRegion face{*x,
                    *y,
                    number_of(area->field(xmp::area_width)).value_or(0.0),
                    number_of(area->field(xmp::area_height)).value_or(0.0),
                    {}};
    const bool sized = frame.width > 0.0 && frame.height > 0.0;
    const bool in_pixels = text_of(area->field(xmp::area_unit)) == "pixel";
    if (const auto diameter = number_of(area->field(xmp::area_diameter))) {
        const double shorter = in_pixels ? 1.0 : std::min(frame.width, frame.height);
        face.width = sized && !in_pixels ? *diameter * shorter / frame.width : *diameter;
        face.height = sized && !in_pixels ? *diameter * shorter / frame.height : *diameter;
    }
    if (in_pixels) {
        if (!sized)
            return std::nullopt;
        face.x /= frame.width;
        face.width /= frame.width;
        face.y /= frame.height;
        face.height /= frame.height;
    }
    return sound(turned_back(std::move(face), frame.turned_by));
}

bool needs_new_area(const XmpValue& region, const Frame& frame) {
    return frame.turned_by != 1 || text_of(region.field(xmp::region_area)->field(xmp::area_unit)) == "pixel";
}

std::string whose(const std::string& name) {
    return name.empty() ? std::string("a face")
                        : "the face of " + tp::quoted(std::string_view(readable(name)));
}

XmpValue area_value(const FaceRegion& face, XmpValue before) {
    before.form = XmpValue::Form::structure;
    before.set_field(xmp::area_x, XmpValue::of(number_text(face.x)));
    before.set_field(xmp::area_y, XmpValue::of(number_text(face.y)));
    before.set_field(xmp::area_width, XmpValue::of(number_text(face.width)));
    before.set_field(xmp::area_height, XmpValue::of(number_text(face.height)));
    before.set_field(xmp::area_unit, XmpValue::of("normalized"));
    before.remove_field(xmp::area_diameter);
    return before;
}

bool in_one_place(const FaceRegion& a, const FaceRegion& b) {
    return std::abs(a.x - b.x) < same_place && std::abs(a.y - b.y) < same_place &&
           std::abs(a.width - b.width) < same_place && std::abs(a.height - b.height) < same_place;
}

/// A region that was there before, with the face that it was.
struct Known {
    XmpValue region;
    std::optional<FaceRegion> face;
};

/// Takes out the region that a face was before: the one in its place, else the one with its name; an empty
/// one where it is new.
XmpValue take_known(std::vector<Known>& known, const FaceRegion& face) {
    auto found = std::find_if(known.begin(), known.end(), [&](const Known& candidate) {
        return candidate.face && in_one_place(*candidate.face, face);
    });
    if (found == known.end() && !face.name.empty())
        found = std::find_if(known.begin(), known.end(), [&](const Known& candidate) {
            return candidate.face && candidate.face->name == face.name;
        });
    XmpValue region;
    if (found != known.end()) {
        region = std::move(found->region);
        known.erase(found);
    }
    region.form = XmpValue::Form::structure;
    return region;
}

XmpValue region_of(const FaceRegion& face, XmpValue region) {
    const XmpValue* area = region.field(xmp::region_area);
    region.set_field(xmp::region_area, area_value(face, area == nullptr ? XmpValue{} : *area));
    if (face.name.empty())
        region.remove_field(xmp::region_name);
    else
        region.set_field(xmp::region_name, XmpValue::of(face.name));
    region.set_field(xmp::region_type, XmpValue::of("Face"));
    return region;
}

std::vector<FaceRegion> named_first(std::vector<FaceRegion> faces) {
    std::stable_partition(faces.begin(), faces.end(),
                          [](const FaceRegion& face) { return !face.name.empty(); });
    return faces;
}

XmpValue list_in(const XmpValue& structure, const XmpName& name) {
    const XmpValue* list = structure.field(name);
    XmpValue result = list == nullptr ? XmpValue{} : *list;
    if (!result.is_list()) {
        result = XmpValue{};
        result.form = XmpValue::Form::bag;
    }
    return result;
}

} // namespace

std::vector<FaceRegion> faces_from_mwg(const XmpValue& regions, const PictureShape& shape,
                                       std::vector<std::string>& problems) {
    std::vector<FaceRegion> faces;
    const Frame frame = frame_of(regions, shape);
    for (const XmpValue& region : list_in(regions, xmp::region_list).items) {
        if (!is_face(region))
            continue;
        const std::string name = text_of(region.field(xmp::region_name));
        if (auto face = area_of(region, frame)) {
            face->name = name;
            faces.push_back(*std::move(face));
        } else {
            problems.push_back("The place of " + whose(name) + " makes no sense and is left out.");
        }
    }
    if (frame.cropped && !faces.empty())
        problems.push_back(
            "The faces were marked on a picture of another shape, so their places may be wrong.");
    return faces;
}

std::vector<FaceRegion> faces_from_microsoft(const XmpValue& info, std::vector<std::string>& problems) {
    std::vector<FaceRegion> faces;
    for (const XmpValue& region : list_in(info, xmp::microsoft_list).items) {
        const std::string name = text_of(region.field(xmp::microsoft_name));
        const std::string rectangle = text_of(region.field(xmp::microsoft_rectangle));
        std::string_view rest = rectangle;
        std::array<double, 4> corner_and_size{};
        bool whole = true;
        for (std::size_t i = 0; i < corner_and_size.size(); ++i) {
            const std::size_t comma = rest.find(',');
            const auto number = number_from(rest.substr(0, comma));
            whole = whole && number && (comma == std::string_view::npos) == (i == 3);
            corner_and_size[i] = number.value_or(0.0);
            rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
        }
        const auto [left, top, width, height] = corner_and_size;
        const auto face = sound({left + 0.5 * width, top + 0.5 * height, width, height, name});
        if (whole && face)
            faces.push_back(*face);
        else if (!rectangle.empty() || name.empty()) // a person without a rectangle is just in the picture
            problems.push_back("The place of " + whose(name) + " makes no sense and is left out.");
    }
    return faces;
}

XmpValue mwg_from_faces(const std::vector<FaceRegion>& faces, const std::optional<XmpValue>& before,
                        const PictureShape& shape) {
    XmpValue regions = before.value_or(XmpValue{});
    if (regions.form != XmpValue::Form::structure)
        regions = XmpValue{};
    regions.form = XmpValue::Form::structure;
    const Frame frame = frame_of(regions, shape);
    XmpValue list = list_in(regions, xmp::region_list);

    std::vector<Known> known;
    std::vector<XmpValue> no_faces;
    for (XmpValue& region : list.items) {
        std::optional<FaceRegion> face = area_of(region, frame);
        if (is_face(region)) {
            if (face)
                face->name = text_of(region.field(xmp::region_name));
            known.push_back({std::move(region), std::move(face)});
        } else {
            if (face && needs_new_area(region, frame)) // what it refers to is about to change
                region.set_field(xmp::region_area, area_value(*face, *region.field(xmp::region_area)));
            no_faces.push_back(std::move(region));
        }
    }
    list.items.clear();
    for (const FaceRegion& face : named_first(faces))
        list.items.push_back(region_of(face, take_known(known, face)));
    std::move(no_faces.begin(), no_faces.end(), std::back_inserter(list.items));
    regions.set_field(xmp::region_list, std::move(list));

    if (shape.width > 0 && shape.height > 0) {
        XmpValue dimensions;
        dimensions.form = XmpValue::Form::structure;
        dimensions.set_field(xmp::dimensions_width, XmpValue::of(std::to_string(shape.width)));
        dimensions.set_field(xmp::dimensions_height, XmpValue::of(std::to_string(shape.height)));
        dimensions.set_field(xmp::dimensions_unit, XmpValue::of("pixel"));
        regions.set_field(xmp::applied_to, std::move(dimensions));
    }
    return regions;
}

XmpValue microsoft_from_faces(const std::vector<FaceRegion>& faces, const XmpValue& before) {
    XmpValue info = before;
    if (info.form != XmpValue::Form::structure) {
        info = XmpValue{};
        info.form = XmpValue::Form::structure;
    }
    XmpValue list = list_in(info, xmp::microsoft_list);
    std::vector<Known> known;
    for (XmpValue& region : list.items) {
        const std::string name = text_of(region.field(xmp::microsoft_name));
        known.push_back({std::move(region), FaceRegion{0.0, 0.0, 0.0, 0.0, name}});
    }
    list.items.clear();
    for (const FaceRegion& face : named_first(faces)) {
        XmpValue region = face.name.empty() ? XmpValue{} : take_known(known, face);
        region.form = XmpValue::Form::structure;
        region.set_field(xmp::microsoft_rectangle,
                         XmpValue::of(number_text(face.x - 0.5 * face.width) + ", " +
                                      number_text(face.y - 0.5 * face.height) + ", " +
                                      number_text(face.width) + ", " + number_text(face.height)));
        if (!face.name.empty())
            region.set_field(xmp::microsoft_name, XmpValue::of(face.name));
        list.items.push_back(std::move(region));
    }
    info.set_field(xmp::microsoft_list, std::move(list));
    return info;
}

} // namespace tp
