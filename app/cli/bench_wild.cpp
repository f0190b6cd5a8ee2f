// SPDX-License-Identifier: Apache-2.0
#include "app/cli/bench_wild.hpp"

#include "app/cli/batch_progress.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/names_file.hpp"
#include "app/cli/photographs_in.hpp"
#include "app/figures/bench/wild_bench.hpp"
#include "core/files/whole_file.hpp"

#include <QFileInfo>
#include <QString>

#include <algorithm>
#include <cstdio>
#include <optional>

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
    std::printf("%s: %zu%s\n", what, names.size(), names.empty() ? "" : ":");
    for (std::size_t i = 0; i < std::min(names.size(), names_shown); ++i)
        std::printf("  %s\n", names[i].c_str());
    if (names.size() > names_shown)
        std::printf("  and %zu more, in wild.csv\n", names.size() - names_shown);
}

void print_agreement(const WildSummary& all) {
    std::printf("\n%-18s %9s %7s %6s %9s\n", "from the mesh", "contours", "mean", "95 %", "over 5 %");
    for (const WildAgreement& one : all.agreement)
        std::printf("%-18s %9d %7.2f %6.2f %9d\n", one.name, one.contours, one.mean_percent, one.p95_percent,
                    one.much_off);
    std::puts(
        "percent of the distance between the eyes' outer corners; each eye is one contour. The mesh is\n"
        "no truth: where both differ, worst.png shows which is right.");
}

void print_said(const WildSummary& all) {
    std::printf("\n%-18s %9s %8s %9s %9s %7s\n", "said of contours", "right eye", "left eye", "outer lip",
                "inner lip", "outline");
    for (const auto& [reason, of] : all.reasons)
        std::printf("%-18s %9d %8d %9d %9d %7d\n", reason.c_str(), of[0], of[1], of[2], of[3], of[4]);
    std::printf("the largest face of each photograph, %d in all\n", all.largest_faces);
    std::printf("\n%7s %5s  %s\n", "largest", "all", "said of faces (N: a number)");
    for (const auto& [sentence, said] : all.sentences)
        std::printf("%7d %5d  %s\n", said.largest, said.all, sentence.c_str());
    if (all.sentences.empty())
        std::printf("%7d %5d  nothing\n", 0, 0);
}

void print_covers(const WildCovers& covers) {
    std::printf("\n%-18s %5s %28s\n", "beside the labels", "all", "said that it may be covered");
    const auto row = [](const char* what, const WildCovers::Count& one) {
        std::printf("%-18s %5d %28d\n", what, one.all, one.said);
    };
    row("eyes not covered", covers.clear_eyes);
    row("mouths not covered", covers.clear_mouths);
    row("eyes covered", covers.covered_eyes);
    row("mouths covered", covers.covered_mouths);
    std::printf(
        "the largest face of each labelled photograph, %d in all; said falsely in %d of them (%.1f %%)\n",
        covers.photos, covers.photos_falsely,
        covers.photos > 0 ? 100.0 * covers.photos_falsely / covers.photos : 0.0);
    print_names("said falsely", covers.falsely);
    std::printf("labelled as without a face of 40 px, not counted above: %d; a face found in %d\n",
                covers.without_face.all, covers.without_face.said);
    if (covers.unlabelled > 0)
        std::printf("photographs without a label: %d\n", covers.unlabelled);
}

void print(const WildSummary& all) {
    std::printf("photographs: %d\n", all.photos);
    print_names("could not be read", all.unread);
    print_names("no face found by ours", all.not_found);
    print_names("no face found by the mesh", all.not_found_by_mesh);
    print_names("our largest face not found by the mesh", all.apart);
    std::printf("faces: %d by ours, %d by the mesh, %d by both\n", all.faces, all.mesh_faces,
                all.common_faces);
    print_agreement(all);
    print_said(all);
    std::printf("\n%-22s %8s %7s\n", "ms a photograph", "median", "95 %");
    std::printf("%-22s %8.1f %7.1f\n", "decoding", all.decode_ms, all.decode_p95_ms);
    std::printf("%-22s %8.1f %7.1f\n", "detection to contours", all.rest_ms, all.rest_p95_ms);
    if (all.covers)
        print_covers(*all.covers);
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

    BatchProgress progress(photographs->files.size());
    const auto tell = [&](const WildPhoto& photo) {
        say(progress.next(photo.name));
        if (!photo.was_read())
            say_problem(photo.problem, photo.name);
    };
    LongWork::finish_when_stopped("Stopping after this photograph, with the figures of those that are done.");
    const auto photos = run_wild_bench(photographs->files, photographs->folder, tell, LongWork::stop_asked());
    if (!photos)
        return refused(photos.error());
    const WildLabels* known = labels ? &*labels : nullptr;
    const WildSummary summary = summary_of(*photos, known);
    const fs::path out = line.text("out").toStdString();
    for (const auto& written :
         {write_wild_table(out, *photos, known), write_wild_summary(out, summary), plot_wild(out, summary),
          write_wild_sheet(out, *photos, worst_of(*photos, known, tiles))})
        if (!written)
            return refused(written.error());
    print(summary);
    if (photos->size() < photographs->files.size()) {
        say("Stopped after " + std::to_string(photos->size()) + " of " +
            std::to_string(photographs->files.size()) + "; the figures are of these.");
        return LongWork::stop_code();
    }
    return summary.unread.empty() ? exit_done : exit_bad_input;
}

} // namespace tp
