// SPDX-License-Identifier: Apache-2.0
#include "app/cli/bench_identity.hpp"
#include "app/cli/bench_wild.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/names_file.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/figures/bench/face_bench.hpp"
#include "core/files/file_name.hpp"

#include <QDir>
#include <QString>

#include <cstdio>

namespace tp {

namespace {

void show(const std::vector<FaceBenchRow>& rows, const std::vector<BatchSpeed>& speeds) {
    print("%-26s %6s %6s %8s %8s %8s %9s %6s %8s %6s %6s %6s %8s %6s\n", "contender", "px", "photos",
          "failures", "decode", "detect", "landmarks", "edges", "contours", "eyes", "outer", "inner",
          "outline", "worst");
    for (const FaceBenchRow& row : rows)
        print("%-26s %6s %6d %8d %8.1f %8.1f %9.1f %6.1f %8.1f %6.2f %6.2f %6.2f %8.2f %6.2f\n",
              row.contender.c_str(), row.longest_px > 0 ? std::to_string(row.longest_px).c_str() : "-",
              row.photos, row.failures, row.decode_ms, row.detect_ms, row.landmarks_ms, row.edges_ms,
              row.contours_ms, row.error_percent[0], row.error_percent[1], row.error_percent[2],
              row.error_percent[3], row.worst_percent);
    std::puts(
        "\nms: medians, one photograph at a time on one core; errors: percent of the outer inter-ocular\n"
        "distance, means; a failure is a face not found or a feature more than 5 % off.");
    for (const BatchSpeed& speed : speeds)
        print("batch on %zu thread%s: %.1f photographs a second (%.2f x)\n", speed.threads,
              speed.threads == 1 ? "" : "s", speed.photos_per_s,
              speed.photos_per_s / speeds.front().photos_per_s);
}

/// A line for each contender in each way in which portraits were made harder.
void show(const std::vector<HarderRow>& rows) {
    const auto column = [](const std::string& words) { // by letters, not bytes: ‰ and °
        return QString::fromStdString(words).leftJustified(24).toStdString();
    };
    print("\n%-24s %-18s %6s %5s %8s %4s %6s %6s %6s %8s\n", "made harder", "contender", "photos", "found",
          "failures", "said", "eyes", "outer", "inner", "outline");
    for (const HarderRow& row : rows)
        print("%s %-18s %6d %5d %8d %4d %6.2f %6.2f %6.2f %8.2f\n", column(row.how).c_str(),
              row.contender.c_str(), row.photos, row.found, row.failures, row.said, row.error_percent[0],
              row.error_percent[1], row.error_percent[2], row.error_percent[3]);
    std::puts(
        "\nmeans over the photographs in which every contender found a face; said: a problem or a reason\n"
        "why a contour may be wrong was told.");
}

/// A sentence where something is wrong; else empty.
std::string run_harder(const std::vector<PlacedPortrait>& portraits, const std::filesystem::path& out) {
    std::vector<FaceContender> contenders = face_contenders();
    std::erase_if(contenders, [](const FaceContender& contender) {
        return contender.name != "embedded" && !contender.name.starts_with("mesh");
    });
    const auto rows = run_harder_bench(portraits, contenders, say_step);
    if (!rows)
        return rows.error();
    if (const auto written = write_harder_table(out, *rows); !written)
        return written.error();
    show(*rows);
    return {};
}

/// A sentence where something is wrong; else empty.
std::string run(const VerbLine& line) {
    const std::filesystem::path photos = line.text("photos").toStdString();
    auto portraits = read_placed_truth(line.text("truth").toStdString(), photos);
    if (!portraits)
        return portraits.error();
    if (line.has("people")) {
        const auto people = names_in(line.text("people"), "people");
        if (!people)
            return people.error();
        std::erase_if(*portraits, [&](const PlacedPortrait& portrait) {
            const std::string name = portrait.photo.stem().string();
            return !people->contains(name.substr(0, name.find('_')));
        });
    }
    if (portraits->empty())
        return "There is no photograph with placed contours to measure on.";
    const QDir folder(line.text("out"));
    if (const std::string problem = line.make_folder("out"); !problem.empty())
        return problem;
    if (line.has("harder"))
        return run_harder(*portraits, path_named(folder.path().toStdString()));
    const auto rows = run_face_bench(*portraits, face_contenders(), {0, 640, 320, 160}, say_step);
    if (!rows)
        return rows.error();
    say_step("a batch on one core and on all");
    const auto speeds = run_batch_bench(*portraits);
    if (!speeds)
        return speeds.error();
    const std::filesystem::path out = path_named(folder.path().toStdString());
    for (const auto& written : {write_face_table(out, *rows), plot_faces(out, *rows)})
        if (!written)
            return written.error();
    show(*rows, *speeds);
    return {};
}

} // namespace

int bench_faces_verb(const QStringList& words) {
    VerbLine line(
        "bench faces",
        "Weighs speed against accuracy of face contours: milliseconds a photograph and error against\n"
        "contours placed by hand, for our nets after each of their refinements, for YuNet and for the\n"
        "face mesh, over sizes of the pictures. Writes faces.csv, faces.png and faces.svg. With --wild,\n"
        "photographs without such contours instead: found or not, how far our contours are from the face\n"
        "mesh's, what is said about them, milliseconds. Writes wild.csv, wild_summary.csv, wild.png,\n"
        "wild.svg and worst.png, the worst twenty enlarged. With --identity, how well portraits of one\n"
        "person are told from others', as they are and made harder, and how they are grouped. Writes\n"
        "identity.csv, identity.png and identity.svg.");
    line.option("photos", "Where the photographs are.", "DIR")
        .option("truth", "Their contours placed by hand, JSON (faces/evaluation/placed_truth.hpp).", "FILE")
        .option(
            "harder",
            "Instead, portraits made harder: blurred, small, lit from the side, covered, turned, with open\n"
            "mouths; our nets beside the face mesh. Writes harder.csv.")
        .option("wild", "Photographs without truth: a folder and the folders in it, or a single one.", "DIR")
        .option("identity", "Portraits whose names begin with the person's and _: 002_03.jpg, 002_08.jpg.",
                "DIR")
        .option("only", "With --wild: only photographs whose file names are lines of this file.", "FILE")
        .option("labels", "With --wild: what a person saw in them, as tests/faces/wild_labels.txt.", "FILE")
        .option("people", "Only photographs whose name begins with a line of this file and _.", "FILE")
        .option("out", "Folder for the results; created if it is missing.", "DIR");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    const bool wild = line.has("wild");
    for (const char* other : {"photos", "truth", "people", "harder"})
        if (wild && line.has(other))
            return wrong_usage("bench faces", std::string("--") + other + " does not go with --wild.");
    const bool identity = line.has("identity");
    for (const char* other : {"photos", "truth", "people", "harder", "wild"})
        if (identity && line.has(other))
            return wrong_usage("bench faces", std::string("--") + other + " does not go with --identity.");
    for (const char* other : {"only", "labels"})
        if (!wild && line.has(other))
            return wrong_usage("bench faces", std::string("--") + other + " goes with --wild DIR.");
    using Names = std::vector<const char*>;
    for (const char* needed : wild || identity ? Names{"out"} : Names{"photos", "truth", "out"})
        if (!line.has(needed))
            return wrong_usage("bench faces", std::string("--") + needed + " is missing.");
    if (wild)
        return bench_wild(line);
    if (identity)
        return bench_identity(line);
    const std::string problem = run(line);
    if (problem.empty())
        return exit_done;
    say_problem(problem);
    return exit_bad_input;
}

} // namespace tp
