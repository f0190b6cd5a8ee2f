// SPDX-License-Identifier: Apache-2.0
#include "app/photo/tactile/tactile_sheet.hpp"

#include "app/photo/scene/feature_words.hpp"
#include "core/files/file_words.hpp"
#include "core/geometry/flatten.hpp"
#include "core/geometry/transform.hpp"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace tp {

namespace {

constexpr double clear_mm = SpacedLines::gap_mm; ///< between braille and anything else
constexpr std::size_t most_label_lines = 3;
constexpr double search_step_mm = 1.0;

/// What a finger uses most comes first: it keeps its place where lines are close (Lim, Yoo, Choi 2019).
constexpr std::array by_importance{feature::outline,    feature::left_eye,  feature::right_eye, feature::outer_lip,
                                   feature::inner_lip,  feature::left_brow, feature::right_brow, feature::nose,
                                   feature::left_iris, feature::right_iris};

std::size_t importance(const Contour& contour) {
    return static_cast<std::size_t>(std::find(by_importance.begin(), by_importance.end(), contour.name) -
                                    by_importance.begin());
}

Rect grown(const Rect& box, double by) { return {box.min - Vec2(by), box.max + Vec2(by)}; }

bool meet(const Rect& one, const Rect& other) {
    return one.min.x < other.max.x && other.min.x < one.max.x && one.min.y < other.max.y && other.min.y < one.max.y;
}

Rect bounds_of_face(const Face& face) {
    std::vector<Vec2> points;
    for (const Contour& contour : face.contours)
        for (const Vec2 p : flatten(contour, {0.02, 3.0}).points)
            points.push_back(p);
    return bounds_of(points);
}

Rect bounds_of_all(const std::vector<Face>& faces) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Rect all{Vec2(infinity), Vec2(-infinity)};
    for (const Face& face : faces)
        if (!face.contours.empty()) {
            const Rect box = bounds_of_face(face);
            all = {glm::min(all.min, box.min), glm::max(all.max, box.max)};
        }
    return all;
}

/// Pixels → mm on the paper, both y down: as large as it goes into `room`, in its middle.
Result<Affine> fitted(const Rect& subject, const Rect& room) {
    if (!(subject.width() > 0.0) || !(subject.height() > 0.0) || !is_finite(subject.min) || !is_finite(subject.max))
        return Error{"There is no line to draw on these faces."};
    const double scale = std::min(room.width() / subject.width(), room.height() / subject.height());
    return Affine{glm::dmat2(scale), room.centre() - scale * subject.centre()};
}

/// The title, cut where it would not fit. Letters are taken to be 0.62 of their size wide.
std::string fitted_title(const std::string& title, double width_mm) {
    const std::string clean = readable(title);
    const auto most = static_cast<std::size_t>(width_mm / (0.62 * TactileSheet::title_mm));
    std::size_t count = 0;
    for (std::size_t i = 0; i < clean.size(); ++i)
        if ((static_cast<unsigned char>(clean[i]) & 0xc0) != 0x80 && ++count > most)
            return clean.substr(0, i) + "…";
    return clean;
}

struct TactileNotes {
    Q_DECLARE_TR_FUNCTIONS(TactileNotes)
};

/// A contour in the person's language, with its face where there are several.
QString feature_in(const std::string& name, int face) {
    const QString word = QCoreApplication::translate("tp::FeatureLabels", spoken_feature(name).c_str());
    return face < 0 ? word
                    : QCoreApplication::translate("tp::FeatureLabels", "%1 of face %2", "left eye of face 2")
                          .arg(word)
                          .arg(face + 1);
}

QString quoted_name(const std::string& name) { return QString::fromStdString(quoted_readable(name)); }

