// SPDX-License-Identifier: Apache-2.0
#include "app/cli/batch_progress.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/face_json.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/results_file.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/photo/picture/overlay.hpp"
#include "app/photo/picture/picture_file.hpp"
#include "app/photo/scene/corrections.hpp"
#include "app/photo/scene/extra_features.hpp"
#include "core/files/file_name.hpp"
#include "core/files/file_words.hpp"
#include "faces/decode/picture.hpp"
#include "faces/extract/batch.hpp"
#include "faces/extract/face_extractor.hpp"

#include <QFileInfo>
#include <QHash>
#include <QThread>

#include <algorithm>
#include <cstdio>
#include <future>
#include <mutex>
#include <optional>
#include <unordered_set>
#include <vector>

namespace tp {

namespace {

constexpr int most_jobs = 256;

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
    FacesVerb(const VerbLine& line, int jobs, const ExtraFeatures& extras)
        : line_(line), jobs_(jobs), extras_(extras) {}

    int run() {
        for (const char* name : {"svg", "overlay"})
            if (line_.has(name))
                if (const std::string problem = line_.make_folder(name); !problem.empty())
                    return refused(problem);
        if (line_.has("resume")) {
            auto results = ResultsFile::open(line_.text("resume").toStdString());
            if (!results)
                return refused(results.error());
            results_.emplace(std::move(*results));
        }
        choose_photos();
        auto extractors = make_extractors();
        if (!extractors)
            return refused(extractors.error());
        return run(std::move(*extractors));
    }

private:
    struct Photo {
        QString file;
        QString output; ///< the name that its results in folders begin with
    };

    static int refused(const std::string& sentence, const std::string& about = {}) {
        say_problem(sentence, about);
        return exit_bad_input;
    }

    /// Those that have no line in the results yet.
    void choose_photos() {
        OutputNames names;
        std::unordered_set<std::string> chosen;
        for (const QString& file : line_.arguments()) {
            const QString output = names.next(file); // the same whether or not earlier ones are skipped
            const std::string name = file.toStdString();
            if (!results_ || (!results_->holds(name) && chosen.insert(name).second))
                photos_.push_back({file, output});
        }
        const std::size_t skipped = static_cast<std::size_t>(line_.arguments().size()) - photos_.size();
        if (skipped > 0)
            say("Skipped " + std::to_string(skipped) + (skipped == 1 ? " photograph" : " photographs") +
                " with a line in " + line_.text("resume").toStdString() + ".");
    }

    /// One a thread; at least one, so that a model that cannot be used is said whatever there is to do.
    Result<std::vector<FaceExtractor>> make_extractors() const {
        const auto wanted = static_cast<std::size_t>(jobs_ > 0 ? jobs_ : QThread::idealThreadCount());
        const ExtractorChoice choice{line_.text("detector").toStdString(), line_.text("model").toStdString(),
                                     line_.has("no-edges") ? RefinementStage::close_looks
                                                           : RefinementStage::onto_edges};
        std::vector<std::future<Result<FaceExtractor>>> making; // all at once: each takes its time
        do
            making.push_back(std::async([&choice] { return FaceExtractor::create(choice); }));
        while (making.size() < std::min(wanted, photos_.size()));
        std::vector<FaceExtractor> extractors;
        for (auto& one : making) {
            auto extractor = one.get();
            if (!extractor)
                return Error{extractor.error()};
            extractors.push_back(std::move(*extractor));
        }
        return extractors;
    }

    int run(std::vector<FaceExtractor> extractors) {
        LongWork::step("looking at " + (photos_.size() == 1
                                            ? photos_.front().file.toStdString()
                                            : std::to_string(photos_.size()) + " photographs"));
        BatchProgress progress(photos_.size());
        std::vector<std::filesystem::path> files;
        for (const Photo& photo : photos_)
            files.emplace_back(photo.file.toStdString());
        bool good = true;
        const auto take = [&](std::size_t index, const Extraction& found) {
            const std::lock_guard lock(taking_);
            if (photos_.size() > 1)
                say(progress.next(photos_[index].file.toStdString()));
            good = one(photos_[index], found) && good;
            taken_ = index + 1;
            return problem_.empty();
        };
        const LastWords how_many([this] {
            const std::lock_guard lock(taking_); // what is being written is written whole
            say_stopped();
        });
        const auto done = extract_batch(std::move(extractors), files, take, LongWork::stop_asked());
        if (!done)
            return refused(done.error());
        if (results_ && problem_.empty())
            problem_ = results_->sync();
        if (!problem_.empty())
            return refused(problem_);
        if (*done < photos_.size()) {
            say_stopped();
            return LongWork::stop_code();
        }
        return good ? exit_done : exit_bad_input;
    }

    void say_stopped() const {
        say("Stopped after " + std::to_string(taken_) + " of " + std::to_string(photos_.size()) + "." +
            (results_ ? " The same command continues from there." : ""));
    }

