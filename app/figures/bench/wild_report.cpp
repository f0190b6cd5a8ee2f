// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/wild_bench.hpp"
#include "app/figures/report/csv_table.hpp"
#include "app/figures/report/plot.hpp"

#include <algorithm>

namespace tp {

namespace {

constexpr double least_percent = 0.1, most_percent = 10.0; ///< of the plot
constexpr double unseen_percent = 0.1; ///< of the contours: less than a pixel of its height

std::string cell_of(const std::optional<double>& value) { return value ? cell(*value) : std::string(); }

/// What is said of one contour of a face, with ; between.
std::string reasons_of(const WildPhoto& photo, const char* contour) {
    std::string words;
    if (photo.face)
        for (std::size_t i = 0; i < std::min(photo.face->contours.size(), photo.face->quality.size()); ++i)
            if (photo.face->contours[i].name == contour)
                for (const std::string& reason : photo.face->quality[i].reasons)
                    words += (words.empty() ? "" : "; ") + reason;
    return words;
}

std::string labels_of(const WildPhoto& photo, const WildLabels* labels) {
    std::string words;
    if (const std::set<std::string>* all = labels ? labels->of(photo.file) : nullptr)
        for (const std::string& word : *all)
            words += (words.empty() ? "" : " ") + word;
    return words;
}

/// Shares in percent over percent, from `least_percent` to `most_percent`, without steps that nobody would see.
std::vector<Vec2> shares(const std::vector<double>& sorted) {
    const auto shown = static_cast<std::size_t>(std::upper_bound(sorted.begin(), sorted.end(), most_percent) -
                                                sorted.begin());
    if (shown == 0)
        return {};
    const double each = 100.0 / static_cast<double>(sorted.size());
    std::vector<Vec2> line{{std::max(sorted.front(), least_percent), 0.0}};
    for (std::size_t i = 0; i < shown; ++i)
        if (const double share = each * static_cast<double>(i + 1);
            share - line.back().y >= unseen_percent || i + 1 == shown)
            line.push_back({std::max(sorted[i], least_percent), share});
    line.push_back({most_percent, line.back().y});
    return line;
}

} // namespace

Result<std::filesystem::path> write_wild_table(const std::filesystem::path& folder,
                                               const std::vector<WildPhoto>& photos,
                                               const WildLabels* labels) {
    std::vector<std::string> columns{"photo", "problem", "faces", "mesh_faces", "common_faces", "face_px"};
    for (const char* contour : wild_contours)
        columns.push_back(std::string(contour) + "_off_percent");
    columns.emplace_back("said");
    for (const char* contour : wild_contours)
        columns.push_back(std::string(contour) + "_reasons");
    for (const char* column : {"decode_ms", "detect_ms", "landmarks_ms", "edges_ms", "contours_ms", "labels"})
        columns.emplace_back(column);
    CsvTable table(columns);
    for (const WildPhoto& photo : photos) {
        const Rect box = photo.face ? photo.face->box : Rect{};
        std::vector<std::string> cells{photo.name,
                                       photo.problem,
                                       std::to_string(photo.faces),
                                       std::to_string(photo.mesh_faces),
                                       std::to_string(photo.common_faces),
                                       photo.face ? cell(std::max(box.width(), box.height()), 4) : ""};
        for (const std::optional<double>& off : photo.off_percent)
            cells.push_back(cell_of(off));
        cells.push_back(photo.said.empty() ? "" : photo.said.front());
        for (const char* contour : wild_contours)
            cells.push_back(reasons_of(photo, contour));
        const ExtractionTimes& took = photo.milliseconds;
        for (const double ms : {took.decode, took.detect, took.landmarks, took.edges, took.contours})
            cells.push_back(cell(ms));
        cells.push_back(labels_of(photo, labels));
        table.add(std::move(cells));
    }
    return table.write(folder / "wild.csv");
}

Result<std::filesystem::path> write_wild_summary(const std::filesystem::path& folder,
                                                 const WildSummary& summary) {
    CsvTable table({"figure", "of", "value", "unit"});
    const auto number = [&](const std::string& figure, const std::string& of, std::size_t value,
                            const char* unit) {
        table.add({figure, of, std::to_string(value), unit});
    };
    const auto count = [&](const std::string& figure, const std::string& of, int value, const char* unit) {
        number(figure, of, static_cast<std::size_t>(value), unit);
    };
    count("photographs", "", summary.photos, "photographs");
    number("not read", "", summary.unread.size(), "photographs");
    number("no face found", "ours", summary.not_found.size(), "photographs");
    number("no face found", "mesh", summary.not_found_by_mesh.size(), "photographs");
    number("largest face not found by the mesh", "ours", summary.apart.size(), "photographs");
    count("faces", "ours", summary.faces, "faces");
    count("faces", "mesh", summary.mesh_faces, "faces");
    count("faces", "both", summary.common_faces, "faces");
    for (const WildAgreement& one : summary.agreement) {
        count("contours compared", one.name, one.contours, "contours");
        table.add({"mean difference from the mesh", one.name, cell(one.mean_percent), "percent"});
        table.add(
            {"95th percentile of the difference from the mesh", one.name, cell(one.p95_percent), "percent"});
        count("more than " + cell(much_percent) + " percent from the mesh", one.name, one.much_off,
              "contours");
    }
    for (const auto& [reason, contours] : summary.reasons)
        for (std::size_t i = 0; i < contours.size(); ++i)
            count("said: " + reason, wild_contours[i], contours[i], "largest faces");
    for (const auto& [sentence, said] : summary.sentences) {
        count("said: " + sentence, "largest face", said.largest, "faces");
        count("said: " + sentence, "any face", said.all, "faces");
    }
    table.add({"decoding, median", "", cell(summary.decode_ms), "ms"});
    table.add({"decoding, 95th percentile", "", cell(summary.decode_p95_ms), "ms"});
    table.add({"detection to contours, median", "", cell(summary.rest_ms), "ms"});
    table.add({"detection to contours, 95th percentile", "", cell(summary.rest_p95_ms), "ms"});
    if (const auto& covers = summary.covers) {
        const auto pair = [&](const char* figure, const char* of, const WildCovers::Count& one,
                              const char* unit) {
            count(figure, of, one.all, unit);
            count(std::string(figure) + ", said to be", of, one.said, unit);
        };
        count("labelled, with a face found", "", covers->photos, "photographs");
        pair("labelled as not covered", "eyes", covers->clear_eyes, "eyes");
        pair("labelled as not covered", "mouth", covers->clear_mouths, "mouths");
        count("said falsely to be covered", "eyes or mouth", covers->photos_falsely, "photographs");
        pair("labelled as covered", "eyes", covers->covered_eyes, "eyes");
        pair("labelled as covered", "mouth", covers->covered_mouths, "mouths");
        count("labelled as without a face", "", covers->without_face.all, "photographs");
        count("labelled as without a face, one found", "", covers->without_face.said, "photographs");
        count("not labelled", "", covers->unlabelled, "photographs");
    }
    return table.write(folder / "wild_summary.csv");
}

Result<std::filesystem::path> plot_wild(const std::filesystem::path& folder, const WildSummary& summary) {
    const QColor colours[] = {QColor(20, 120, 200), QColor(214, 60, 40), QColor(230, 150, 20),
                              QColor(30, 150, 70)};
    PlotPanel panel;
    panel.title = QStringLiteral("%1 photographs: our contours beside the face mesh's").arg(summary.read());
    panel.x = {QStringLiteral("mean distance between both contours, % of the eyes' distance"), least_percent,
               most_percent, true};
    panel.y = {QStringLiteral("contours within this distance, %"), 0.0, 100.0, false};
    for (std::size_t f = 0; f < summary.agreement.size(); ++f) {
        const WildAgreement& one = summary.agreement[f];
        panel.lines.push_back({QStringLiteral("%1: %2 of %3 over 5 %")
                                   .arg(QLatin1String(one.name))
                                   .arg(one.much_off)
                                   .arg(one.contours),
                               colours[f], shares(one.off_percent), false});
    }
    panel.lines.push_back({QStringLiteral("5 %: far off"),
                           QColor(30, 30, 36),
                           {{much_percent, 0.0}, {much_percent, 100.0}},
                           true});
    return write_plot(folder / "wild", {panel});
}

} // namespace tp
