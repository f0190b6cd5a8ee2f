// SPDX-License-Identifier: Apache-2.0
#include "app/cli/study_simulation.hpp"

#include "app/cli/expression_labels.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/figures/simulated/simulated_kinds.hpp"
#include "app/figures/simulated/simulated_study.hpp"
#include "app/figures/study/own_experiments.hpp"
#include "app/figures/study/published_results.hpp"
#include "core/experiment/experiment_file.hpp"
#include "core/experiment/number_text.hpp"
#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"
#include "core/study/expression.hpp"
#include "core/study_folder/study_folder.hpp"
#include "core/svg/contour_sheet.hpp"
#include "core/version/version.hpp"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace tp {
namespace {

constexpr int most_jobs = 256;

/// The experiment with one law for all trials; a sentence where its trials compare laws.
std::string set_law(Experiment& experiment, const std::string& law) {
    if (std::ranges::find(experiment.factors, StudyParameter::law, &StudyFactor::parameter) !=
        experiment.factors.end())
        return "The law varies in this experiment, so that --law cannot set it.";
    std::erase_if(experiment.settings,
                  [](const StudyFactor& setting) { return setting.parameter == StudyParameter::law; });
    experiment.settings.push_back({StudyParameter::law, {law}});
    return {};
}

Result<SimulatedBench> bench_of(const VerbLine& line) {
    SimulatedBench bench;
    if (line.has("device")) {
        const auto kind = simulated_kind(line.text("device").toStdString());
        if (!kind)
            return Error{"There is no device " + quoted_readable(line.text("device").toStdString()) +
                         "; --device knows pad, stick, falcon, 2diy and mouse."};
        bench.body = kind->body;
        bench.rate_hz = kind->rate_hz;
        bench.delay_ticks = static_cast<std::size_t>(std::lround(kind->delay_s * kind->rate_hz));
    }
    if (line.has("rate")) {
        const auto rate = line.positive("rate");
        if (!rate || *rate < 100.0 || *rate > 4000.0)
            return Error{rate ? "--rate is from 100 to 4000 Hz." : rate.error()};
        bench.rate_hz = *rate;
    }
    if (line.has("delay")) {
        const auto delay = line.whole("delay", 0, 16);
        if (!delay)
            return Error{delay.error()};
        bench.delay_ticks = static_cast<std::size_t>(*delay);
    }
    if (line.has("max-force")) {
        const auto limit = line.positive("max-force");
        if (!limit)
            return Error{limit.error()};
        bench.limit_n = *limit;
    }
    bench.led = line.has("led");
    bench.continuity.corner_cue = line.has("corner-cue");
    if (line.has("blend")) {
        const auto blend = line.positive("blend");
        if (!blend)
            return Error{blend.error()};
        bench.continuity.blend_mm = *blend;
    }
    if (const std::string problem = bench.continuity.problem(); !problem.empty())
        return Error{problem};
    return bench;
}

/// What stands in the study's folder of the device. Without a day, so that the same people write the same bytes every day.
StudyMachine machine_of(const SimulatedBench& bench, const std::string& kind) {
    std::string device = (kind.empty() ? "simulated device, " : "simulated " + kind + ", ") +
                         shortest(bench.rate_hz) + " Hz, " + std::to_string(bench.delay_ticks) +
                         " ticks of delay";
    if (bench.continuity.blend_mm > 0.0)
        device += ", blended over " + shortest(bench.continuity.blend_mm) + " mm";
    if (bench.continuity.corner_cue)
        device += ", corner cue";
    if (bench.led)
        device += ", led to the start";
    if (bench.limit_n)
        device += ", at most " + shortest(*bench.limit_n) + " N";
    return {"", std::string("touchphoto ") + version_number(), device, "millimetres and newtons as they are"};
}

/// The drawn contours of a folder, PERSON_EXPRESSION.svg: the number of a face counts the files of its expression by name.
class FacesInFolder final : public StudyFaces {
public:
    static Result<FacesInFolder> read(const std::filesystem::path& folder) {
        std::vector<std::filesystem::path> files;
        std::error_code error;
        for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
             at.increment(error))
            if (at->path().extension() == ".svg")
                files.push_back(at->path());
        if (error)
            return Error{"The folder " + quoted(folder) + " cannot be read."};
        std::ranges::sort(files);
        FacesInFolder faces;
        for (const std::filesystem::path& file : files) {
            const ExpressionLabel label = ExpressionLabels().of(file);
            if (!label.shown)
                continue;
            const auto sheet = read_sheet(file, ContourSheet::Unit::pixel);
            if (!sheet)
                return Error{quoted(file) + ": " + sheet.error()};
            faces.of_[std::string(name_of(*label.shown))].push_back(sheet->contours);
        }
        return faces;
    }
    Result<std::vector<Contour>> contours(std::string_view expression, std::string_view face) const override {
        const auto all = of_.find(std::string(expression));
        const auto number = number_in(face, std::size_t{1}, std::size_t{1000});
        if (all == of_.end() || !number || *number > all->second.size())
            return Error{"The folder of faces has no face number " + std::string(face) + " that is " +
                         std::string(expression) + "."};
        return all->second[*number - 1];
    }

private:
    std::map<std::string, std::vector<std::vector<Contour>>> of_; ///< by expression
};