class SheetMaker {
public:
    SheetMaker(const Extraction& extraction, const TactileOptions& options) : options_(options) {
        for (std::size_t i = 0; i < extraction.faces.size(); ++i)
            if (!options.face || *options.face == i) {
                faces_.push_back(extraction.faces[i]);
                names_.push_back(i < options.names.size() ? options.names[i] : std::string());
            }
        sheet_.width_mm = options.paper.width_mm;
        sheet_.height_mm = options.paper.height_mm;
        constexpr double edge = TactileSheet::margin_mm;
        inside_ = {Vec2(edge), Vec2(sheet_.width_mm - edge, sheet_.height_mm - edge)};
    }

    Result<TactileSheet> make() {
        sheet_.title = fitted_title(options_.title, inside_.width() - 4.0);
        if (std::string problem = write_labels(); !problem.empty())
            return Error{problem};
        const Result<Affine> map = fitted(bounds_of_all(faces_), drawing_room());
        if (!map)
            return Error{map.error()};
        sheet_.mm_per_px = map->linear[0][0];
        lay_mark();
        lay_faces(*map);
        place_labels(*map);
        sheet_.lines = lines_.lines();
        return std::move(sheet_);
    }

private:
    bool alone() const { return faces_.size() == 1; }
    void note(const QString& sentence) { sheet_.notes.push_back(sentence.toStdString()); }

    /// From names to lines of braille, not placed yet.
    std::string write_labels() {
        const auto most = static_cast<std::size_t>((inside_.width() - TactileSheet::mark_mm - clear_mm) /
                                                   braille::cell_pitch_mm) - 1;
        for (const std::string& name : names_) {
            const Result<BrailleText> text = braille_of(name, options_.language);
            if (!text)
                return text.error();
            TactileLabel label{readable(name), wrapped(text->cells, alone() ? most : std::min<std::size_t>(most, 14)), {}};
            if (text->left_out > 0)
                note(TactileNotes::tr("%n character(s) of the name %1 have no braille and are left out.", nullptr,
                                      text->left_out)
                         .arg(quoted_name(name)));
            if (label.lines.size() > most_label_lines) {
                label.lines.resize(most_label_lines);
                note(TactileNotes::tr("The name %1 is cut off after %n line(s) of braille.", nullptr,
                                      static_cast<int>(most_label_lines))
                         .arg(quoted_name(name)));
            }
            written_.push_back(std::move(label));
        }
        return {};
    }

    /// Inside of the margins, without the strips for braille, title and mark.
    Rect drawing_room() const {
        double label_height = 0.0;
        for (const TactileLabel& label : written_)
            label_height = std::max(label_height, size_of(label.lines).y);
        Rect room = grown(inside_, -0.5 * TactileSheet::outline_width_mm - 0.1);
        const double strip = label_height > 0.0 ? label_height + clear_mm + 1.0 : 0.0;
        if (!sheet_.title.empty())
            room.max.y -= TactileSheet::title_mm + 2.0 + clear_mm;
        if (alone())
            room.min.y += std::max(strip, TactileSheet::mark_mm + clear_mm);
        else {
            room.min.y += TactileSheet::mark_mm + clear_mm;
            room.max.y -= strip;
        }
        return room;
    }

    void lay_mark() {
        const double half = 0.5 * TactileSheet::outline_width_mm;
        const Vec2 corner(inside_.max.x - half, inside_.min.y + half);
        lines_.lay(contour_through("orientation mark",
                                   {corner - Vec2(TactileSheet::mark_mm, 0.0), corner + Vec2(0.0, TactileSheet::mark_mm)},
                                   false),
                   TactileSheet::outline_width_mm);
    }

