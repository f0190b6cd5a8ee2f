// SPDX-License-Identifier: Apache-2.0
#include "app/cli/bench_wild.hpp"

#include "app/cli/batch_progress.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/names_file.hpp"
#include "app/cli/photographs_in.hpp"
#include "app/cli/terminal.hpp"
#include "app/figures/bench/wild_bench.hpp"
#include "core/files/whole_file.hpp"

#include <QFileInfo>
#include <QString>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tp {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_label_bytes = 64 << 20;
constexpr std::size_t names_shown = 20; ///< of a list on the screen; all are in wild.csv
constexpr std::size_t tiles = 20;

/// Leaves only those whose file is named; the sentence that says why not, else empty.
std::string keep_named(Photographs& photographs, const QString& list) {
    const auto names = names_in(list, "photographs");
    if (!names)
        return names.error();
    std::erase_if(photographs.files,
                  [&](const fs::path& file) { return !names->contains(file.filename().string()); });
    if (photographs.files.empty())
        return "None of the photographs in " + list.toStdString() + " is in " + photographs.folder.string() +
               ".";
    std::set<std::string> kept;
    for (const fs::path& file : photographs.files)
        kept.insert(file.filename().string());
    if (const std::size_t missing = names->size() - kept.size(); missing > 0)
        say(std::to_string(missing) + " of the " + std::to_string(names->size()) + " names in " +
            list.toStdString() + " are not in " + photographs.folder.string() + ".");
    return {};
}

Result<WildLabels> labels_in(const fs::path& file) {
    const auto text = read_whole(file, most_label_bytes);
    return text ? WildLabels::from_text(*text) : Error{text.error()};
}

void print_names(const char* what, const std::vector<std::string>& names) {
    print("%s: %zu%s\n", what, names.size(), names.empty() ? "" : ":");
    for (std::size_t i = 0; i < std::min(names.size(), names_shown); ++i)
        print("  %s\n", names[i].c_str());
    if (names.size() > names_shown)
        print("  and %zu more, in wild.csv\n", names.size() - names_shown);
}

void print_agreement(const WildSummary& all) {
    print("\n%-18s %9s %7s %6s %9s\n", "from the mesh", "contours", "mean", "95 %", "over 5 %");
    for (const WildAgreement& one : all.agreement)
        print("%-18s %9d %7.2f %6.2f %9d\n", one.name, one.contours, one.mean_percent, one.p95_percent,
              one.much_off);
    std::puts(
        "percent of the distance between the eyes' outer corners; each eye is one contour. The mesh is\n"
        "no truth: where both differ, worst.png shows which is right.");
}

void print_said(const WildSummary& all) {
    print("\n%-18s %9s %8s %9s %9s %7s\n", "said of contours", "right eye", "left eye", "outer lip",
          "inner lip", "outline");
    for (const auto& [reason, of] : all.reasons)
        print("%-18s %9d %8d %9d %9d %7d\n", reason.c_str(), of[0], of[1], of[2], of[3], of[4]);
    print("the largest face of each photograph, %d in all\n", all.largest_faces);
    print("\n%7s %5s  %s\n", "largest", "all", "said of faces (N: a number)");
    for (const auto& [sentence, said] : all.sentences)
        print("%7d %5d  %s\n", said.largest, said.all, sentence.c_str());
    if (all.sentences.empty())
        print("%7d %5d  nothing\n", 0, 0);
}

void print_covers(const WildCovers& covers) {
    print("\n%-18s %5s %28s\n", "beside the labels", "all", "said that it may be covered");
    const auto row = [](const char* what, const WildCovers::Count& one) {
        print("%-18s %5d %28d\n", what, one.all, one.said);
    };
    row("eyes not covered", covers.clear_eyes);
    row("mouths not covered", covers.clear_mouths);
    row("eyes covered", covers.covered_eyes);
    row("mouths covered", covers.covered_mouths);
    print("the largest face of each labelled photograph, %d in all; said falsely in %d of them (%.1f %%)\n",
          covers.photos, covers.photos_falsely,
          covers.photos > 0 ? 100.0 * covers.photos_falsely / covers.photos : 0.0);
    print_names("said falsely", covers.falsely);
    print("labelled as without a face of 40 px, not counted above: %d; a face found in %d\n",
          covers.without_face.all, covers.without_face.said);
    if (covers.unlabelled > 0)
        print("photographs without a label: %d\n", covers.unlabelled);
}

