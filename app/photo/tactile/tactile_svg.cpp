// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/tactile_file.hpp"
#include "app/photo/tactile/tactile_ink.hpp"

#include <pugixml.hpp>

#include <array>
#include <charconv>
#include <utility>

namespace tp {

namespace {

/// To a tenth of a micrometre, without zeros at its end.
std::string tactile_number(double value) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 4).ptr;
    std::string number(text.data(), end);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.ends_with('.'))
        number.pop_back();
    return number == "-0" ? "0" : number;
}

std::string place_text(Vec2 p) { return tactile_number(p.x) + " " + tactile_number(p.y); }

std::string path_text(const Contour& path) {
    std::string text;
    for (const Piece& piece : path.pieces) {
        if (text.empty())
            text = "M " + place_text(start_of(piece));
        if (const auto* q = std::get_if<Quadratic>(&piece))
            text += " Q " + place_text(q->control) + " " + place_text(q->b);
        else if (const auto* c = std::get_if<Cubic>(&piece))
            text += " C " + place_text(c->control_a) + " " + place_text(c->control_b) + " " + place_text(c->b);
        else
            text += " L " + place_text(end_of(piece));
    }
    return path.closed ? text + " Z" : text;
}

void set_value(pugi::xml_node node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(value.c_str());
}

pugi::xml_node group(pugi::xml_node parent, const char* id, const char* style) {
    pugi::xml_node node = parent.append_child("g");
    set_value(node, "id", id);
    set_value(node, "style", style);
    return node;
}

struct TextSink final : pugi::xml_writer {
    std::string text;
    void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

} // namespace

std::string tactile_svg(const TactileSheet& sheet) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    set_value(declaration, "version", "1.0");
    set_value(declaration, "encoding", "UTF-8");
    pugi::xml_node root = document.append_child("svg");
    const std::string width = tactile_number(sheet.width_mm), height = tactile_number(sheet.height_mm);
    set_value(root, "xmlns", "http://www.w3.org/2000/svg");
    set_value(root, "width", width + "mm");
    set_value(root, "height", height + "mm");
    set_value(root, "viewBox", "0 0 " + width + " " + height);
    root.append_child("title").text().set(sheet.title.empty() ? "Tactile sheet" : sheet.title.c_str());

    pugi::xml_node lines =
        group(root, "lines", "fill:none;stroke:#000000;stroke-linecap:round;stroke-linejoin:round");
    for (const TactileLine& line : sheet.lines) {
        pugi::xml_node path = lines.append_child("path");
        set_value(path, "data-name", line.name);
        set_value(path, "style", "stroke-width:" + tactile_number(line.width_mm));
        set_value(path, "d", path_text(line.path));
    }
    pugi::xml_node dots = group(root, "braille", "fill:#000000;stroke:none");
    for (const TactileLabel& label : sheet.labels) {
        pugi::xml_node block = dots.append_child("g");
        set_value(block, "data-name", label.name);
        for (const Vec2 dot : dots_of(label.lines, label.corner)) {
            pugi::xml_node circle = block.append_child("circle");
            set_value(circle, "cx", tactile_number(dot.x));
            set_value(circle, "cy", tactile_number(dot.y));
            set_value(circle, "r", tactile_number(0.5 * braille::dot_diameter_mm));
        }
    }
    if (!sheet.title.empty()) {
        pugi::xml_node print = group(root, "print", "stroke:none");
        pugi::xml_node text = print.append_child("text");
        set_value(text, "x", tactile_number(sheet.title_place().x));
        set_value(text, "y", tactile_number(sheet.title_place().y));
        set_value(text, "style",
                  "font-family:'DejaVu Sans',sans-serif;font-size:" + tactile_number(TactileSheet::title_mm) +
                      "px;fill:" + title_ink);
        text.text().set(sheet.title.c_str());
    }
    TextSink sink;
    document.save(sink, "  ", pugi::format_default, pugi::encoding_utf8);
    return std::move(sink.text);
}

} // namespace tp