    void lay_faces(const Affine& map) {
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            std::vector<Contour> contours = faces_[i].contours;
            std::stable_sort(contours.begin(), contours.end(), [](const Contour& a, const Contour& b) {
                return importance(a) < importance(b);
            });
            for (const Contour& contour : contours) {
                Contour on_paper = mapped(contour, map);
                if (!alone())
                    on_paper.name = "face " + std::to_string(i + 1) + " " + contour.name;
                const double width = contour.name == feature::outline ? TactileSheet::outline_width_mm
                                                                      : TactileSheet::feature_width_mm;
                tell(lines_.lay(on_paper, width), feature_in(contour.name, alone() ? -1 : static_cast<int>(i)));
            }
        }
    }

    void tell(LineFate fate, const QString& feature) {
        if (fate == LineFate::one_line)
            note(TactileNotes::tr("The %1 is drawn as one line, because its two sides would be too close to be told apart.")
                     .arg(feature));
        else if (fate == LineFate::partly)
            note(TactileNotes::tr("The %1 is drawn in part, because the rest would be less than 3 mm from another line.")
                     .arg(feature));
        else if (fate == LineFate::left_out)
            note(TactileNotes::tr("The %1 is left out, because it would be too small or less than 3 mm from another line.")
                     .arg(feature));
    }

    void place_labels(const Affine& map) {
        std::vector<Rect> faces;
        for (const Face& face : faces_) {
            const Rect box = bounds_of_face(face);
            faces.push_back({map(box.min), map(box.max)});
        }
        std::vector<Rect> taken;
        if (!sheet_.title.empty())
            taken.push_back({{inside_.min.x, inside_.max.y - TactileSheet::title_mm - 2.0}, inside_.max});
        for (std::size_t i = 0; i < written_.size(); ++i) {
            TactileLabel& label = written_[i];
            if (label.lines.empty())
                continue;
            const Vec2 size = size_of(label.lines);
            const Vec2 wish = alone() ? inside_.min + 0.5 * size
                                      : Vec2(faces[i].centre().x, faces[i].max.y + clear_mm + 0.5 * size.y);
            const auto place = free_place(size, wish, taken, faces);
            if (!place) {
                note(TactileNotes::tr("The name %1 is left out, because there is no room for its braille.")
                         .arg(quoted_name(label.name)));
                continue;
            }
            label.corner = *place;
            taken.push_back(grown({*place, *place + size}, clear_mm));
            sheet_.labels.push_back(std::move(label));
        }
    }

    /// Where a block of that size touches nothing and lies within no face, nearest to where it is wished.
    std::optional<Vec2> free_place(Vec2 size, Vec2 wish, const std::vector<Rect>& taken,
                                   const std::vector<Rect>& faces) const {
        std::vector<std::pair<double, Vec2>> corners;
        for (double y = inside_.min.y; y + size.y <= inside_.max.y; y += search_step_mm)
            for (double x = inside_.min.x; x + size.x <= inside_.max.x; x += search_step_mm)
                corners.emplace_back(length(Vec2(x, y) + 0.5 * size - wish), Vec2(x, y));
        std::stable_sort(corners.begin(), corners.end(),
                         [](const auto& one, const auto& other) { return one.first < other.first; });
        for (const auto& [away, corner] : corners) {
            const Rect block{corner, corner + size};
            const auto in_the_way = [&](const Rect& other) { return meet(block, other); };
            if (std::none_of(taken.begin(), taken.end(), in_the_way) &&
                std::none_of(faces.begin(), faces.end(), in_the_way) && lines_.distance_to_lines(block) >= clear_mm)
                return corner;
        }
        return std::nullopt;
    }

    const TactileOptions& options_;
    std::vector<Face> faces_;
    std::vector<std::string> names_;
    std::vector<TactileLabel> written_;
    TactileSheet sheet_;
    SpacedLines lines_;
    Rect inside_;
};

} // namespace

Result<TactileSheet> make_tactile_sheet(const Extraction& extraction, const TactileOptions& options) {
    if (extraction.faces.empty())
        return Error{extraction.problem.empty() ? "No face was found in this picture." : extraction.problem};
    if (options.face && *options.face >= extraction.faces.size())
        return Error{"There is no face " + std::to_string(*options.face + 1) + " in this picture; it has " +
                     std::to_string(extraction.faces.size()) + "."};
    return SheetMaker(extraction, options).make();
}

} // namespace tp
