// SPDX-License-Identifier: Apache-2.0
#include "app/figures/study/published_results.hpp"
#include "app/figures/study/study_report.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tp {
namespace {

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text)
        safe += c == '<'   ? std::string("&lt;")
                : c == '>' ? std::string("&gt;")
                : c == '&' ? std::string("&amp;")
                           : std::string(1, c);
    return safe;
}

std::string number(double value, int digits) {
    std::string text(32, '\0');
    text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.*f", digits, value)));
    return text;
}

std::string number(const std::optional<double>& value, int digits) {
    return value ? number(*value, digits) : "–";
}

std::string likelihood(const std::optional<double>& p) {
    return !p ? "–" : *p < 0.001 ? "&lt; 0.001" : number(*p, 3);
}

std::string row(const std::vector<std::string>& cells, const char* kind = "td") {
    std::string line = "<tr>";
    for (const std::string& one : cells)
        line += std::string("<") + kind + ">" + one + "</" + kind + ">";
    return line + "</tr>\n";
}

std::string page_head(const std::string& title) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + title +
           "</title>\n<style>body{font-family:sans-serif;max-width:75em;margin:1em auto;padding:0 1em}"
           "table{border-collapse:collapse;margin:0.5em 0 1.5em}td,th{border:1px solid #999;padding:0.2em "
           "0.6em;"
           "text-align:left}img{max-width:100%}</style>\n</head>\n<body>\n<h1>" +
           title + "</h1>\n";
}

std::string effects(const StudyMeasure& measure) {
    std::string table =
        "<table>\n" +
        row({"effect", "F", "degrees of freedom", "p", "ε", "p (Greenhouse–Geisser)", "η²"}, "th");
    for (const WithinEffect& effect : measure.anova.effects)
        table +=
            row({escaped(words_for(effect, measure.means.factors)), number(effect.f, 2),
                 number(effect.df, 0) + ", " + number(effect.error_df, 0), likelihood(effect.p),
                 number(effect.epsilon, 2), likelihood(effect.p_spherical), number(effect.eta_squared, 3)});
    return table + "</table>\n";
}

std::string levels(const StudyMeasure& measure) {
    std::string table = "<table>\n" + row({"factor", "level", "mean", "standard error", "Tukey"}, "th");
    for (std::size_t factor = 0; factor < measure.levels.size(); ++factor)
        for (const LevelMean& level : measure.levels[factor].levels)
            table += row({escaped(measure.means.factors[factor].name), escaped(level.level),
                          number(level.mean, 3), number(level.standard_error, 3), level.letters});
    return table + "</table>\n";
}

std::string confusion_words(const Confusion& confusion) {
    std::string text = "<h3>" + (confusion.where.empty() ? std::string("All") : escaped(confusion.where)) +
                       ": " + number(100.0 * confusion.right(), 1) + " % named rightly</h3>\n<table>\n";
    std::vector<std::string> head{"it was, and was called"};
    for (const std::string& name : confusion.names)
        head.push_back(escaped(name));
    head.emplace_back("nothing");
    text += row(head, "th");
    for (std::size_t i = 0; i < confusion.names.size(); ++i) {
        std::vector<std::string> cells{escaped(confusion.names[i])};
        for (const std::size_t count : confusion.counts[i])
            cells.push_back(std::to_string(count));
        text += row(cells);
    }
    return text + "</table>\n";
}

} // namespace

std::string published_rows(std::span<const ComparedResult> results) {
    std::string table = "<table>\n" + row({"what", "published (Lim, Yoo, Choi 2019)", "here", "alike"}, "th");
    for (const ComparedResult& result : results)
        table += row({escaped(subject_words(result.published)), escaped(published_words(result.published)),
                      escaped(our_words(result)), result.alike ? "yes" : "no"});
    return table + "</table>\n<p>Alike: an F on the same side of p = 0.05, an order in most studies, a time "
                   "within a factor "
                   "of two, a share within ten points.</p>\n";
}

std::string comparison_page(std::span<const StudyReport> studies, std::span<const ComparedResult> results) {
    const Experiment& experiment = studies.front().experiment;
    std::string page = page_head(escaped(experiment.title.empty() ? experiment.name : experiment.title) +
                                 ", beside the published experiment");
    page += "<p>" + std::to_string(studies.size()) + " studies of " +
            std::to_string(studies.front().participants) +
            " participants each. In brackets: the smallest and the largest of the studies.</p>\n"
            "<img src=\"published.svg\" alt=\"Each published F and mean beside those of the studies.\">\n";
    std::vector<std::string> remarks;
    for (const StudyReport& study : studies)
        for (const std::string& remark : study.remarks)
            if (std::ranges::find(remarks, remark) == remarks.end())
                remarks.push_back(remark);
    page += remarks.empty() ? "" : "<ul>\n";
    for (const std::string& remark : remarks)
        page += "<li>" + escaped(remark) + "</li>\n";
    page += remarks.empty() ? "" : "</ul>\n";
    return page + published_rows(results) + "</body>\n</html>\n";
}

std::string study_page(const StudyReport& report, const std::vector<std::string>& plots) {
    const auto plot = [&](const std::string& name, const std::string& shows) {
        return std::ranges::find(plots, name) == plots.end()
                   ? std::string()
                   : "<img src=\"" + name + ".svg\" alt=\"" + shows + "\">\n";
    };
    const std::string title =
        escaped(report.experiment.title.empty() ? report.experiment.name : report.experiment.title);
    std::string page = page_head(title) + "<p>" + std::to_string(report.participants) + " participants, " +
                       std::to_string(report.trials) + " trials that count, " +
                       std::to_string(report.repeated) + " that were done again.</p>\n";
    if (!report.remarks.empty()) {
        page += "<ul>\n";
        for (const std::string& remark : report.remarks)
            page += "<li>" + escaped(remark) + "</li>\n";
        page += "</ul>\n";
    }
    page += plot("speed", "Time against the other measure, a dot for each condition.");
    for (const StudyMeasure& measure : report.measures)
        page += "<h2>" + escaped(measure.axis) + "</h2>\n" +
                plot(measure.name, "Means over each factor with standard errors over participants, and "
                                   "Tukey's letters; the numbers stand in the tables below.") +
                effects(measure) + levels(measure);
    if (const auto compared = compared_results(std::span(&report, 1)); !compared.empty())
        page += "<h2>Beside the published experiment</h2>\n" +
                plot("published", "Each published F and mean beside that of this study.") +
                published_rows(compared);
    if (!report.confusions.empty())
        page += "<h2>What was called what</h2>\n";
    for (const Confusion& confusion : report.confusions)
        page += confusion_words(confusion);
    return page + "<p>Repeated-measures analysis of variance; p after Greenhouse and Geisser; η² is "
                  "generalised (Olejnik and "
                  "Algina 2003). Levels that have a letter in common do not differ (Tukey's HSD, "
                  "0.05).</p>\n</body>\n</html>\n";
}

} // namespace tp
