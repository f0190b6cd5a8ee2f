// SPDX-License-Identifier: Apache-2.0
#include "app/cli/device_measures.hpp"
#include "app/cli/guidance_options.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/touch_trial.hpp"
#include "app/cli/verbs.hpp"
#include "app/parts/feedbackd/touch_outputs.hpp"
#include "core/files/whole_file.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/force_pad/force_pad.hpp"
#include "device/recording/recording_device.hpp"
#include "device/recording/replay_device.hpp"
#include "device/registry.hpp"

#include <QJsonObject>

#include <chrono>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <thread>

namespace tp {

namespace {

constexpr std::size_t largest_recording = std::size_t{1} << 30;

int list(const QStringList& words) {
    VerbLine line("devices",
                  "Lists the force devices that can be used now, then what a bare finger can feel. See also\n"
                  "devices test, home, calibrate, measure, record, replay and tick.");
    line.option("json", "One JSON object per line: name, about, serial_number, interface, means, pad.");
    if (const auto ended = line.parse(words, 0, 0))
        return *ended;
    for (const ListedDevice& device : list_devices())
        if (line.has("json"))
            print_json({{"name", QString::fromStdString(device.name)},
                        {"about", QString::fromStdString(device.about)},
                        {"serial_number", QString::fromStdString(device.serial_number)},
                        {"interface", QString::fromStdString(device.interface)},
                        {"means", "force"},
                        {"pad", false}});
        else
            print("%-20s %s\n", device.name.c_str(), device.about.c_str());
    for (const ListedTouchOutput& output : touch_outputs_here())
        if (line.has("json"))
            print_json({{"name", QString::fromStdString(output.name)},
                        {"about", QString::fromStdString(output.about)},
                        {"serial_number", QString::fromStdString(output.serial_number)},
                        {"interface", ""},
                        {"means", word_of(output.means)},
                        {"pad", output.is_pad}});
        else
            print("%-20s %s (%s)\n", output.name.c_str(), output.about.c_str(), word_of(output.means));
    return exit_done;
}

/// Ticks a loop in real time for a while, and calls `meanwhile` about every 50 ms; the faults that came up.
template <typename Meanwhile>
std::set<Fault> run_for(double seconds, ServoLoop& loop, Meanwhile meanwhile) {
    std::set<Fault> faults;
    SteadyClock clock;
    loop.start();
    for (const double begun = clock.now(); clock.now() - begun < seconds && !LongWork::stop_asked();) {
        LongWork::share((clock.now() - begun) / seconds);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        meanwhile();
        faults.insert(loop.snapshot().fault);
    }
    loop.stop();
    faults.erase(Fault::none);
    return faults;
}

int test(const QStringList& words) {
    VerbLine line("devices test",
                  "Reads a device for a while without any force on it: what it reports of itself, how often\n"
                  "a new place comes, and what is wrong.");
    line.argument("name", "The device's name, as devices lists it.", "NAME");
    line.option("seconds", "How long to read, in seconds.", "s", "2");
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    const auto seconds = line.positive("seconds");
    if (!seconds)
        return wrong_usage("devices test", seconds.error());
    auto made = device_named(line.arguments().first().toStdString());
    if (!made)
        return refused(made.error());
    const std::unique_ptr<ForceDevice> device = std::move(made).value();
    const auto can = device->open();
    if (!can)
        return refused(can.error());
    print("device      %s\nserial      %s\nforce       %g N, continuous %g N\nresolution  %g mm\nrate  "
          "      %g Hz\n",
          can->name.c_str(), can->serial_number.c_str(), can->max_force, can->continuous_force,
          can->resolution, can->rate);
    SteadyClock clock;
    ServoSettings settings;
    settings.rate = can->rate;
    ServoLoop loop(*device, *can, clock, settings);
    std::string complaint;
    LongWork::step("reading " + can->name);
    const auto* const pad = dynamic_cast<const ForcePad*>(device.get());
    const std::set<Fault> faults = run_for(*seconds, loop, [&] { complaint = device->complaint(); });
    const ServoSnapshot last = loop.snapshot();
    print("ticks       %llu\nplace       %.2f %.2f mm\n", static_cast<unsigned long long>(last.ticks), last.x,
          last.y);
    if (pad != nullptr)
        print("bad frames  %llu\n", static_cast<unsigned long long>(pad->bad_frames()));
    for (const Fault fault : faults)
        say_problem(fault == Fault::motors_off && !complaint.empty() ? complaint : sentence(fault));
    if (LongWork::stop_asked())
        return LongWork::stop_code();
    return faults.empty() ? exit_done : exit_bad_input;
}

int home(const QStringList& words) {
    VerbLine line("devices home", "Tells a force pad that its knob stands on the mark now.");
    line.argument("name", "The pad's name, as devices lists it.", "NAME");
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    auto made = device_named(line.arguments().first().toStdString());
    if (!made)
        return refused(made.error());
    ForceDevice& device = *made.value();
    if (const auto can = device.open(); !can)
        return refused(can.error());
    const auto homed = device.home();
    return homed ? exit_done : refused(homed.error());
}

int record(const QStringList& words) {
    VerbLine line("devices record",
                  "Writes down what passes between the servo and a device (device/recording/FORMAT.md).");
    line.argument("file", "The recording; it must not exist.", "FILE");
    line.option("device", "Its name, as devices lists it.", "NAME", "simulated");
    line.option("seconds", "How long to record, in seconds.", "s", "10")
        .option("scene", "The scene to be felt; without it there is no force.", "SCENE.svg");
    add_guidance_options(line);
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    const auto seconds = line.positive("seconds");
    if (!seconds)
        return wrong_usage("devices record", seconds.error());
    const auto options = guidance_options(line);
    if (!options)
        return wrong_usage("devices record", options.error());
    std::unique_ptr<HapticScene> haptic;
    if (line.has("scene")) {
        auto loaded = load_scene(line.text("scene"), *options);
        if (!loaded) {
            say_problem(loaded.error(), line.text("scene").toStdString());
            return exit_bad_input;
        }
        haptic = std::move(loaded->haptic);
    }
    auto made = device_named(line.text("device").toStdString());
    if (!made)
        return refused(made.error());
    const auto recorder =
        std::make_unique<RecordingDevice>(*made.value(), line.arguments().first().toStdString());
    const auto can = recorder->open();
    if (!can)
        return refused(can.error());
    SteadyClock clock;
    ServoLoop loop(*recorder, *can, clock, {});
    if (haptic) {
        loop.render(std::move(haptic));
        loop.engage();
    }
    bool written = true;
    LongWork::step("recording " + can->name);
    const std::set<Fault> faults = run_for(*seconds, loop, [&] { written = recorder->flush() && written; });
    written = recorder->flush() && written;
    for (const Fault fault : faults)
        say(sentence(fault));
    if (written && LongWork::stop_asked()) {
        say("Stopped; the recording is whole as far as it goes.");
        return LongWork::stop_code();
    }
    return written
               ? int{exit_done}
               : refused(
                     "The recording is not whole, because the disk is full or this computer was too busy.");
}

int replay_verb(const QStringList& words) {
    VerbLine line(
        "devices replay",
        "A recording as CSV: now_s, fresh, x_mm, y_mm, fx_n, fy_n, lost, motors_off, refused. With\n"
        "--scene it goes through the servo again instead, and by how much the forces differ is\n"
        "said.");
    line.argument("file", "The recording.", "FILE");
    line.option("scene", "The scene that was felt.", "SCENE.svg");
    add_guidance_options(line);
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    const auto options = guidance_options(line);
    if (!options)
        return wrong_usage("devices replay", options.error());
    LongWork::step("reading " + line.arguments().first().toStdString());
    const auto bytes = read_whole(line.arguments().first().toStdString(), largest_recording);
    if (!bytes)
        return refused(bytes.error());
    const auto recording = parse_recording(*bytes);
    if (!recording) {
        say_problem(recording.error(), line.arguments().first().toStdString());
        return exit_bad_input;
    }
    if (recording->bytes_left > 0)
        say("The recording was cut short; its last " + std::to_string(recording->bytes_left) +
            " bytes are left out.");
    if (!line.has("scene")) {
        std::puts("now_s,fresh,x_mm,y_mm,fx_n,fy_n,lost,motors_off,refused");
        for (const RecordedTick& tick : recording->ticks) {
            if (LongWork::stop_asked())
                return LongWork::stop_code();
            print("%.6f,%d,%.6f,%.6f,%.6f,%.6f,%d,%d,%d\n", tick.now, tick.fresh, tick.reading.position.x,
                  tick.reading.position.y, tick.force.x, tick.force.y, tick.lost, tick.motors_off,
                  tick.refused);
        }
        return exit_done;
    }
    auto loaded = load_scene(line.text("scene"), *options);
    if (!loaded) {
        say_problem(loaded.error(), line.text("scene").toStdString());
        return exit_bad_input;
    }
    ReplayDevice device(*recording);
    const auto can = device.open();
    VirtualClock clock;
    if (!recording->ticks.empty())
        clock.sleep_until(recording->ticks.front().now);
    ServoLoop loop(device, *can, clock, {});
    loop.render(std::move(loaded->haptic));
    loop.engage();
    LongWork::step("replaying");
    replay(*recording, loop, clock);
    print("ticks %zu, greatest difference %.9f N\n", device.ticks(), device.greatest_difference());
    return exit_done;
}

} // namespace

int devices_verb(const QStringList& words) {
    const QString first = words.isEmpty() ? QString() : words.first();
    if (first == "test")
        return test(words.mid(1));
    if (first == "home")
        return home(words.mid(1));
    if (first == "calibrate")
        return calibrate_device(words.mid(1));
    if (first == "measure")
        return measure_joystick(words.mid(1));
    if (first == "record")
        return record(words.mid(1));
    if (first == "replay")
        return replay_verb(words.mid(1));
    if (first == "tick")
        return tick_touch_output(words.mid(1));
    return list(words);
}

} // namespace tp
