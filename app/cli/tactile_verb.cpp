// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/read_record.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/json_number.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/photo/people/face_names.hpp"
#include "app/photo/scene/corrections.hpp"
#include "app/photo/tactile/tactile_file.hpp"
#include "faces/extract/face_extractor.hpp"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tp {

namespace {

void print_sheet(const TactileSheet& sheet) {
    QJsonArray lines, labels, notes;
    for (const TactileLine& line : sheet.lines)
        lines << QJsonObject{{"name", QString::fromStdString(line.name)}, {"width_mm", line.width_mm}};
    for (const TactileLabel& label : sheet.labels)
        labels << QJsonObject{{"name", QString::fromStdString(label.name)},
                              {"braille", QString::fromStdString(as_unicode(label.lines))},
                              {"x_mm", in_thousandths(label.corner.x)},
                              {"y_mm", in_thousandths(label.corner.y)}};
    for (const std::string& note : sheet.notes)
        notes << QString::fromStdString(note);
    const double gap = least_gap(sheet.lines);
    const QJsonObject object{
        {"width_mm", sheet.width_mm},
        {"height_mm", sheet.height_mm},
        {"mm_per_px", sheet.mm_per_px},
        {"least_gap_mm", std::isfinite(gap) ? QJsonValue(in_thousandths(gap)) : QJsonValue()},
        {"lines", lines},
        {"labels", labels},
        {"notes", notes}};
    print_json(object);
}

} // namespace

int tactile_verb(const QStringList& words) {
    VerbLine line(
        "tactile",
        "Writes the faces of a photograph as raised lines for swell paper or an embosser, with their\n"
        "names in braille. Print it at 100 %, unscaled. Names come from the photograph's metadata\n"
        "unless they are given.");
    line.option("paper", "a4, letter, a3 or braille (11 × 11.5 inches).", "name", "a4")
        .option("landscape", "The longer side across (of braille paper: the shorter one).")
        .option("face", "Only this face (1 is the largest), fitted to the paper.", "number")
        .option("name", "Who a face is; once for each face, the largest first.", "NAME")
        .option("language", "Language of the braille: en, de, ko.", "tag", "en")
        .option("title", "A line of print at the foot of the sheet.", "TEXT")
        .option("json", "One JSON object about the sheet on stdout.")
        .with_force()
        .argument("PHOTO", "JPEG, PNG or WebP.")
        .argument("OUT", "OUT.pdf or OUT.svg.");
    if (const auto ended = line.parse(words, 2, 2))
        return *ended;
    TactileOptions options;
    const auto paper = paper_named(line.text("paper").toStdString());
    if (!paper)
        return wrong_usage("tactile", "--paper is a4, letter, a3 or braille.");
    options.paper = line.has("landscape") ? turned(*paper) : *paper;
    if (line.has("face")) {
        const int number = line.text("face").toInt();
        if (number < 1)
            return wrong_usage("tactile", "--face needs a number from 1 on.");
        options.face = static_cast<std::size_t>(number - 1);
    }
    options.language = line.text("language").toStdString();
    if (const Result<BrailleText> tried = braille_of("", options.language); !tried)
        return wrong_usage("tactile", tried.error());
    options.title = line.text("title").toStdString();
    const QString name = line.arguments().last();
    if (!name.endsWith(".pdf") && !name.endsWith(".svg"))
        return wrong_usage("tactile", "The sheet's name ends in .pdf or .svg.");
    const auto out = line.output_file(name);
    if (!out)
        return refused(out.error());

    const std::string photo = line.arguments().first().toStdString();
    LongWork::step("looking at " + line.arguments().first().toStdString());
    auto extractor = FaceExtractor::create();
    if (!extractor)
        return refused(extractor.error());
    const Extraction found = with_corrections(extractor->extract(photo), photo);
    for (const QString& named : line.texts("name"))
        options.names.push_back(named.toStdString());
    if (options.names.empty())
        if (const auto record = read_record(photo))
            options.names = names_of_faces(found, *record);
    const auto sheet = make_tactile_sheet(found, options);
    if (!sheet) {
        say_problem(sheet.error(), photo);
        return exit_bad_input;
    }
    const ForeignFolder held = held_around(*out);
    const auto written = write_tactile(*out, *sheet);
    if (!written)
        return refused(written.error());
    for (const std::string& note : sheet->notes)
        say(note);
    if (line.has("json"))
        print_sheet(*sheet);
    if (!found.problem.empty())
        say_problem(found.problem, photo);
    return found.problem.empty() ? exit_done : exit_bad_input;
}

} // namespace tp
