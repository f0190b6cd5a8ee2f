// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/golden_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace tp {
namespace {

constexpr double relative_margin = 0.02, margin_percent = 0.005;
constexpr double relative_margin_of_worst = 0.05, margin_of_worst_percent = 0.02;
constexpr std::size_t most_named = 3; ///< people in a sentence
constexpr const char* renewal = "`cmake --build build/release --target renew_golden_set` keeps it";

constexpr const char* heading =
    "# SPDX-License-" // in two pieces, so that it is not taken for this file's own
    "Identifier: Apache-2.0\n"
    "# How far contours are from those placed by hand, people held out of all "
    "training (faces/training/holdout.txt),\n"
    "# percent of the outer inter-ocular distance. Written by renew_golden_set, "
    "which keeps the better of old and new.\n";

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string printed(const char* format, ...) {
    va_list values, again;
    va_start(values, format);
    va_copy(again, values);
    std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, values)), '\0');
    std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(values);
    va_end(again);
    return text;
}

/// Those with a measured face, the worst of that feature first.
std::vector<PortraitErrors> worst_first(std::vector<PortraitErrors> measured, std::size_t feature) {
    std::erase_if(measured, [](const PortraitErrors& person) { return !person.percent; });
    std::ranges::stable_sort(measured, std::greater<>(),
                             [feature](const PortraitErrors& person) { return (*person.percent)[feature]; });
    return measured;
}

/// "011_03.jpg (2.25 %), 139_03.jpg (1.30 %)"
std::string worst_people(const std::vector<PortraitErrors>& measured, std::size_t feature) {
    std::string names;
    for (const PortraitErrors& person : worst_first(measured, feature)) {
        names += printed("%s%s (%.2f %%)", names.empty() ? "" : ", ", person.photo.c_str(),
                         (*person.percent)[feature]);
        if (std::ranges::count(names, '(') == most_named)
            break;
    }
    return names;
}

std::string failed_people(const std::vector<PortraitErrors>& measured) {
    std::string names;
    for (const PortraitErrors& person : measured)
        if (person.failed())
            names += (names.empty() ? "" : ", ") + person.photo +
                     (person.problem.empty() ? "" : " (" + person.problem + ")");
    return names;
}

} // namespace

std::map<std::string, ExtractorChoice> golden_choices() {
    return {{"embedded", {}}, {"yunet", {"yunet", "embedded"}}, {"mesh", {"embedded", "mesh"}}};
}

GoldenRow golden_row(const std::vector<PortraitErrors>& measured) {
    GoldenRow row;
    row.people = measured.size();
    double found = 0.0;
    for (const PortraitErrors& person : measured) {
        row.failures += person.failed();
        if (!person.percent)
            continue;
        ++found;
        for (std::size_t f = 0; f < feature_count; ++f) {
            row.features[f].mean += ((*person.percent)[f] - row.features[f].mean) / found;
            row.features[f].worst = std::max(row.features[f].worst, (*person.percent)[f]);
        }
    }
    return row;
}

GoldenRow better_of(const GoldenRow& kept, const GoldenRow& measured) {
    if (kept.people != measured.people)
        return measured;
    GoldenRow better = kept;
    better.failures = std::min(kept.failures, measured.failures);
    for (std::size_t f = 0; f < feature_count; ++f) {
        better.features[f].mean = std::min(kept.features[f].mean, measured.features[f].mean);
        better.features[f].worst = std::min(kept.features[f].worst, measured.features[f].worst);
    }
    return better;
}

double most_allowed_mean(double golden) { return golden * (1.0 + relative_margin) + margin_percent; }

double most_allowed_worst(double golden) {
    return golden * (1.0 + relative_margin_of_worst) + margin_of_worst_percent;
}

std::vector<std::string> differences(const std::string& row, const GoldenRow& golden,
                                     const std::vector<PortraitErrors>& measured) {
    const GoldenRow now = golden_row(measured);
    const char* name = row.c_str();
    if (now.people != golden.people)
        return {printed("%s: %zu people were measured, the golden set has %zu; %s.", name, now.people,
                        golden.people, renewal)};
    std::vector<std::string> all;
    if (now.failures > golden.failures)
        all.push_back(printed("%s: %zu portraits fail, %zu in the golden set: %s.", name, now.failures,
                              golden.failures, failed_people(measured).c_str()));
    if (now.failures < golden.failures)
        all.push_back(printed("%s: only %zu portraits fail, %zu in the golden set; %s.", name, now.failures,
                              golden.failures, renewal));
    for (std::size_t f = 0; f < feature_count; ++f) {
        const auto& [mean, worst] = now.features[f];
        const auto& kept = golden.features[f];
        const char* feature = felt_features[f];
        const std::string people = worst_people(measured, f);
        if (!(mean <= most_allowed_mean(kept.mean)))
            all.push_back(printed("%s: the mean error of %s is %.4f %%, in the golden set %.4f, and at most "
                                  "%.4f is allowed; the "
                                  "largest: %s.",
                                  name, feature, mean, kept.mean, most_allowed_mean(kept.mean),
                                  people.c_str()));
        if (!(worst <= most_allowed_worst(kept.worst)))
            all.push_back(printed(
                "%s: the worst %s is %.4f %% off, in the golden set %.4f, and at most %.4f is allowed; the "
                "largest: %s.",
                name, feature, worst, kept.worst, most_allowed_worst(kept.worst), people.c_str()));
        if (most_allowed_mean(mean) < kept.mean)
            all.push_back(
                printed("%s: the mean error of %s is %.4f %%, better than %.4f in the golden set; %s.", name,
                        feature, mean, kept.mean, renewal));
        if (most_allowed_worst(worst) < kept.worst)
            all.push_back(printed("%s: the worst %s is %.4f %% off, better than %.4f in the golden set; %s.",
                                  name, feature, worst, kept.worst, renewal));
    }
    return all;
}

std::string text_of(const GoldenSet& set) {
    std::string text = heading;
    for (const auto& [name, row] : set) {
        text += printed("%s people %zu failures %zu\n", name.c_str(), row.people, row.failures);
        for (std::size_t f = 0; f < feature_count; ++f)
            text += printed("%s %s mean %.4f worst %.4f\n", name.c_str(), felt_features[f],
                            row.features[f].mean, row.features[f].worst);
    }
    return text;
}

Result<GoldenSet> read_golden_set(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream)
        return Error{"The golden set \"" + file.string() + "\" cannot be read."};
    GoldenSet set;
    std::map<std::string, std::size_t> features_of;
    for (std::string line; std::getline(stream, line);) {
        if (line.empty() || line.front() == '#')
            continue;
        const Error wrong{"In the golden set \"" + file.string() + "\" this line has no figures: " + line};
        std::istringstream words(line);
        std::string name, what, label, other;
        words >> name >> what;
        GoldenRow& row = set[name];
        if (what == "people") {
            words >> row.people >> label >> row.failures;
            if (!words || label != "failures")
                return wrong;
            continue;
        }
        const auto at = std::ranges::find(felt_features, what);
        if (at == felt_features.end())
            return wrong;
        auto& [mean, worst] = row.features[static_cast<std::size_t>(at - felt_features.begin())];
        words >> label >> mean >> other >> worst;
        if (!words || label != "mean" || other != "worst")
            return wrong;
        ++features_of[name];
    }
    for (const auto& [name, row] : set)
        if (row.people == 0 || features_of[name] != feature_count)
            return Error{"In the golden set \"" + file.string() + "\" figures of \"" + name +
                         "\" are missing."};
    return set;
}

} // namespace tp
