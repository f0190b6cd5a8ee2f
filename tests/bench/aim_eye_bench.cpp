// SPDX-License-Identifier: Apache-2.0
// How long a frame is looked at, without and with people who may be known: aim_eye_bench [PHOTO [SECONDS]]. A simulated hand holds a camera of 1280 x 720 px before the
// photograph (default: a sample) and turns a little; its frames, ten a second of their own clock, are made beforehand.
#include "app/capture/frames/simulated_camera.hpp"
#include "app/capture/seeing/aim_eye.hpp"
#include "app/capture/seeing/face_namer.hpp"
#include "faces/extract/quick_faces.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

using namespace tp;

namespace {

constexpr double frames_per_s = 10.0;

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double share(const std::vector<double>& sorted, double of_all) {
    return sorted[static_cast<std::size_t>(of_all * static_cast<double>(sorted.size() - 1))];
}

/// Looks at all frames, and says how long that took.
void look(AimEye& eye, const std::vector<CameraFrame>& frames, const char* what) {
    std::vector<double> took;
    std::size_t faces = 0, names = 0;
    double all = 0.0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const double begin = processor_ms();
        const AimFrame seen = eye.see(frames[i]);
        if (i > 0) // the first one makes what is kept
            took.push_back(processor_ms() - begin);
        faces += seen.faces.size();
        names += seen.faces.empty() || seen.faces[0].name.empty() ? 0U : 1U;
    }
    for (const double ms : took)
        all += ms;
    std::sort(took.begin(), took.end());
    const double mean = all / static_cast<double>(took.size());
    std::printf("%s: processor ms a frame: mean %.1f, p50 %.1f, p95 %.1f, most %.1f; of one core at 10 "
                "frames a second: %.0f %%; "
                "%.2f faces and %.2f names a frame\n",
                what, mean, share(took, 0.5), share(took, 0.95), took.back(), mean * frames_per_s / 10.0,
                static_cast<double>(faces) / static_cast<double>(frames.size()),
                static_cast<double>(names) / static_cast<double>(frames.size()));
}

/// Whoever the largest face of that frame is.
NamedFaces somebody(const cv::Mat& frame) {
    QuickFaces faces;
    FaceDescriber describer;
    const auto found = faces.find(frame);
    const auto face = found.empty() ? std::nullopt : faces.face_at(frame, found[0]);
    const auto numbers = face ? describer.describe(frame, *face) : std::nullopt;
    return {"somebody", {numbers ? *descriptor_of(*numbers) : FaceDescriptor{}}};
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
    std::vector<CameraFrame> shown;
    for (int i = 0; i < frames; ++i) {
        camera->move_to({.pan_deg = 10.0 * i / frames - 5.0});
        shown.push_back(**camera->next());
    }
    AimEye eye;
    look(eye, shown, "nobody is known");
    const auto people = std::make_shared<KnownPeople>();
    people->know({somebody(shown.front().pixels)});
    AimEye knowing;
    knowing.name_by([namer = std::make_shared<FaceNamer>(people)](const cv::Mat& frame, const Face& face) {
        return namer->name(frame, face);
    });
    look(knowing, shown, "somebody is known");
}
