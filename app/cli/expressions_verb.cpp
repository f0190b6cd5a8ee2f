// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.hpp"
#include "app/cli/expression_faces.hpp"
#include "app/cli/expression_labels.hpp"
#include "app/cli/expression_report.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "core/files/durable_file.hpp"
#include "core/study/expression_trial.hpp"

#include <algorithm>
#include <cstdio>

namespace tp {

namespace {

/// The model as core/study/expression_observer.inc holds it.
QByteArray rows_of(const ExpressionObserver::Model& model) {
    QByteArray rows = "// SPDX-License-" // in two pieces, so that it is not taken for this file's own
                      "Identifier: Apache-2.0\n";
    for (std::size_t i = 0; i < cue_count; ++i) {
        QByteArray means;
        for (const double mean : model[i].means)
            means += (means.isEmpty() ? "" : ", ") + QByteArray::number(mean, 'f', 2);
        rows += "    {" + QByteArray::number(model[i].spread, 'f', 2) + ", {" + means + "}}, // " +
                cue_kinds[i].name + "\n";
    }
    return rows;
}

class ExpressionsVerb {
public:
    ExpressionsVerb(const VerbLine& line, const FingerTouch& touch) : line_(line), touch_(touch) {
        report_.choices = line.has("with-neutral") ? choices_with_neutral : paper_choices;
    }

    int run() {
        const std::string problem = result();
        if (!problem.empty())
            say_problem(problem);
        return problem.empty() && good_ ? exit_done : exit_bad_input;
    }

private:
    /// A sentence where nothing can go on; else empty.
    std::string result() {
        if (line_.has("out"))
            if (const std::string problem = line_.make_folder("out"); !problem.empty())
                return problem;
        if (line_.has("labels")) {
            auto labels = ExpressionLabels::read(line_.text("labels").toStdString());
            if (!labels)
                return labels.error();
            labels_ = std::move(labels).value();
        }
        ExpressionMeter meter(!line_.has("uncorrected"));
        std::size_t number = 0;
        for (const QString& name : line_.arguments()) {
            LongWork::item(name.toStdString(), ++number, static_cast<std::size_t>(line_.arguments().size()));
            const auto measured = meter.measure(name.toStdString());
            if (!measured)
                return measured.error();
            take(name.toStdString(), *measured);
        }
        if (line_.has("learn"))
            if (const std::string problem = learn(line_.text("learn")); !problem.empty())
                return problem;
        if (const std::string problem = choose_observers(); !problem.empty())
            return problem;
        judge();
        return tell();
    }

    void take(const std::string& photo, const MeasuredFile& measured) {
        if (!measured.problem.empty())
            trouble(measured.problem, photo);
        const ExpressionLabel label = labels_.of(photo);
        if (label.shown && measured.faces.size() > 1)
            trouble("It shows several faces, so that its expression is nobody's and counts in no table.",
                    photo);
        for (std::size_t i = 0; i < measured.faces.size(); ++i) {
            const auto& cues = measured.faces[i];
            if (!cues) {
                trouble(cues.error(), photo);
                continue;
            }
            JudgedFace face;
            face.photo = photo;
            face.number = static_cast<int>(i) + 1;
            face.person = label.person;
            if (measured.faces.size() == 1)
                face.shown = label.shown;
            face.cues = *cues;
            report_.faces.push_back(std::move(face));
        }
    }

    std::vector<ExpressionExample> examples() const {
        std::vector<ExpressionExample> known;
        for (const JudgedFace& face : report_.faces)
            if (face.shown)
                known.push_back({face.person, *face.shown, face.cues});
        return known;
    }

    std::string learn(const QString& name) const {
        const auto observer = ExpressionObserver::learned_from(examples());
        if (!observer)
            return observer.error();
        const auto file = line_.output_file(name);
        if (!file)
            return file.error();
        const ForeignFolder held = held_around(*file);
        const std::string reason = replace_file(*file, rows_of(observer->model()).toStdString());
        return reason.empty() ? reason
                              : "What was learned cannot be written to " + name.toStdString() + ": " + reason;
    }

    /// Who judges whom: the built-in observer, or one that has not seen the person.
    std::string choose_observers() {
        if (!line_.has("across-people"))
            return {};
        const auto known = examples();
        if (known.empty())
            return "No face has a label to learn from: name files PERSON_EXPRESSION.jpg, or give --labels.";
        auto of_all = ExpressionObserver::learned_from(known);
        if (!of_all)
            return of_all.error();
        auto by_others = observers_by_others(known, report_.choices);
        if (!by_others)
            return by_others.error();
        observer_ = std::move(of_all).value();
        by_others_ = std::move(by_others).value();
        return {};
    }

