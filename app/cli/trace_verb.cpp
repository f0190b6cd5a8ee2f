// SPDX-License-Identifier: Apache-2.0
#include "app/cli/guidance_options.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/verbs.hpp"
#include "app/photo/picture/field_picture.hpp"
#include "app/photo/picture/picture_file.hpp"
#include "core/files/durable_file.hpp"
#include "core/servo/servo_loop.hpp"
#include "core/study/exploring_finger.hpp"
#include "device/simulated/simulated_device.hpp"

#include <QDir>
#include <QTextStream>

namespace tp {

namespace {

constexpr double record_every = 0.010; ///< s between rows of the trace
constexpr double say_every = 30.0;     ///< s of simulated time between two lines of progress

struct Trace {
    std::vector<ServoSnapshot> rows;
    double seconds = 0.0;
    bool whole = false; ///< the finger searched the whole surface before the time was over
};

/// A simulated finger on the simulated device, driven by the same servo loop as a real one, in simulated
/// time.
Trace explore(const Scene& scene, std::unique_ptr<HapticScene> haptic, double longest) {
    VirtualClock clock;
    SimulatedDevice device(scene.width_mm, scene.height_mm);
    const Capabilities can = *device.open();
    ServoLoop loop(device, can, clock, ServoSettings{});
    ExploringFinger hand(scene.surface());
    device.place_finger(hand.start());
    const GuidanceLaw& law = *haptic->law;
    const double band = haptic->profile.band();
    loop.render(std::move(haptic));
    loop.engage();

    Trace trace;
    double next_row = 0.0;
    double next_word = say_every;
    while (!hand.finished() && clock.now() < longest && !LongWork::stop_asked()) {
        LongWork::share(clock.now() / longest);
        clock.sleep_until(clock.now() + 0.001);
        loop.tick();
        const ServoSnapshot view = loop.snapshot();
        device.move_pointer(hand.step(view.finger(), view.force(), 0.001));
        if (clock.now() >= next_row) {
            trace.rows.push_back(view);
            if (!(view.distance < band)) { // the servo looks there now and then only
                const Guidance guidance = law.at(view.finger());
                trace.rows.back().distance = guidance.distance;
                trace.rows.back().contour = guidance.contour;
            }
            next_row += record_every;
        }
        if (clock.now() >= next_word) {
            say(QStringLiteral("%1 s of simulated time").arg(next_word).toStdString());
            next_word += say_every;
        }
    }
    trace.seconds = clock.now();
    trace.whole = hand.finished();
    return trace;
}

/// A name as one field of a CSV (RFC 4180).
QString csv_field(const std::string& name) {
    QString text = QString::fromStdString(name);
    if (text.contains(QLatin1Char(',')) || text.contains(QLatin1Char('"')) ||
        text.contains(QLatin1Char('\n')))
        text = QLatin1Char('"') + text.replace("\"", "\"\"") + QLatin1Char('"');
    return text;
}

std::string write_csv(const QString& file, const Trace& trace, const std::vector<std::string>& names) {
    QString text;
    QTextStream rows(&text);
    rows << "t,x,y,fx,fy,distance,contour\n";
    for (const ServoSnapshot& row : trace.rows)
        rows << QString::asprintf("%.3f,%.4f,%.4f,%.5f,%.5f,%.4f,", row.time, row.x, row.y, row.fx, row.fy,
                                  row.distance)
             << (row.contour < 0 ? QString() : csv_field(names[static_cast<std::size_t>(row.contour)]))
             << '\n';
    const std::string reason = replace_file(file.toStdString(), text.toStdString());
    return reason.empty() ? reason : "The trace cannot be written: " + reason;
}

} // namespace

int trace_verb(const QStringList& words) {
    VerbLine line(
        "trace",
        "Lets a simulated finger without eyes explore a scene in simulated time: it searches lane by\n"
        "lane and follows what it feels. Writes trace.csv (t, x, y, fx, fy, distance, contour; s, mm\n"
        "in the surface frame, N) and trace.png, the force field with the finger's way.");
    line.option("scene", "The scene.", "SCENE.svg")
        .option("out", "Folder for the results; created if it is missing.", "DIR")
        .option("seconds", "Longest simulated time.", "s", "600")
        .option("hold", "Stays with a contour until another is nearer by this much.", "mm");
    add_guidance_options(line);
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    if (!line.has("scene") || !line.has("out"))
        return wrong_usage("trace", "--scene SCENE.svg and --out DIR are both needed.");
    auto options = guidance_options(line);
    if (options && line.has("hold")) {
        const auto hold = line.positive("hold");
        if (!hold)
            return wrong_usage("trace", hold.error());
        options->continuity.hold_mm = *hold;
    }
    const auto longest = line.positive("seconds");
    if (!options || !longest)
        return wrong_usage("trace", options ? longest.error() : options.error());
    auto loaded = load_scene(line.text("scene"), *options);
    if (!loaded) {
        say_problem(loaded.error(), line.text("scene").toStdString());
        return exit_bad_input;
    }
    const QDir folder(line.text("out"));
    if (const std::string problem = line.make_folder("out"); !problem.empty()) {
        say_problem(problem);
        return exit_bad_input;
    }

    const auto to_draw =
        make_haptic_scene(loaded->scene, options->profile, options->law, options->continuity);
    const std::vector<std::string> names = loaded->haptic->flat.names;
    LongWork::step("exploring");
    const Trace trace = explore(loaded->scene, std::move(loaded->haptic), *longest);
    if (LongWork::stop_asked())
        return LongWork::stop_code();
    LongWork::step("drawing the way over the force field");
    std::vector<Vec2> way;
    for (const ServoSnapshot& row : trace.rows)
        way.push_back(row.finger());
    const ForeignFolder held = held_around(path_given(folder.filePath("name")));
    std::string problem = write_csv(folder.filePath("trace.csv"), trace, names);
    if (problem.empty())
        problem = write_image(folder.filePath("trace.png").toStdString(),
                              draw_force_field(**to_draw, loaded->scene.surface(), 5.0, way,
                                               LongWork::stop_token(), LongWork::share))
                      .error();
    if (!problem.empty()) {
        say_problem(problem);
        return exit_bad_input;
    }
    say(QStringLiteral("%1 rows over %2 s of simulated time in %3%4")
            .arg(trace.rows.size())
            .arg(trace.seconds, 0, 'f', 1)
            .arg(folder.filePath("trace.csv"),
                 trace.whole ? "" : "; the time was over before the whole surface was searched")
            .toStdString());
    return exit_done;
}

} // namespace tp