void tell(const VerbLine& line, const Experiment& experiment, int participants, const SimulatedStudy& study) {
    for (const std::string& remark : study.remarks)
        say(remark);
    if (!line.has("json")) {
        print("%d participants, %zu trials, %zu done again, %.0f s at the device\n", participants,
              study.trials, study.repeated, study.simulated_s);
        if (study.led_s > 0.0)
            print("%.0f s led to the starts\n", study.led_s);
        return;
    }
    QJsonArray remarks;
    for (const std::string& remark : study.remarks)
        remarks.append(QString::fromStdString(remark));
    const QJsonObject object{{"experiment", QString::fromStdString(experiment.name)},
                             {"participants", participants},
                             {"trials", static_cast<int>(study.trials)},
                             {"repeated", static_cast<int>(study.repeated)},
                             {"seconds", study.simulated_s},
                             {"led_seconds", study.led_s},
                             {"remarks", remarks}};
    print_json(object);
}

} // namespace

Result<Experiment> experiment_of(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        if (const auto own = own_experiment(file.string()))
            return read_experiment(*own);
    const auto text = read_whole(file, most_experiment_bytes);
    return text ? read_experiment(*text) : Error{text.error()};
}

void add_simulation_options(VerbLine& line) {
    line.option("seeds", "With replicate: so many studies, each of other people, from --seed on.", "N", "10")
        .option("participants", "With simulate: how many simulated people.", "N", "10")
        .option("jobs", "With simulate: people at a time; 0: one for each core.", "N", "1")
        .option("law", "With simulate: exact or published, whatever the experiment sets.", "NAME")
        .option("faces", "With simulate: a folder of faces' contours, named PERSON_EXPRESSION.svg.", "DIR")
        .option("device", "With simulate: pad, stick, falcon, 2diy or mouse, as the program knows them.",
                "NAME")
        .option("rate", "With simulate: the device's rate; 1000 where no device says another.", "HZ")
        .option("delay", "With simulate: ticks between a force and its acting; 0 where no device says more.",
                "N")
        .option("max-force",
                "With simulate: the person's limit; without it no pull is cut that the device can give.", "N")
        .option("led", "With simulate: the guided tour brings the finger to each start.")
        .option("blend", "With simulate and the exact law: turns the force over a disc of this radius.", "MM")
        .option("corner-cue", "With simulate and the exact law: a short tick at corners.");
}

