// SPDX-License-Identifier: Apache-2.0
#include "app/cli/device_measures.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/input_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/verbs.hpp"
#include "app/parts/devices/calibration_steps.hpp"
#include "app/parts/devices/joystick_measuring.hpp"
#include "core/files/file_name.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/calibration_file.hpp"
#include "device/hid_pid/joystick_scale_file.hpp"
#include "device/registry.hpp"

#include <QStandardPaths>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <future>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace tp {

namespace {

constexpr double fault_lasts_s = 0.5; ///< one that heals sooner ends nothing

/// The device's own sentence, or that of the fault.
std::string what_is_wrong(Fault fault, const ForceDevice& device) {
    return fault == Fault::motors_off && !device.complaint().empty() ? device.complaint()
                                                                     : std::string(sentence(fault));
}

/// "250x150", in mm.
Result<Vec2> screen_size(const QString& text) {
    const QStringList parts = text.split('x');
    const Vec2 size = parts.size() == 2 ? Vec2(parts[0].toDouble(), parts[1].toDouble()) : Vec2(0.0);
    if (!(size.x >= 50.0 && size.x <= 2000.0 && size.y >= 50.0 && size.y <= 2000.0))
        return Error{"--screen is the screen's width and height in mm, such as 250x150."};
    return size;
}

/// Holds each mark in turn, without any force on the device; a fault ends it with its sentence.
Result<Calibration> calibrated(ServoLoop& loop, const ForceDevice& device, Vec2 screen, double inset) {
    const PersonsTurn turn;
    const Rect area{{0.0, -screen.y}, {screen.x, 0.0}};
    const Vec2 marks[] = {{inset, -inset},
                          {screen.x - inset, -inset},
                          {screen.x - inset, inset - screen.y},
                          {inset, inset - screen.y}};
    const char* const corners[] = {"top left", "top right", "bottom right", "bottom left"};
    CalibrationSteps steps(area);
    SteadyClock clock;
    while (steps.mark() != CalibrationSteps::all_touched) {
        const int mark = steps.mark();
        say("Put the knob on the " + std::string(corners[mark]) + " mark, keep it still, and press Enter.");
        std::string line;
        if (!next_line(std::cin, line))
            return Error{"The calibration was cancelled. Nothing was changed."};
        steps.lift();
        double well_at = clock.now();
        do {
            std::this_thread::sleep_for(std::chrono::milliseconds(16));
            const ServoSnapshot seen = loop.snapshot();
            const double now = clock.now();
            if (seen.fault == Fault::none)
                well_at = now;
            else if (disables(seen.fault) || now - well_at > fault_lasts_s)
                return Error{what_is_wrong(seen.fault, device)};
            if (seen.ticks > 0 && seen.fault == Fault::none)
                steps.sample(marks[mark], seen.finger(), now);
        } while (steps.mark() == mark);
    }
    return steps.calibration();
}

/// Lets a stick be measured, the grams read from standard input.
Result<JoystickScale> measured(ServoLoop& loop, ForceDevice& device) {
    const PersonsTurn turn;
    const Error ended{"The measurement was cancelled. Nothing was changed."};
    JoystickMeasuring measuring(device, loop);
    SteadyClock clock;
    std::string line;
    say(measuring.words().toStdString() + " Press Enter to begin.");
    if (!next_line(std::cin, line))
        return ended;
    double well_at = clock.now();
    const auto step = [&measuring] { return measuring.trial().step(); };
    /// Lets time pass; the sentence that ends the measurement, where there is one.
    const auto pass = [&](double seconds) -> std::string {
        for (const double until = clock.now() + seconds; clock.now() < until;) {
            std::this_thread::sleep_for(std::chrono::milliseconds(16));
            const Fault fault = loop.snapshot().fault;
            if (fault == Fault::none)
                well_at = clock.now();
            else if (disables(fault) || clock.now() - well_at > fault_lasts_s)
                return what_is_wrong(fault, device);
            measuring.poll(clock.now());
            if (step() == JoystickTrial::Step::failed)
                return measuring.words().toStdString();
        }
        return {};
    };
    while (step() == JoystickTrial::Step::right || step() == JoystickTrial::Step::away)
        if (const std::string why = pass(0.1); !why.empty())
            return Error{why};
    say(measuring.words().toStdString());
    std::future<bool> typing;
    while (step() == JoystickTrial::Step::weigh) {
        typing = std::async(std::launch::async, [&line] { return next_line(std::cin, line); });
        while (typing.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            if (const std::string why = pass(0.1); !why.empty()) {
                say(why + " Press Enter.");
                typing.wait();
                return Error{"Nothing was changed."};
            }
        if (!typing.get())
            return ended;
        bool number = false;
        const double grams = QString::fromStdString(line).trimmed().replace(',', '.').toDouble(&number);
        const Result<bool> done = measuring.weighed(number ? grams : -1.0, clock.now());
        if (!done)
            say(done.error());
        else if (!*done)
            say("That is too little to be read well. The stick pulls twice as strongly now: weigh again.");
    }
    return measuring.trial().assumed();
}

} // namespace

int calibrate_device(const QStringList& words) {
    VerbLine line(
        "devices calibrate",
        "Finds out where a device lies on the screen: its knob is put on a mark at each corner, one\n"
        "after the other. What is found is saved for the pages; no force is on the device.");
    line.argument("name", "The device's name, as devices lists it.", "NAME");
    line.option("screen", "The screen's width and height in mm.", "WxH")
        .option("inset", "How far each mark is from both edges, in mm.", "mm", "10")
        .option("file", "Where to save it instead of with the settings of TouchPhoto.", "FILE");
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    const auto screen = screen_size(line.text("screen"));
    const auto inset = line.positive("inset");
    if (!screen || !inset)
        return wrong_usage("devices calibrate", screen ? inset.error() : screen.error());
    const std::string name = line.arguments().first().toStdString();
    auto made = device_named(name);
    if (!made)
        return refused(made.error());
    const std::unique_ptr<ForceDevice> device = std::move(made).value();
    const auto can = device->open();
    if (!can)
        return refused(can.error());
    SteadyClock clock;
    ServoSettings settings = settings_for_reading({});
    settings.rate = can->rate;
    ServoLoop loop(*device, *can, clock, settings);
    loop.start();
    const auto found = calibrated(loop, *device, *screen, *inset);
    loop.stop();
    if (!found)
        return refused(found.error());
    if (found->residual_mm > most_residual_mm)
        return refused(
            QString(
                "The calibration misses its marks by %1 mm, and at most %2 mm are allowed. Make sure that "
                "the device "
                "does not slip, keep the knob still on each mark, and calibrate again. Nothing was changed.")
                .arg(found->residual_mm, 0, 'f', 1)
                .arg(most_residual_mm, 0, 'f', 1)
                .toStdString());
    if (!is_plausible(found->device_to_surface))
        return refused("The device's millimetres are not the screen's. Check that --screen is right, and "
                       "calibrate again. Nothing "
                       "was changed.");
    const QString usual = QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
                          "/touchphoto/calibrations.txt";
    const std::filesystem::path file =
        path_named((line.has("file") ? line.text("file") : usual).toStdString());
    const std::string key = can->serial_number.empty() ? name : can->serial_number;
    if (const std::string why = keep_calibration(file, key, *found); !why.empty())
        return refused(why);
    print("residual    %.2f mm\nsamples     %zu\nkept for    %s\n", found->residual_mm, found->used,
          key.c_str());
    return exit_done;
}

int measure_joystick(const QStringList& words) {
    VerbLine line("devices measure",
                  "Finds out which way a force stick pulls and how strong it is, with a kitchen scale or a\n"
                  "luggage scale. What is found is saved for the pages.");
    line.argument("name", "The stick's name, as devices lists it.", "NAME");
    line.option("file", "Where to save it instead of with the settings of TouchPhoto.", "FILE");
    if (const auto ended = line.parse(words, 1, 1))
        return *ended;
    const std::string name = line.arguments().first().toStdString();
    auto made = device_named(name);
    if (!made)
        return refused(made.error());
    const std::vector<ListedDevice> there = list_devices();
    const auto listed = std::ranges::find(there, name, &ListedDevice::name);
    if (listed == there.end() || listed->scale_key.empty())
        return refused("This device knows its own force; only force sticks need measuring.");
    const std::unique_ptr<ForceDevice> device = std::move(made).value();
    const auto can = device->open();
    if (!can)
        return refused(can.error());
    SteadyClock clock;
    ServoSettings settings;
    settings.rate = can->rate;
    ServoLoop loop(*device, *can, clock, settings);
    loop.start();
    const auto found = measured(loop, *device);
    loop.stop();
    if (!found)
        return refused(found.error());
    const std::filesystem::path file =
        line.has("file") ? path_named(line.text("file").toStdString()) : joystick_scale_file();
    if (const std::string why = keep_joystick_scale(file, listed->scale_key, *found); !why.empty())
        return refused(why);
    print("whole force %.2f N\nsigns       %+g %+g\nkept for    %s\n", found->newtons_at_full, found->sign.x,
          found->sign.y, listed->scale_key.c_str());
    return exit_done;
}

} // namespace tp
