// SPDX-License-Identifier: Apache-2.0
// How long a frame is looked at: aim_eye_bench [PHOTO [SECONDS]]. A simulated hand holds a camera of 1280 x 720 px before the
// photograph (default: a sample) and turns a little; its frames, ten a second of their own clock, are made beforehand.
#include "app/capture/frames/simulated_camera.hpp"
#include "app/capture/seeing/aim_eye.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <vector>

using namespace tp;

namespace {

constexpr double frames_per_s = 10.0;

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double share(const std::vector<double>& sorted, double of_all) {
    return sorted[static_cast<std::size_t>(of_all * static_cast<double>(sorted.size() - 1))];
}

} // namespace

int main(int argc, char** argv) {
    const std::filesystem::path photo =
        argc > 1 ? argv[1] : TOUCHPHOTO_SOURCE "/resources/samples/anna_smiling.jpg";
    const int frames = static_cast<int>((argc > 2 ? std::atof(argv[2]) : 10.0) * frames_per_s);
    SimulatedHold hold;
    hold.frames_per_s = frames_per_s;
    hold.wall = {0.6, 1.0, {0.5, 0.45}};
    auto camera = SimulatedCamera::open(photo, hold);
    if (!camera || frames < 2) {
        std::fprintf(stderr, "%s\n", camera.error().c_str());
        return 1;
    }
    AimEye eye;
    std::vector<double> took;
    std::size_t faces = 0;
    double all = 0.0;
    for (int i = 0; i < frames; ++i) {
        camera->move_to({.pan_deg = 10.0 * i / frames - 5.0});
        const CameraFrame frame = **camera->next();
        const double begin = processor_ms();
        faces += eye.see(frame).faces.size();
        if (i > 0) // the first one makes what is kept
            took.push_back(processor_ms() - begin);
    }
    for (const double ms : took)
        all += ms;
    std::sort(took.begin(), took.end());
    const double mean = all / static_cast<double>(took.size());
    std::printf("processor ms a frame: mean %.1f, p50 %.1f, p95 %.1f, most %.1f\n", mean, share(took, 0.5),
                share(took, 0.95), took.back());
    std::printf("of one core at 10 frames a second: %.0f %%; faces a frame: %.2f\n",
                mean * frames_per_s / 10.0, static_cast<double>(faces) / frames);
}