namespace {

/// What a line asks of simulated people.
struct SimulationOrder {
    Experiment experiment;
    SimulatedBench bench;
    std::optional<FacesInFolder> faces;
    int participants = 1, jobs = 1;
    std::uint64_t seed = 1;
};

/// The order, or the verb's exit code.
std::optional<int> take_order(const VerbLine& line, const std::filesystem::path& file,
                              SimulationOrder& order) {
    if (!line.has("out"))
        return wrong_usage("study", "--out DIR is missing.");
    const auto participants = line.whole("participants", 1, 10'000);
    const auto seed = line.whole("seed", 0, 1'000'000'000);
    const auto jobs = line.whole("jobs", 0, most_jobs);
    if (!participants || !seed || !jobs)
        return wrong_usage("study", !participants ? participants.error()
                                    : !seed       ? seed.error()
                                                  : jobs.error());
    const auto bench = bench_of(line);
    if (!bench)
        return wrong_usage("study", bench.error());
    auto experiment = experiment_of(file);
    if (!experiment)
        return refused(experiment.error());
    if (line.has("law")) {
        const std::string law = line.text("law").toStdString();
        if (!law_named(law))
            return wrong_usage("study", "--law is exact or published, not \"" + law + "\".");
        if (const std::string problem = set_law(*experiment, law); !problem.empty())
            return wrong_usage("study", problem);
    }
    if (line.has("faces")) {
        auto read = FacesInFolder::read(line.text("faces").toStdString());
        if (!read)
            return refused(read.error());
        order.faces = std::move(*read);
    }
    order.experiment = std::move(*experiment);
    order.bench = *bench;
    order.participants = *participants;
    order.jobs = *jobs > 0 ? *jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    order.seed = static_cast<std::uint64_t>(*seed);
    return std::nullopt;
}

/// `before` studies of `all` are done.
Result<SimulatedStudy> carry_out(const VerbLine& line, const SimulationOrder& order,
                                 const std::filesystem::path& folder, std::size_t before, std::size_t all) {
    LongWork::step("opening the study");
    auto writer = StudyWriter::open(folder, order.experiment, {order.seed, true},
                                    machine_of(order.bench, line.text("device").toStdString()));
    if (!writer)
        return Error{writer.error()};
    for (const std::string& remark : (*writer)->remarks())
        say(remark);
    LongWork::step("simulating people");
    return simulate_study(
        **writer, 1, order.participants, order.bench, order.faces ? &*order.faces : nullptr, order.jobs,
        [&](std::size_t done, std::size_t planned) {
            LongWork::share(
                (static_cast<double>(before) + static_cast<double>(done) / static_cast<double>(planned)) /
                static_cast<double>(all));
        },
        [] { return LongWork::stop_asked().load(); });
}

QJsonArray json_of(const std::vector<ComparedResult>& results) {
    QJsonArray rows;
    for (const ComparedResult& result : results)
        rows.append(QJsonObject{{"what", QString::fromStdString(subject_words(result.published))},
                                {"published", QString::fromStdString(published_words(result.published))},
                                {"mean", result.mean},
                                {"least", result.least},
                                {"most", result.most},
                                {"studies", static_cast<int>(result.ours.size())},
                                {"alike", result.alike}});
    return rows;
}

} // namespace

int simulate_study_verb(const VerbLine& line, const std::filesystem::path& file) {
    SimulationOrder order;
    if (const auto ended = take_order(line, file, order))
        return *ended;
    const auto study = carry_out(line, order, line.text("out").toStdString(), 0, 1);
    if (LongWork::stop_asked())
        return LongWork::stop_code();
    if (!study)
        return refused(study.error());
    tell(line, order.experiment, order.participants, *study);
    return exit_done;
}

int replicate_study_verb(const VerbLine& line, const std::filesystem::path& file) {
    SimulationOrder order;
    if (const auto ended = take_order(line, file, order))
        return *ended;
    const auto seeds = line.whole("seeds", 1, 1000);
    if (!seeds)
        return wrong_usage("study", seeds.error());
    if (std::ranges::none_of(published_results(), [&](const PublishedResult& result) {
            return result.experiment == order.experiment.name;
        }))
        return refused("Nothing was published of the experiment " + order.experiment.name + ".");
    const std::filesystem::path out = line.text("out").toStdString();
    std::vector<StudyReport> reports;
    const std::uint64_t first = order.seed;
    for (int i = 0; i < *seeds; ++i) {
        order.seed = first + static_cast<std::uint64_t>(i);
        const std::filesystem::path folder = out / ("seed-" + std::to_string(order.seed));
        const auto done =
            carry_out(line, order, folder, static_cast<std::size_t>(i), static_cast<std::size_t>(*seeds));
        if (LongWork::stop_asked())
            return LongWork::stop_code();
        if (!done)
            return refused(done.error());
        const auto study = read_study(folder);
        if (!study)
            return refused(study.error());
        auto report = report_on(*study);
        if (!report)
            return refused(report.error());
        for (const std::string& remark : done->remarks)
            say(remark);
        reports.push_back(std::move(*report));
    }
    LongWork::step("writing the comparison");
    if (const std::string problem = write_comparison(out, reports); !problem.empty())
        return refused(problem);
    const auto compared = compared_results(reports);
    if (line.has("json"))
        print_json({{"experiment", QString::fromStdString(order.experiment.name)},
                    {"studies", *seeds},
                    {"participants", order.participants},
                    {"published", json_of(compared)}});
    else
        for (const ComparedResult& result : compared)
            print("%s: published %s; here %s; %s\n", subject_words(result.published).c_str(),
                  published_words(result.published).c_str(), our_words(result).c_str(),
                  result.alike ? "alike" : "not alike");
    return exit_done;
}

} // namespace tp
