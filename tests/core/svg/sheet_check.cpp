// SPDX-License-Identifier: Apache-2.0
#include "sheet_check.hpp"

#include "core/svg/contour_sheet.hpp"

#include <cmath>
#include <set>

namespace tp::test {

namespace {

bool operator==(const Line& p, const Line& q) { return p.a == q.a && p.b == q.b; }
bool operator==(const Quadratic& p, const Quadratic& q) {
    return p.a == q.a && p.control == q.control && p.b == q.b;
}
bool operator==(const Cubic& p, const Cubic& q) {
    return p.a == q.a && p.control_a == q.control_a && p.control_b == q.control_b && p.b == q.b;
}

bool same(const Piece& p, const Piece& q) {
    return p.index() == q.index() &&
           std::visit([&](const auto& piece) { return piece == std::get<std::decay_t<decltype(piece)>>(q); },
                      p);
}

std::string unsound(const ContourSheet& sheet) {
    if (!(sheet.width > 0.0) || !(sheet.height > 0.0) || !std::isfinite(sheet.width) ||
        !std::isfinite(sheet.height))
        return "the size is not above zero";
    std::set<std::string> names;
    for (const Contour& contour : sheet.contours) {
        if (contour.name.empty() || !names.insert(contour.name).second)
            return "the name \"" + contour.name + "\" is empty or not unique";
        if (contour.pieces.empty())
            return contour.name + " has no pieces";
        for (std::size_t i = 0; i < contour.pieces.size(); ++i) {
            if (!is_finite(contour.pieces[i]))
                return contour.name + " is not finite";
            if (i > 0 && end_of(contour.pieces[i - 1]) != start_of(contour.pieces[i]))
                return contour.name + " is torn";
        }
        if (contour.closed && end_of(contour.pieces.back()) != start_of(contour.pieces.front()))
            return contour.name + " is closed, but does not end where it starts";
    }
    return {};
}

std::string changed(const ContourSheet& before, const ContourSheet& after) {
    if (before.width != after.width || before.height != after.height)
        return "the size changed";
    if (before.contours.size() != after.contours.size())
        return "the number of contours changed";
    for (std::size_t i = 0; i < before.contours.size(); ++i) {
        const Contour& a = before.contours[i];
        const Contour& b = after.contours[i];
        if (a.name != b.name)
            return "the name \"" + a.name + "\" became \"" + b.name + "\"";
        if (a.closed != b.closed || a.pieces.size() != b.pieces.size())
            return a.name + " changed its form";
        for (std::size_t k = 0; k < a.pieces.size(); ++k)
            if (!same(a.pieces[k], b.pieces[k]))
                return a.name + " changed in piece " + std::to_string(k);
    }
    return {};
}

std::string complaint_about(std::string_view text, ContourSheet::Unit unit) {
    const Result<ContourSheet> sheet = sheet_from_svg(text, unit);
    if (!sheet)
        return sheet.error().size() > 20 && sheet.error().ends_with('.') ? ""
                                                                         : "no sentence: " + sheet.error();
    if (const std::string fault = unsound(*sheet); !fault.empty())
        return fault;
    const Result<ContourSheet> again = sheet_from_svg(sheet_to_svg(*sheet), unit);
    if (!again)
        return "what was written cannot be read: " + again.error();
    return changed(*sheet, *again);
}

} // namespace

std::string complaint_about(std::string_view text) {
    const std::string complaint = complaint_about(text, ContourSheet::Unit::millimetre);
    return complaint.empty() ? complaint_about(text, ContourSheet::Unit::pixel) : complaint;
}

} // namespace tp::test