    /// False where something has to be said about this photograph; the others of the batch go on.
    bool one(const Photo& photo, Extraction found) {
        const std::string name = photo.file.toStdString();
        if (!line_.has("uncorrected"))
            found = with_corrections(std::move(found), name);
        const Extraction shown = with_extras(found, extras_);
        bool good = found.problem.empty();
        if (!good)
            say_problem(found.problem, name);
        if (line_.has("svg") && !found.faces.empty()) {
            const std::filesystem::path sheet =
                path_given(line_.text("svg") + "/" + photo.output + ".contours.svg");
            const ForeignFolder held = held_around(sheet);
            good = (is_correction(sheet, name)
                        ? told(name_in_utf8(sheet) + " holds what a person mended and is kept.")
                        : told(write(sheet, [&] { return write_sheet(sheet, sheet_of(shown)); }))) &&
                   good;
        }
        if (line_.has("overlay") && found.width > 0) {
            const auto picture = read_picture(name);
            if (picture) {
                const std::filesystem::path overlay =
                    path_given(line_.text("overlay") + "/" + photo.output + ".overlay.png");
                const ForeignFolder held = held_around(overlay);
                good =
                    told(write(overlay,
                               [&] {
                                   return write_image(
                                       overlay, draw_overlay(turned(*picture, found.turned_degrees), shown));
                               })) &&
                    good;
            } else {
                good = told(readable(name) + ": " + picture.error()) && good;
            }
        }
        // Last, so that a photograph with a line in the results has all its other results too.
        if (results_)
            problem_ = results_->append(name, json_line(name, found));
        else if (line_.has("json"))
            print("%s\n", json_line(name, found).constData());
        else
            print("%s: %zu face%s\n", readable(name).c_str(), found.faces.size(),
                  found.faces.size() == 1 ? "" : "s");
        std::fflush(stdout);
        return good;
    }

    /// Why not, else empty.
    template <typename Write>
    std::string write(const std::filesystem::path& file, Write write) const {
        const auto free = line_.output_file(QString::fromStdString(name_in_utf8(file)));
        return free ? write().error() : free.error();
    }

    /// Whether `sheet` is what a person mended of this photograph: it is not to be written over.
    static bool is_correction(const std::filesystem::path& sheet, const std::string& photo) {
        std::error_code ignored;
        return std::filesystem::equivalent(sheet, correction_file(photo), ignored);
    }

    static bool told(const std::string& problem) {
        if (!problem.empty())
            say_problem(problem);
        return problem.empty();
    }

    const VerbLine& line_;
    int jobs_;
    ExtraFeatures extras_; ///< in sheets and overlays; JSON has them always
    std::optional<ResultsFile> results_;
    std::vector<Photo> photos_;
    std::mutex taking_;     ///< held while a photograph's results are written
    std::size_t taken_ = 0; ///< photographs whose results are
    std::string problem_;   ///< why no more results can be written; empty: they can
};

} // namespace

int faces_verb(const QStringList& words) {
    VerbLine line("faces",
                  "Finds the faces of photographs and the contours of their eyes, lips and outline.\n"
                  "With --json a line of JSON a photograph; without, a line to read. A photograph about\n"
                  "which there is something to say is named on stderr; the others are done all the same.\n"
                  "Ctrl-C ends after the photographs in work; with --resume nothing that is done is lost.");
    line.option("json", "Writes a line of JSON for each photograph.")
        .option("resume", "Appends the lines of JSON to a file and skips what it holds already.", "file")
        .option("jobs", "Photographs worked on at a time; 0: one for each core.", "N", "1")
        .option("svg", "Writes the contours as PHOTO.contours.svg, in pixels of the upright picture.",
                "folder")
        .option("overlay", "Writes the photograph with its contours as PHOTO.overlay.png.", "folder")
        .option("with", "Adds features to those of --svg and --overlay: brows, nose, irises.", "LIST")
        .option("uncorrected", "Leaves out what a person mended in PHOTO.contours.svg beside a photograph.")
        .option("detector", "Finds the faces: embedded or yunet.", "name", "embedded")
        .option("model", "Finds the contours: embedded or mesh.", "name", "embedded")
        .option("no-edges",
                "Leaves lids and lips where the model puts them, not on their edges in the picture.")
        .with_force()
        .argument("PHOTO", "JPEG, PNG or WebP.", "PHOTO...");
    if (const auto ended = line.parse(words, 1, 1'000'000))
        return *ended;
    if (line.has("resume") && !line.has("json"))
        return wrong_usage("faces", "--resume FILE goes with --json: it holds lines of JSON.");
    const auto jobs = line.whole("jobs", 0, most_jobs);
    if (!jobs)
        return wrong_usage("faces", jobs.error());
    const auto extras = extra_features_named(line.text("with").toStdString());
    if (!extras)
        return wrong_usage("faces", extras.error());
    return FacesVerb(line, *jobs, *extras).run();
}

} // namespace tp