void show(const WildSummary& all) {
    print("photographs: %d\n", all.photos);
    print_names("could not be read", all.unread);
    print_names("no face found by ours", all.not_found);
    print_names("no face found by the mesh", all.not_found_by_mesh);
    print_names("our largest face not found by the mesh", all.apart);
    print("faces: %d by ours, %d by the mesh, %d by both\n", all.faces, all.mesh_faces, all.common_faces);
    print_agreement(all);
    print_said(all);
    print("\n%-22s %8s %7s\n", "ms a photograph", "median", "95 %");
    print("%-22s %8.1f %7.1f\n", "decoding", all.decode_ms, all.decode_p95_ms);
    print("%-22s %8.1f %7.1f\n", "detection to contours", all.rest_ms, all.rest_p95_ms);
    if (all.covers)
        print_covers(*all.covers);
}

/// What is measured until now: one thread adds, another may want the figures of it at any time.
class WildSoFar {
public:
    void add(WildPhoto photo) {
        const std::lock_guard lock(mutex_);
        photos_.push_back(std::move(photo));
    }
    std::vector<WildPhoto> photos() const {
        const std::lock_guard lock(mutex_);
        return photos_;
    }

private:
    mutable std::mutex mutex_;
    std::vector<WildPhoto> photos_;
};

const WildLabels* known(const std::optional<WildLabels>& labels) { return labels ? &*labels : nullptr; }

/// The sentence that says why not, else empty.
std::string measure(const Photographs& photographs, WildSoFar& so_far) {
    BatchProgress progress(photographs.files.size());
    return run_wild_bench(photographs.files, photographs.folder, [&](WildPhoto photo) {
        say(progress.next(photo.name));
        if (!photo.was_read())
            say_problem(photo.problem, photo.name);
        so_far.add(std::move(photo));
    });
}

/// All but the sheet, which looks at photographs again. The sentence that says why not, else empty.
std::string write_figures(const fs::path& out, const std::vector<WildPhoto>& photos,
                          const WildSummary& summary, const WildLabels* labels) {
    for (const auto& written :
         {write_wild_table(out, photos, labels), write_wild_summary(out, summary), plot_wild(out, summary)})
        if (!written)
            return written.error();
    return {};
}

void write_so_far(const fs::path& out, const WildSoFar& so_far, const std::optional<WildLabels>& labels,
                  std::size_t all) {
    const std::vector<WildPhoto> photos = so_far.photos();
    if (photos.empty())
        return say("Stopped before the first photograph was done; there are no figures.");
    const WildSummary summary = summary_of(photos, known(labels));
    if (const std::string problem = write_figures(out, photos, summary, known(labels)); !problem.empty())
        return say_problem(problem);
    show(summary);
    std::fflush(stdout); // the end that follows does not
    say("Stopped after " + std::to_string(photos.size()) + " of " + std::to_string(all) +
        "; the figures are of these.");
    say("worst.png is drawn only where all are done.");
}

} // namespace

int bench_wild(const VerbLine& line) {
    auto photographs = photographs_in(line.text("wild").toStdString());
    if (!photographs)
        return refused(photographs.error());
    if (line.has("only"))
        if (const std::string problem = keep_named(*photographs, line.text("only")); !problem.empty())
            return refused(problem);
    std::optional<WildLabels> labels;
    if (line.has("labels")) {
        auto read = labels_in(line.text("labels").toStdString());
        if (!read)
            return refused(read.error());
        labels.emplace(std::move(*read));
    }
    if (const std::string problem = line.make_folder("out"); !problem.empty())
        return refused(problem);
    if (!QFileInfo(line.text("out")).isWritable()) // said now, not after an hour
        return refused("Nothing can be written to the folder " + line.text("out").toStdString() + ".");

    const fs::path out = line.text("out").toStdString();
    WildSoFar so_far;
    {
        const LastWords figures([&] { write_so_far(out, so_far, labels, photographs->files.size()); },
                                LastWords::Said::at_once);
        if (const std::string problem = measure(*photographs, so_far); !problem.empty())
            return refused(problem);
        const std::vector<WildPhoto> photos = so_far.photos();
        if (const std::string problem =
                write_figures(out, photos, summary_of(photos, known(labels)), known(labels));
            !problem.empty())
            return refused(problem);
        if (const auto sheet = write_wild_sheet(out, photos, worst_of(photos, known(labels), tiles)); !sheet)
            return refused(sheet.error());
    }
    const WildSummary summary = summary_of(so_far.photos(), known(labels));
    show(summary);
    return summary.unread.empty() ? exit_done : exit_bad_input;
}

} // namespace tp
