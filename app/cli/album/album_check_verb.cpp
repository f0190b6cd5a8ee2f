// SPDX-License-Identifier: Apache-2.0
#include "app/cli/album/album_json.hpp"
#include "app/cli/album/album_verbs.hpp"
#include "app/cli/album/album_words.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "core/files/file_words.hpp"

#include <QJsonArray>

#include <algorithm>
#include <cstdio>

namespace tp {

namespace {

void print_as_json(const CheckReport& report) {
    QJsonArray findings;
    for (const Finding& finding : report.findings)
        findings.append(to_json(finding));
    print_json({{"photos", static_cast<qint64>(report.photos)},
                {"recordings", static_cast<qint64>(report.recordings)},
                {"findings", findings},
                {"told", json_texts(report.told)},
                {"stopped", report.stopped}});
}

void print_for_a_person(const CheckReport& report, bool mend) {
    print("%zu photographs, %zu recordings\n", report.photos, report.recordings);
    for (const Finding& finding : report.findings) {
        print("%s", finding.sentence.c_str());
        if (!finding.mend.empty())
            print(" %s%s", mend ? finding.mended ? "Mended: " : "Not mended: " : "With --mend: ",
                  finding.problem.empty() ? finding.mend.c_str() : finding.problem.c_str());
        print("\n");
    }
    for (const std::string& sentence : report.told)
        print("%s\n", sentence.c_str());
    if (report.findings.empty() && !report.stopped)
        print("Everything is as it should be.\n");
}

} // namespace

int album_check(const QStringList& words) {
    VerbLine line(
        "album check",
        "Checks an album's folder and all folders below it: each recording is whole and listed, each\n"
        "sidecar readable, nothing half-written, nothing left behind. Ends with 1 if something is wrong\n"
        "and was not mended.");
    line.option("mend", "Mends what can be mended; what is in the way goes to the album's trash.")
        .option("no-hashes", "Does not read the photographs themselves: quicker, but sees no changed bytes.")
        .option("json", "One JSON object on stdout.")
        .argument("ALBUM", "The album's folder.");
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    CheckOptions options;
    options.mend = line.has("mend");
    options.hashes = !line.has("no-hashes");
    options.report = [&](std::size_t photos, const std::filesystem::path& current) {
        LongWork::step(std::to_string(photos) + " photographs looked at, now " + quoted(current.filename()));
    };
    const auto report = check_album(path_given(line.arguments().first()), options, LongWork::stop_token());
    if (!report)
        return refused(report.error());
    if (line.has("json"))
        print_as_json(*report);
    else
        print_for_a_person(*report, options.mend);
    if (report->stopped)
        return LongWork::stop_code();
    return std::all_of(report->findings.begin(), report->findings.end(),
                       [](const Finding& finding) { return finding.mended; })
               ? exit_done
               : exit_bad_input;
}

} // namespace tp