    const ExpressionObserver& observer_for(const std::string& person) const {
        const auto own = by_others_.find(person);
        return own == by_others_.end() ? observer_ : own->second;
    }

    void judge() {
        ExpressionTrial trial;
        trial.choices = report_.choices;
        std::size_t number = 0;
        for (JudgedFace& face : report_.faces) {
            LongWork::item("judging " + face.photo, ++number, report_.faces.size());
            const ExpressionObserver& observer = observer_for(face.person);
            face.exact = observer.judge(face.cues, trial.choices);
            trial.touch.reset();
            const ExpressionShares exact = answers_to(face.cues, observer, trial);
            trial.touch = touch_;
            face.felt = answers_to(face.cues, observer, trial);
            ++trial.seed; // no two faces are felt with the same errors
            if (face.shown) {
                report_.exact.add(*face.shown, exact);
                report_.felt.add(*face.shown, face.felt);
            }
        }
    }

    std::string tell() const {
        for (const JudgedFace& face : report_.faces)
            if (line_.has("json"))
                print("%s\n", json_line(face, report_.choices).constData());
            else
                print("%s\n", line_about(face).c_str());
        const bool labelled = std::any_of(report_.faces.begin(), report_.faces.end(),
                                          [](const JudgedFace& face) { return face.shown.has_value(); });
        if (labelled) {
            char felt[64];
            std::snprintf(felt, sizeof felt, "felt to %g mm, %%", touch_.noise_mm);
            print_to(line_.has("json") ? stderr : stdout, "\n%s\n%s",
                     words_for(report_.exact, report_.choices, "exact, %").c_str(),
                     words_for(report_.felt, report_.choices, felt).c_str());
        }
        if (!line_.has("out"))
            return {};
        const ForeignFolder held = held_around(path_given(line_.text("out")) / "name");
        return write_expressions(path_given(line_.text("out")), report_).error();
    }

    void trouble(const std::string& sentence, const std::string& photo) {
        say_problem(sentence, photo);
        good_ = false;
    }

    const VerbLine& line_;
    FingerTouch touch_;
    ExpressionLabels labels_;
    ExpressionObserver observer_ = ExpressionObserver::built_in();
    std::map<std::string, ExpressionObserver> by_others_; ///< by person
    ExpressionReport report_;
    bool good_ = true;
};

} // namespace

int expressions_verb(const QStringList& words) {
    VerbLine line(
        "expressions",
        "Says what the contours of faces tell a finger of their expression: an observer who knows only\n"
        "these names each face as smiling, surprised, sad or angry, from exact contours and as a finger\n"
        "feels them. Faces whose expression is known, from --labels or a name like anna_sad.jpg, are\n"
        "counted in a confusion table beside what people named rightly (Lim, Yoo, Choi 2019).");
    line.option("labels", "CSV with the columns photo, expression and, if wanted, person.", "FILE")
        .option("out", "Writes the tables and the faces as expressions.csv and cues.csv.", "DIR")
        .option("noise", "How exactly a finger feels a place, mm (standard deviation); 1 unless told.", "MM",
                "1")
        .option("eyes", "Between the outer corners of the eyes on the surface, mm; 100 unless told.", "MM",
                "100")
        .option("with-neutral", "Lets the observer answer \"neutral\" too.")
        .option("across-people",
                "Judges each person's faces by what the labelled faces of all the others given teach, "
                "in place of what the program has learned from drawn people.")
        .output("learn", "Writes what the labelled faces teach, as the program's source holds it.", "FILE")
        .option("uncorrected", "Leaves out what a person mended in PHOTO.contours.svg beside a photograph.")
        .option("json", "Writes a line of JSON for each face.")
        .argument("FILE", "A photograph (JPEG, PNG or WebP), or contours (SVG) to be taken as they are.",
                  "FILE...");
    if (const auto ended = line.parse(words, 1, 1'000'000))
        return *ended;
    FingerTouch touch;
    for (const auto& [name, value] : {std::pair{"noise", &touch.noise_mm}, {"eyes", &touch.eyes_mm}}) {
        const auto given = line.positive(name);
        if (!given)
            return wrong_usage("expressions", given.error());
        *value = *given;
    }
    return ExpressionsVerb(line, touch).run();
}

} // namespace tp
