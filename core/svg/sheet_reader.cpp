// SPDX-License-Identifier: Apache-2.0
#include "core/base/words.hpp"
#include "core/svg/arc_pieces.hpp"
#include "core/svg/contour_sheet.hpp"
#include "core/svg/shape_pieces.hpp"
#include "core/svg/sheet_limits.hpp"
#include "core/svg/sheet_names.hpp"
#include "core/svg/svg_number.hpp"
#include "core/svg/svg_style.hpp"
#include "core/svg/svg_transform.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace tp {

namespace {

using svg::LengthScale;
using svg::Subpath;
using svg::ViewBox;

constexpr double css_units_per_mm = 96.0 / 25.4;

/// How the children of an element see the plane.
struct View {
    Affine to_sheet;
    LengthScale lengths;
};

/// Names come from files, and a sentence is spoken.
std::string shortened(std::string_view text) {
    std::string name = svg::valid_utf8(text);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < 0x20; }, ' ');
    constexpr std::size_t longest = 60;
    if (name.size() <= longest)
        return name;
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0u) == 0x80u)
        --end;
    return name.substr(0, end) + "…";
}

std::string quoted_short(std::string_view text) { return tp::quoted(shortened(text)); }

std::string spoken_name(pugi::xml_node element) {
    const std::string_view tag = element.name();
    const std::string kind = tag == "g" ? "group" : shortened(tag);
    const std::string_view id = element.attribute("id").value();
    return id.empty() ? "The " + kind + " without an id" : "The " + kind + " " + quoted_short(id);
}

/// The name without its prefix, where the prefix is the root's; empty for elements of another vocabulary.
std::string_view local_name(std::string_view name, std::string_view prefix) {
    if (!name.starts_with(prefix))
        return {};
    name.remove_prefix(prefix.size());
    return name.find(':') == std::string_view::npos ? name : std::string_view{};
}

bool is_hidden(pugi::xml_node element) {
    const std::string styled = svg::style_value(element.attribute("style").value(), "display");
    return styled.empty() ? svg::trimmed(element.attribute("display").value()) == "none" : styled == "none";
}

/// One of the sheet's sides, where the root element says it: nothing where it leaves it to the viewBox.
Result<std::optional<double>> side(pugi::xml_node root, const char* name, double units_per_mm) {
    const std::string_view text = svg::trimmed(root.attribute(name).value());
    if (text.empty() || text == "auto" || text.ends_with('%'))
        return std::optional<double>{};
    const auto length = svg::length_in_units(text, units_per_mm, 0.0);
    if (!length || !std::isfinite(*length))
        return Error{"The drawing's " + std::string(name) + " " + quoted_short(text) +
                     " is not a length in mm, cm, in, pt, pc or px."};
    if (!(*length > 0.0))
        return Error{"The drawing's " + std::string(name) + " is " + shortened(text) +
                     ", but it must be larger than zero."};
    return length;
}

class SheetReader {
public:
    explicit SheetReader(ContourSheet::Unit unit)
        : units_per_mm_(unit == ContourSheet::Unit::millimetre ? 1.0 : css_units_per_mm) {
        sheet_.unit = unit;
    }

    Result<ContourSheet> read(std::string_view text) {
        pugi::xml_document document;
        if (const auto trouble = parse(document, text))
            return *trouble;
        const pugi::xml_node root = document.document_element();
        const std::string_view name = root.name();
        const std::size_t colon = name.find(':');
        prefix_ = colon == std::string_view::npos ? std::string_view{} : name.substr(0, colon + 1);
        if (local_name(name, prefix_) != "svg")
            return Error{"This is not an SVG drawing: it begins with <" + shortened(name) +
                         "> where <svg> is expected."};
        View view;
        if (const auto trouble = measure(root, view))
            return *trouble;
        if (const auto trouble = walk(root, view))
            return *trouble;
        svg::make_unique(names_);
        for (std::size_t i = 0; i < names_.size(); ++i)
            sheet_.contours[i].name = std::move(names_[i]);
        return std::move(sheet_);
    }

private:
    using Trouble = std::optional<Error>;

