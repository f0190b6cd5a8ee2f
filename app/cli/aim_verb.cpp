// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/json_number.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/figures/report/aim_report.hpp"

#include <QJsonArray>
#include <QJsonObject>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

namespace {

QString text_of(std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

QJsonObject json_of(const AimReport& report, int seed) {
    QJsonArray rows;
    for (std::size_t i = 0; i < all_guidance.size(); ++i) {
        const AimShares& shares = report.shares[i];
        rows.append(QJsonObject{
            {"guidance", text_of(name_of(all_guidance[i]))},
            {"within_5_s", in_thousandths(shares.within_5_s)},
            {"within_10_s", in_thousandths(shares.within_10_s)},
            {"within_15_s", in_thousandths(shares.within_15_s)},
            {"within_20_s", in_thousandths(shares.within_20_s)},
            {"median_s", shares.median_s ? QJsonValue(in_thousandths(*shares.median_s)) : QJsonValue()},
            {"missed_pictures", in_thousandths(shares.missed_pictures)},
            {"sentences", in_thousandths(shares.sentences)}});
    }
    return {{"aim", text_of(name_of(report.aim))},
            {"people", static_cast<int>(report.shares.front().trials)},
            {"seed", seed},
            {"guidance", rows}};
}

void show(const AimReport& report) {
    print("%-16s %7s %7s %7s %7s %8s %7s %9s\n", "guidance", "5 s", "10 s", "15 s", "20 s", "median",
          "missed", "sentences");
    for (std::size_t i = 0; i < all_guidance.size(); ++i) {
        const AimShares& shares = report.shares[i];
        const std::string median =
            shares.median_s ? QString::asprintf("%.1f s", *shares.median_s).toStdString() : "-";
        print("%-16s %5.1f %% %5.1f %% %5.1f %% %5.1f %% %8s %7.2f %9.1f\n",
              std::string(name_of(all_guidance[i])).c_str(), 100.0 * shares.within_5_s,
              100.0 * shares.within_10_s, 100.0 * shares.within_15_s, 100.0 * shares.within_20_s,
              median.c_str(), shares.missed_pictures, shares.sentences);
    }
}

} // namespace

int aim_verb(const QStringList& words) {
    VerbLine line(
        "aim",
        "simulate: lets simulated hands aim a camera at people by what they hear, in simulated time:\n"
        "by words and tone, words, tone and nothing. Says what share of them had a picture as it was\n"
        "wished within 5, 10, 15 and 20 s, and the median time. Writes aim.csv, people.csv and a plot.\n"
        "By geometry alone: no photograph is looked at. The same seed gives the same bytes.");
    line.argument("simulate", "What is done.", "simulate")
        .option("out", "Folder for the results; made where it is missing.", "DIR")
        .option("people", "How many people, each with every guidance.", "N", "500")
        .option("seed", "Whole number; another one is other people.", "S", "1")
        .option("aim", "What they want: middle, thirds, head-and-shoulders or everybody.", "AIM", "middle")
        .option("assumptions",
                "Also what becomes of words and tone where what was assumed is otherwise: assumptions.csv.")
        .option("json", "JSON instead of a table.");
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    if (line.arguments().front() != "simulate")
        return wrong_usage("aim", "There is nothing called \"" + line.arguments().front().toStdString() +
                                      "\"; simulate is what can be done.");
    if (!line.has("out"))
        return wrong_usage("aim", "--out DIR is missing.");
    const auto people = line.whole("people", 1, 100'000);
    const auto seed = line.whole("seed", 0, 1'000'000'000);
    if (!people || !seed)
        return wrong_usage("aim", people ? seed.error() : people.error());
    const auto aim = aim_named(line.text("aim").toStdString());
    if (!aim)
        return wrong_usage("aim", "--aim needs middle, thirds, head-and-shoulders or everybody.");
    if (const std::string problem = line.make_folder("out"); !problem.empty())
        return refused(problem);

    LongWork::step("aiming");
    const AimReport report = measure_aiming(*aim, *people, static_cast<std::uint64_t>(*seed), LongWork::share,
                                            [] { return LongWork::stop_asked().load(); });
    if (LongWork::stop_asked())
        return LongWork::stop_code();
    std::vector<AimVariation> variations;
    if (line.has("assumptions")) {
        LongWork::step("aiming under other assumptions");
        variations = vary_assumptions(*aim, *people, static_cast<std::uint64_t>(*seed), LongWork::share,
                                      [] { return LongWork::stop_asked().load(); });
        if (LongWork::stop_asked())
            return LongWork::stop_code();
    }
    LongWork::step("writing tables and a plot");
    const std::filesystem::path out = line.text("out").toStdString();
    for (const auto& written :
         {shares_table(report).write(out / "aim.csv"),
          people_table(report, static_cast<std::uint64_t>(*seed)).write(out / "people.csv"),
          plot_aiming(out, report)})
        if (!written)
            return refused(written.error());
    if (!variations.empty())
        if (const auto written = variations_table(variations).write(out / "assumptions.csv"); !written)
            return refused(written.error());
    if (line.has("json"))
        print_json(json_of(report, *seed));
    else
        show(report);
    return exit_done;
}

} // namespace tp
