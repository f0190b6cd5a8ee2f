// SPDX-License-Identifier: Apache-2.0
// How soon a hand hears of a change: aim_latency_bench [CHANGES [PHOTO]]. Frames of 1280 x 720 px come thirty a second, as a
// camera gives them; a face is at the left for a while, then at the right. Measured is from the moment in which the first frame
// that shows it is handed over to the tone on its other side and to the words; the voice's and the loudspeaker's own time comes
// on top (tests/bench/latency).
#include "app/capture/frames/simulated_camera.hpp"
#include "app/capture/seeing/aim_eye.hpp"
#include "app/capture/seeing/camera_watch.hpp"
#include "core/aiming/aiming.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace tp;

namespace {

constexpr double frames_per_s = 30.0;
constexpr double change_every_s = 2.5;
constexpr double sentence_s = 0.7; ///< "A little left." takes about that
constexpr double aside_deg = 12.0;
constexpr std::size_t frames_of_a_side = 15; ///< of a hand that trembles, over and over

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Frames in real time, of which every `change_every_s` the other side begins.
class ChangingCamera final : public FrameSource {
public:
    ChangingCamera(std::array<std::vector<cv::Mat>, 2> sides, int changes, std::atomic<double>& changed_s)
        : sides_(std::move(sides)), changes_(changes), changed_s_(changed_s) {}

    Result<std::optional<CameraFrame>> next() override {
        if (stop_)
            return std::optional<CameraFrame>();
        const double due = begin_s_ + static_cast<double>(taken_) / frames_per_s;
        std::this_thread::sleep_for(std::chrono::duration<double>(due - now_s()));
        const int change = static_cast<int>(static_cast<double>(taken_) / frames_per_s / change_every_s);
        if (change > changes_)
            return std::optional<CameraFrame>();
        const std::vector<cv::Mat>& frames = sides_[static_cast<std::size_t>(change % 2)];
        CameraFrame frame{frames[taken_++ % frames.size()], now_s(), {}, {}};
        if (std::exchange(change_, change) != change)
            changed_s_ = frame.time_s;
        return std::optional(std::move(frame));
    }
    HeldCamera held() const override { return {}; }
    void interrupt() override { stop_ = true; }

private:
    std::array<std::vector<cv::Mat>, 2> sides_;
    int changes_;
    std::atomic<double>& changed_s_;
    std::size_t taken_ = 0;
    int change_ = 0;
    double begin_s_ = now_s();
    std::atomic<bool> stop_{false};
};

void print(const char* what, std::vector<double> ms, int changes) {
    std::sort(ms.begin(), ms.end());
    if (ms.empty())
        return void(std::printf("%s: never\n", what));
    const auto at = [&](double share) {
        return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
    };
    std::printf("%s: %zu of %d changes, ms: p50 %.0f, p95 %.0f, longest %.0f\n", what, ms.size(), changes,
                at(0.5), at(0.95), ms.back());
}

} // namespace

int main(int argc, char** argv) {
    const int changes = argc > 1 ? std::atoi(argv[1]) : 40;
    const std::filesystem::path photo =
        argc > 2 ? argv[2] : TOUCHPHOTO_SOURCE "/resources/samples/anna_smiling.jpg";
    SimulatedHold hold;
    hold.frames_per_s = frames_per_s;
    hold.wall = {0.6, 1.0, {0.5, 0.45}};
    auto camera = SimulatedCamera::open(photo, hold);
    if (!camera || changes < 1) {
        std::fprintf(stderr, "%s\n", camera ? "At least one change." : camera.error().c_str());
        return 1;
    }
    std::array<std::vector<cv::Mat>, 2> sides;
    for (std::size_t side = 0; side < 2; ++side) {
        camera->move_to({.pan_deg = side == 0 ? -aside_deg : aside_deg});
        for (std::size_t i = 0; i < frames_of_a_side; ++i)
            sides[side].push_back((**camera->next()).pixels);
    }
    std::atomic<double> changed_s{0.0};
    std::atomic<bool> over{false};
    Aiming aiming{Aim::middle};
    std::optional<double> sentence_began_s;
    double told_tone_s = 0.0, told_words_s = 0.0, side_before = 0.0;
    std::vector<double> tones, words;
    CameraTold told;
    told.seen = [&](const AimFrame& seen, const CameraFrame&) {
        if (sentence_began_s && seen.time_s - *sentence_began_s > sentence_s) {
            aiming.sentence_ended(seen.time_s);
            sentence_began_s.reset();
        }
        const AimAnswer answer = aiming.see(seen);
        const double now = now_s(), changed = changed_s;
        if (answer.say)
            sentence_began_s = seen.time_s;
        if (changed > 0.0 && seen.time_s >= changed) {
            if (answer.tone.sounds && answer.tone.side * side_before < 0.0 && told_tone_s < changed) {
                tones.push_back(1e3 * (now - changed));
                told_tone_s = now;
            }
            if (answer.say && told_words_s < changed) {
                words.push_back(1e3 * (now - changed));
                told_words_s = now;
            }
        }
        if (answer.tone.sounds && answer.tone.side != 0.0)
            side_before = answer.tone.side;
    };
    told.ended = [&](const std::string&) { over = true; };
    const double begin = now_s();
    const std::clock_t processor = std::clock();
    {
        CameraWatch watch(
            std::make_unique<ChangingCamera>(std::move(sides), changes, changed_s),
            [eye = std::make_shared<AimEye>()](const CameraFrame& frame) { return eye->see(frame); }, told);
        while (!over)
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    print("tone", tones, changes);
    print("words", words, changes);
    std::printf("of one core, at 30 frames a second: %.0f %%\n",
                100.0 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC / (now_s() - begin));
}