    static Trouble parse(pugi::xml_document& document, std::string_view text) {
        if (text.size() > svg::most_bytes)
            return Error{"The drawing is larger than 64 MB; that is more than a sheet of contours may be."};
        if (text.starts_with("\x1F\x8B"))
            return Error{"This is a compressed drawing (svgz); save it as plain SVG."};
        if (static_cast<std::size_t>(std::count(text.begin(), text.end(), '<')) > svg::most_tags ||
            static_cast<std::size_t>(std::count(text.begin(), text.end(), '=')) > svg::most_attributes)
            return Error{"The drawing has more elements than a sheet of contours may have."};
        const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
        if (parsed.status == pugi::status_no_document_element)
            return Error{"This is not an SVG drawing: there is nothing in it."};
        if (!parsed) {
            const auto offset =
                std::min(text.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, parsed.offset)));
            const auto end = text.begin() + static_cast<std::ptrdiff_t>(offset);
            const auto line = 1 + std::count(text.begin(), end, '\n');
            return Error{"This is not an SVG drawing: its text is broken near line " + std::to_string(line) +
                         "."};
        }
        return {};
    }

    /// The sheet's size, and how the root's children see the sheet.
    Trouble measure(pugi::xml_node root, View& view) {
        const auto width = side(root, "width", units_per_mm_);
        if (!width)
            return Error{width.error()};
        const auto height = side(root, "height", units_per_mm_);
        if (!height)
            return Error{height.error()};
        std::optional<ViewBox> box;
        if (const auto attribute = root.attribute("viewBox"); !svg::trimmed(attribute.value()).empty()) {
            box = svg::view_box_from(attribute.value());
            if (!box)
                return Error{"The drawing's viewBox " + quoted_short(attribute.value()) +
                             " is not four numbers with a width and a height larger than zero."};
        }
        if (!box && !(*width && *height))
            return Error{
                "The drawing does not say how large it is; give it a width and a height, or a viewBox."};
        if (*width && *height) {
            sheet_.width = **width;
            sheet_.height = **height;
        } else if (*width) {
            sheet_.width = **width;
            sheet_.height = **width / box->width * box->height;
        } else if (*height) {
            sheet_.width = **height / box->height * box->width;
            sheet_.height = **height;
        } else {
            sheet_.width = box->width;
            sheet_.height = box->height;
        }
        if (!(sheet_.width > 0.0) || !(sheet_.height > 0.0) || !std::isfinite(sheet_.width) ||
            !std::isfinite(sheet_.height))
            return Error{"The drawing's size is beyond what can be computed with."};
        view.lengths = {units_per_mm_, sheet_.width, sheet_.height};
        if (box) {
            view.to_sheet = svg::fit_view_box(*box, sheet_.width, sheet_.height,
                                              root.attribute("preserveAspectRatio").value());
            view.lengths = {css_units_per_mm, box->width, box->height};
        }
        return apply_transform(root, view);
    }

    /// Depth first in document order. The open groups are kept here, not on the call stack, so that a file
    /// can nest as deep as it likes.
    Trouble walk(pugi::xml_node root, const View& root_view) {
        struct Open {
            pugi::xml_node next;
            View view;
        };
        if (is_hidden(root))
            return {};
        std::vector<Open> open{{root.first_child(), root_view}};
        while (!open.empty()) {
            const pugi::xml_node element = open.back().next;
            if (!element) {
                open.pop_back();
                continue;
            }
            open.back().next = element.next_sibling();
            const std::string_view name = local_name(element.name(), prefix_);
            const bool holds_others = name == "g" || name == "svg" || name == "a" || name == "switch";
            if ((!holds_others && !svg::is_shape(name)) || is_hidden(element))
                continue;
            View view = open.back().view;
            if (const auto trouble = apply_transform(element, view))
                return trouble;
            if (!holds_others) {
                if (const auto trouble = draw(element, name, view))
                    return trouble;
            } else if (name != "svg" || enter_viewport(element, view)) {
                open.push_back({element.first_child(), view});
            }
        }
        return {};
    }

    static Trouble apply_transform(pugi::xml_node element, View& view) {
        const std::string styled = svg::style_value(element.attribute("style").value(), "transform");
        if (!styled.empty() && styled != "none")
            return Error{spoken_name(element) + " is moved by its style, which is not understood; "
                                                "give it a transform attribute instead."};
        const char* text = element.attribute("transform").value();
        const auto transform = svg::transform_from(text);
        if (!transform)
            return Error{spoken_name(element) + " has a transform that cannot be read: " + quoted_short(text) +
                         "."};
        view.to_sheet = compose(view.to_sheet, *transform);
        return {};
    }

    /// An svg element inside another one; false where it shows nothing.
    static bool enter_viewport(pugi::xml_node element, View& view) {
        const LengthScale outer = view.lengths;
        const auto length = [&](const char* name, double whole, double otherwise) {
            const std::string_view text = svg::trimmed(element.attribute(name).value());
            const auto value = svg::length_in_units(text, outer.units_per_mm, whole);
            return value && std::isfinite(*value) ? *value : otherwise;
        };
        const Vec2 corner(length("x", outer.width, 0.0), length("y", outer.height, 0.0));
        const Vec2 size(length("width", outer.width, outer.width),
                        length("height", outer.height, outer.height));
        if (!(size.x > 0.0) || !(size.y > 0.0))
            return false;
        view.to_sheet = compose(view.to_sheet, Affine{glm::dmat2(1.0), corner});
        view.lengths.width = size.x;
        view.lengths.height = size.y;
        const std::string_view text = element.attribute("viewBox").value();
        if (svg::trimmed(text).empty())
            return true;
        const auto box = svg::view_box_from(text);
        if (!box)
            return false;
        view.to_sheet =
            compose(view.to_sheet, svg::fit_view_box(*box, size.x, size.y,
                                                     element.attribute("preserveAspectRatio").value()));
        view.lengths = {css_units_per_mm, box->width, box->height};
        return true;
    }

    Trouble draw(pugi::xml_node element, std::string_view kind, const View& view) {
        const double stretch = svg::largest_stretch(view.to_sheet);
        const double tolerance = stretch > 0.0 ? svg::arc_tolerance / stretch : svg::arc_tolerance;
        auto drawn = svg::subpaths_of(element, kind, view.lengths, tolerance, svg::most_pieces - pieces_);
        if (!drawn)
            return Error{spoken_name(element) + " " + drawn.error() + "."};
        const std::string name =
            svg::name_from(element.attribute("id").value(), element.attribute("data-name").value());
        for (Subpath& path : *drawn) {
            Contour contour = on_sheet(std::move(path), view.to_sheet);
            pieces_ += contour.pieces.size();
            name_bytes_ += name.size();
            if (pieces_ >= svg::most_pieces || sheet_.contours.size() >= svg::most_contours ||
                name_bytes_ > svg::most_name_bytes)
                return Error{"The drawing has more lines than a sheet of contours may have."};
            for (const Piece& piece : contour.pieces)
                if (!is_finite(piece))
                    return Error{spoken_name(element) + " reaches beyond what can be computed with."};
            sheet_.contours.push_back(std::move(contour));
            names_.push_back(name);
        }
        return {};
    }

    /// Mapped and made tidy: ends of closed contours joined, straight pieces of length zero left out unless
    /// they are all there is. What is read is so exactly what is written again.
    static Contour on_sheet(Subpath path, const Affine& to_sheet) {
        const Contour raw = mapped(Contour{{}, std::move(path.pieces), path.closed}, to_sheet);
        Contour contour{{}, {}, path.closed};
        contour.pieces.reserve(raw.pieces.size() + 1);
        for (const Piece& piece : raw.pieces)
            append(contour, piece);
        const Vec2 start = raw.pieces.empty() ? to_sheet(path.start) : start_of(raw.pieces.front());
        if (contour.closed && !contour.pieces.empty()) {
            const Vec2 end = end_of(contour.pieces.back());
            if (length(end - start) <= svg::joint_tolerance) {
                std::visit([&](auto& piece) { piece.b = start; }, contour.pieces.back());
                if (is_dot(contour.pieces.back()) && std::holds_alternative<Line>(contour.pieces.back()))
                    contour.pieces.pop_back();
            } else {
                append(contour, Line{end, start});
            }
        }
        if (contour.pieces.empty() || (contour.pieces.size() == 1 && is_dot(contour.pieces.front())))
            contour.pieces.assign(1, Line{start, start});
        return contour;
    }

    static void append(Contour& contour, const Piece& piece) {
        if (!std::holds_alternative<Line>(piece) || !is_dot(piece))
            contour.pieces.push_back(piece);
    }

    /// All defining points are one. (Not so for what is not finite, which is refused later.)
    static bool is_dot(const Piece& piece) {
        struct Visitor {
            bool operator()(const Line& p) const { return p.a == p.b; }
            bool operator()(const Quadratic& p) const { return p.a == p.control && p.a == p.b; }
            bool operator()(const Cubic& p) const {
                return p.a == p.control_a && p.a == p.control_b && p.a == p.b;
            }
        };
        return std::visit(Visitor{}, piece);
    }

    double units_per_mm_; ///< of lengths with a unit, where 1 user unit is 1 unit of the sheet
    std::string_view prefix_;
    ContourSheet sheet_;
    std::vector<std::string> names_; ///< one a contour, not yet unique
    std::size_t pieces_ = 0;
    std::size_t name_bytes_ = 0;
};

} // namespace

Result<ContourSheet> sheet_from_svg(std::string_view text, ContourSheet::Unit unit) {
    try {
        return SheetReader(unit).read(text);
    } catch (const std::exception&) {
        return Error{"The drawing could not be read: there is not enough memory for it."};
    }
}

} // namespace tp
