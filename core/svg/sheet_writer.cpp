// SPDX-License-Identifier: Apache-2.0
#include "core/svg/contour_sheet.hpp"
#include "core/svg/sheet_limits.hpp"
#include "core/svg/sheet_names.hpp"

#include <pugixml.hpp>

#include <array>
#include <charconv>
#include <string>

namespace tp {

namespace {

/// The shortest text that reads back as the same double.
std::string number(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

/// Path data of one contour, absolute commands only: rounding cannot add up.
class PathData {
public:
    std::string of(const Contour& contour) {
        for (const Piece& piece : contour.pieces)
            if (is_finite(piece))
                std::visit([this](const auto& p) { add(p); }, piece);
        if (contour.closed && !text_.empty())
            text_ += " Z";
        else if (only_dots_)
            curve_to_here();
        return text_;
    }

private:
    void add(const Line& p) {
        go_to(p.a);
        if (p.a == p.b)
            return;
        command("L", p.b);
        drawn_to(p.b);
    }
    void add(const Quadratic& p) {
        go_to(p.a);
        command("Q", p.control);
        point(p.b);
        drawn_to(p.b);
    }
    void add(const Cubic& p) {
        go_to(p.a);
        command("C", p.control_a);
        point(p.control_b);
        point(p.b);
        drawn_to(p.b);
    }

    /// Pieces join; where they should but do not, a straight one spans the gap.
    void go_to(Vec2 p) {
        if (text_.empty()) {
            command("M", p);
            at_ = p;
            only_dots_ = true;
        } else if (length(p - at_) > svg::joint_tolerance) {
            command("L", p);
            drawn_to(p);
        }
    }

    /// Readers drop a straight line of length zero, so a dot is a curve of length zero.
    void curve_to_here() {
        command("C", at_);
        point(at_);
        point(at_);
    }

    void command(const char* letter, Vec2 p) {
        if (!text_.empty())
            text_ += ' ';
        text_ += letter;
        point(p);
    }
    void point(Vec2 p) { text_ += ' ' + number(p.x) + ' ' + number(p.y); }
    void drawn_to(Vec2 p) {
        at_ = p;
        only_dots_ = false;
    }

    std::string text_;
    Vec2 at_{0.0};
    bool only_dots_ = false;
};

struct StringWriter final : pugi::xml_writer {
    std::string text;
    void write(const void* data, std::size_t size) override {
        text.append(static_cast<const char*>(data), size);
    }
};

void set(pugi::xml_node node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(value.c_str());
}

} // namespace

std::string sheet_to_svg(const ContourSheet& sheet) {
    const bool in_mm = sheet.unit == ContourSheet::Unit::millimetre;
    const std::string unit = in_mm ? "mm" : "px";
    const std::string width = number(sheet.width);
    const std::string height = number(sheet.height);

    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    set(declaration, "version", "1.0");
    set(declaration, "encoding", "UTF-8");
    pugi::xml_node root = document.append_child("svg");
    set(root, "xmlns", "http://www.w3.org/2000/svg");
    set(root, "width", width + unit);
    set(root, "height", height + unit);
    set(root, "viewBox", "0 0 " + width + " " + height);
    root.append_child("title").text().set("TouchPhoto contours");

    // On every path, not on a group: a path that someone moves elsewhere in a drawing program keeps its look.
    const std::string style = std::string("fill:none;stroke:#000000;stroke-width:") + (in_mm ? "0.5" : "2") +
                              ";stroke-linecap:round;stroke-linejoin:round";
    std::vector<std::string> names;
    for (const Contour& contour : sheet.contours)
        names.push_back(svg::valid_utf8(contour.name));
    svg::make_unique(names);
    const std::vector<svg::ElementName> spelled = svg::spelled(names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string data = PathData().of(sheet.contours[i]);
        if (data.empty())
            continue;
        pugi::xml_node path = root.append_child("path");
        set(path, "id", spelled[i].id);
        if (!spelled[i].data_name.empty())
            set(path, "data-name", spelled[i].data_name);
        set(path, "style", style);
        set(path, "d", data);
    }
    StringWriter writer;
    document.save(writer, "  ", pugi::format_default, pugi::encoding_utf8);
    return std::move(writer.text);
}

} // namespace tp
