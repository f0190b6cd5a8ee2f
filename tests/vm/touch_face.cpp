// SPDX-License-Identifier: Apache-2.0
// vm_touch_face DEVICE PORTRAIT.svg SNAPSHOTS SESSIONS: what TouchPhoto does with a device, without its
// pages: it waits for the device in the registry, opens it, lets the servo render the portrait through the
// safety chain, and begins anew when the device is lost. Ends with the standard input. What the servo shows
// each millisecond goes to the log SNAPSHOTS.
#include "core/guidance/haptic_scene.hpp"
#include "core/servo/servo_loop.hpp"
#include "device/registry.hpp"
#include "face_touch.hpp"
#include "shared_log.hpp"
#include "touch_session.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <poll.h>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

using namespace tp;

namespace {

constexpr double period = 0.001;           ///< s, of the servo
constexpr std::uint64_t looks_for_end = 8; ///< ticks between them

/// The standard input has ended, which it may do for `wait_ms` yet.
bool told_to_end(int wait_ms) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return ::poll(&input, 1, wait_ms) > 0;
}

/// The device as soon as it is there; nothing when it is time to end.
std::unique_ptr<ForceDevice> awaited(const std::string& name) {
    while (!told_to_end(20))
        for (const ListedDevice& listed : list_devices())
            if (listed.name == name)
                if (auto made = device_named(name))
                    return std::move(made).value();
    return nullptr;
}

/// True where the device was lost.
bool touch(ForceDevice& device, const Scene& face, vm::SharedLog<ServoSnapshot>& snapshots,
           vm::SharedLog<vm::TouchSession>& sessions) {
    const Result<Capabilities> can = device.open();
    if (!can) {
        std::fprintf(stderr, "%s\n", can.error().c_str());
        return true;
    }
    SteadyClock clock;
    ServoLoop loop(device, *can, clock, {});
    auto scene = make_haptic_scene(face);
    loop.render(std::move(scene).value());
    loop.engage();
    loop.start();
    vm::TouchSession session;
    ServoSnapshot last;
    while (!session.lost && (last.ticks % looks_for_end != 0 || !told_to_end(0))) {
        // In the middle between two ticks, so that none is seen twice or not at all.
        clock.sleep_until(std::max(last.time + 1.5 * period, clock.now() + 0.5 * period));
        const ServoSnapshot now = loop.snapshot();
        if (now.ticks != last.ticks)
            snapshots.append(now);
        last = now;
        // Once nothing is pulled any more, as a page does.
        session.lost = now.fault == Fault::device_lost && now.force() == Vec2(0.0);
    }
    loop.stop();
    session.ticks = loop.compute().count();
    session.missed = loop.missed_periods();
    session.latest_s = loop.lateness().max();
    session.compute_p50_s = loop.compute().quantile(0.5);
    session.compute_max_s = loop.compute().max();
    session.real_time = loop.real_time();
    sessions.append(session);
    return session.lost;
}

} // namespace

int main(int count, char** words) {
    if (count != 5) {
        std::fputs("vm_touch_face DEVICE PORTRAIT.svg SNAPSHOTS SESSIONS\n", stderr);
        return 2;
    }
    const auto face = vm::face_of(words[2]);
    vm::SharedLog<ServoSnapshot> snapshots(words[3]);
    vm::SharedLog<vm::TouchSession> sessions(words[4]);
    // The programs lie on another machine's disk, from which no page may come in mid-touch.
    if (!face || !snapshots.good() || !sessions.good() || ::mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
        std::fprintf(stderr, "The touch cannot begin: %s\n", face.error().c_str());
        return 2;
    }
    while (const auto device = awaited(words[1]))
        if (!touch(*device, *face, snapshots, sessions))
            break;
    return 0;
}
