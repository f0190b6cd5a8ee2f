// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_replay.hpp"

#include "core/files/whole_file.hpp"
#include "core/servo/clock.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/recording/replay_device.hpp"
#include "device/recording/touch_recording.hpp"

#include <cmath>
#include <string>
#include <system_error>
#include <utility>

namespace tp {

namespace {

constexpr std::size_t largest_lab_recording = std::size_t{1} << 30U;
constexpr std::size_t largest_setup = std::size_t{1} << 24U; // 100 000 lines of a tactile map

/// By how much a loop with the setup differs from what was recorded, N.
Result<double> difference(const TouchRecording& recording, const LabSetup& setup, const std::stop_token& stop) {
    Result<std::unique_ptr<HapticScene>> scene = felt_scene(setup.scene, setup.parameters);
    if (!scene)
        return Error{scene.error()};
    ReplayDevice device(recording);
    const Capabilities can = device.open().value();
    VirtualClock clock;
    if (!recording.ticks.empty())
        clock.sleep_until(recording.ticks.front().now);
    ServoLoop loop(device, can, clock, servo_settings(setup.parameters, can.rate, setup.real_device));
    loop.set_max_force(setup.parameters.max_force);
    loop.render(std::move(scene).value());
    loop.engage();
    for (const RecordedTick& tick : recording.ticks) {
        if (stop.stop_requested())
            return Error{"The replay was stopped."};
        clock.sleep_until(tick.now);
        loop.tick();
    }
    return device.greatest_difference();
}

} // namespace

std::filesystem::path setup_file(const std::filesystem::path& recording) {
    return std::filesystem::path(recording).replace_extension(".json");
}

Result<LabReplay> read_replay(const std::filesystem::path& file, const std::stop_token& stop) {
    const Result<std::string> bytes = read_whole(file, largest_lab_recording);
    if (!bytes)
        return Error{bytes.error()};
    const Result<TouchRecording> recording = parse_recording(*bytes);
    if (!recording)
        return Error{file.filename().string() + ": " + recording.error()};
    LabReplay replay;
    replay.rate = recording->device.rate;
    replay.delay_ticks = static_cast<std::size_t>(std::lround(recording->device.delay * recording->device.rate));
    replay.bytes_left = recording->bytes_left;
    replay.ticks.reserve(recording->ticks.size());
    TickSample sample;
    for (const RecordedTick& tick : recording->ticks) {
        sample.time = tick.now;
        if (tick.fresh)
            sample.place = tick.reading.position;
        sample.force = tick.refused ? Vec2(0.0) : tick.force;
        replay.ticks.push_back(sample);
    }
    std::error_code unused;
    const std::filesystem::path beside = setup_file(file);
    if (!std::filesystem::exists(beside, unused))
        return replay;
    const Result<std::string> json = read_whole(beside, largest_setup);
    if (!json)
        return Error{json.error()};
    Result<LabSetup> setup = parse_setup(*json);
    if (!setup)
        return Error{beside.filename().string() + " cannot be used: " + setup.error()};
    const Result<double> differs = difference(*recording, *setup, stop);
    if (!differs)
        return Error{differs.error()};
    replay.greatest_difference = *differs;
    replay.setup = std::move(setup).value();
    return replay;
}

} // namespace tp
