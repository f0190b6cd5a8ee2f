// SPDX-License-Identifier: Apache-2.0
#include "app/cli/expression_faces.hpp"

#include "app/photo/scene/corrections.hpp"
#include "core/svg/contour_sheet.hpp"

#include <map>

namespace tp {

namespace {

/// The contours of each face of a sheet. Where it shows several their names begin with the face's:
/// "face 2 left_eye" as `faces --svg` writes it, "face_2.left_eye" as sample portraits have it.
std::vector<std::vector<Contour>> faces_of(const ContourSheet& sheet) {
    std::map<std::string, std::vector<Contour>> faces;
    for (Contour contour : sheet.contours) {
        const std::size_t end = contour.name.find_last_of(" .");
        const std::string face = end == std::string::npos ? "" : contour.name.substr(0, end);
        contour.name.erase(0, end == std::string::npos ? 0 : end + 1);
        faces[face].push_back(std::move(contour));
    }
    std::vector<std::vector<Contour>> found;
    for (auto& [face, contours] : faces)
        found.push_back(std::move(contours));
    return found;
}

} // namespace

Result<MeasuredFile> ExpressionMeter::measure(const std::filesystem::path& file) {
    MeasuredFile measured;
    if (file.extension() == ".svg" || file.extension() == ".SVG") {
        const auto sheet = read_sheet(file, ContourSheet::Unit::pixel);
        if (!sheet)
            measured.problem = sheet.error();
        else
            for (const std::vector<Contour>& face : faces_of(*sheet))
                measured.faces.push_back(expression_cues(face));
        return measured;
    }
    if (!extractor_) {
        auto made = FaceExtractor::create();
        if (!made)
            return Error{made.error()};
        extractor_.emplace(std::move(made).value());
    }
    Extraction found = extractor_->extract(file);
    if (use_corrections_)
        found = with_corrections(std::move(found), file);
    measured.problem = found.problem;
    for (const Face& face : found.faces)
        measured.faces.push_back(expression_cues(face.contours));
    return measured;
}

} // namespace tp
