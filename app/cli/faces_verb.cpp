// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/face_json.hpp"
#include "app/cli/verbs.hpp"
#include "app/picture/overlay.hpp"
#include "app/picture/picture_file.hpp"
#include "app/scene/corrections.hpp"
#include "faces/face_extractor.hpp"
#include "faces/picture.hpp"

#include <QDir>
#include <QHash>

#include <cstdio>

namespace tp {

namespace {

/// File names for results, one a photograph, also where photographs in different folders share a name.
class OutputNames {
public:
    QString next(const QString& photo) {
        const QString base = QFileInfo(photo).fileName();
        const int before = seen_[base]++;
        return before == 0 ? base : QStringLiteral("%1-%2").arg(base).arg(before + 1);
    }

private:
    QHash<QString, int> seen_;
};

class FacesVerb {
public:
    explicit FacesVerb(const VerbLine& line) : line_(line) {}

    int run() {
        for (const char* name : {"svg", "overlay"})
            if (line_.has(name) && !QDir().mkpath(line_.text(name))) {
                say_problem("The folder cannot be made.", line_.text(name).toStdString());
                return exit_bad_input;
            }
        auto extractor = FaceExtractor::create({line_.text("detector").toStdString(),
                                                line_.text("model").toStdString(), !line_.has("no-edges")});
        if (!extractor) {
            say_problem(extractor.error());
            return exit_bad_input;
        }
        const QStringList photos = line_.arguments();
        int result = exit_done;
        for (qsizetype i = 0; i < photos.size(); ++i) {
            if (photos.size() > 1)
                say(QStringLiteral("%1 of %2: %3")
                        .arg(i + 1)
                        .arg(photos.size())
                        .arg(photos[i])
                        .toStdString());
            if (!one(*extractor, photos[i]))
                result = exit_bad_input;
        }
        return result;
    }

private:
    /// False where something has to be said about this photograph; the others of the batch go on.
    bool one(FaceExtractor& extractor, const QString& photo) {
        Extraction found = extractor.extract(photo.toStdString());
        if (!line_.has("uncorrected"))
            found = with_corrections(std::move(found), photo.toStdString());
        if (line_.has("json"))
            std::printf("%s\n", json_line(photo.toStdString(), found).constData());
        else
            std::printf("%s: %zu face%s\n", qPrintable(photo), found.faces.size(),
                        found.faces.size() == 1 ? "" : "s");
        std::fflush(stdout);
        bool good = found.problem.empty();
        if (!good)
            say_problem(found.problem, photo.toStdString());
        const QString name = names_.next(photo);
        if (line_.has("svg") && !found.faces.empty()) {
            const std::string sheet = (line_.text("svg") + "/" + name + ".contours.svg").toStdString();
            good = (is_correction(sheet, photo) ? told(sheet + " holds what a person mended and is kept.")
                                                : told(write_sheet(sheet, sheet_of(found)).error())) &&
                   good;
        }
        if (line_.has("overlay") && found.width > 0) {
            const auto picture = read_picture(photo.toStdString());
            if (picture) {
                const auto written =
                    write_image((line_.text("overlay") + "/" + name + ".overlay.png").toStdString(),
                                draw_overlay(turned(*picture, found.turned_degrees), found));
                good = told(written.error()) && good;
            }
        }
        return good;
    }

    /// Whether `sheet` is what a person mended of this photograph: it is not to be written over.
    static bool is_correction(const std::string& sheet, const QString& photo) {
        std::error_code ignored;
        return std::filesystem::equivalent(sheet, correction_file(photo.toStdString()), ignored);
    }

    static bool told(const std::string& problem) {
        if (!problem.empty())
            say_problem(problem);
        return problem.empty();
    }

    const VerbLine& line_;
    OutputNames names_;
};

} // namespace

int faces_verb(const QStringList& words) {
    VerbLine line("faces",
                  "Finds the faces of photographs and the contours of their eyes, lips and outline.\n"
                  "With --json a line of JSON a photograph; without, a line to read. A photograph about\n"
                  "which there is something to say is named on stderr; the others are done all the same.");
    line.option("json", "Writes a line of JSON for each photograph.")
        .option("svg", "Writes the contours as PHOTO.contours.svg, in pixels of the upright picture.",
                "folder")
        .option("overlay", "Writes the photograph with its contours as PHOTO.overlay.png.", "folder")
        .option("uncorrected", "Leaves out what a person mended in PHOTO.contours.svg beside a photograph.")
        .option("detector", "Finds the faces: embedded, yunet, or an ONNX file.", "name", "embedded")
        .option("model", "Finds the contours: embedded, mesh, or an ONNX file.", "name", "embedded")
        .option("no-edges",
                "Leaves lids and lips where the model puts them, not on their edges in the picture.")
        .argument("PHOTO", "JPEG, PNG or WebP.", "PHOTO...");
    if (const auto ended = line.parse(words, 1, 1'000'000))
        return *ended;
    return FacesVerb(line).run();
}

} // namespace tp
