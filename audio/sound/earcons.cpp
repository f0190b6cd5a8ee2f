// SPDX-License-Identifier: Apache-2.0
#include "audio/sound/earcons.hpp"

#include "audio/sound/earcon_synth.hpp"

#include <algorithm>

namespace tp {

namespace {

using enum Envelope;

struct Definition {
    std::string_view name;
    std::vector<Tone> tones;
};

/// In the order of Earcon. Tones: begin ms, duration ms, from Hz, to Hz, envelope, third harmonic.
const std::array<Definition, every_earcon.size()>& definitions() {
    static const std::array<Definition, every_earcon.size()> table{{
        {"program_start",
         {{0, 100, 523, 523, struck}, {90, 100, 659, 659, struck}, {180, 120, 784, 784, struck}}},
        {"ready", {{0, 60, 1319, 1319, steady}, {100, 60, 1319, 1319, steady}}},
        {"face_entered", {{0, 160, 440, 880, steady}}},
        {"face_left", {{0, 160, 880, 440, steady}}},
        {"contour_crossed", {{0, 30, 1568, 1568, steady}}},
        {"next", {{0, 60, 659, 659, steady}, {60, 80, 988, 988, steady}}},
        {"previous", {{0, 60, 988, 988, steady}, {60, 80, 659, 659, steady}}},
        {"list_end", {{0, 80, 392, 392, struck}, {110, 120, 330, 330, struck}}},
        {"recording_started", {{0, 240, 1000, 1000, steady}}},
        {"recording_stopped", {{0, 90, 1000, 1000, steady}, {130, 160, 750, 750, steady}}},
        {"saved", {{0, 120, 1047, 1047, struck}, {100, 200, 1568, 1568, struck}}},
        {"deleted", {{0, 260, 700, 320, struck, 0.4}}},
        {"undone", {{0, 110, 320, 700, steady, 0.4}, {120, 110, 700, 700, struck, 0.4}}},
        {"error", {{0, 280, 311, 311, steady, 0.5}, {0, 280, 349, 349, steady, 0.5}}},
        {"fault",
         {{0, 70, 2093, 2093, steady},
          {70, 70, 1661, 1661, steady},
          {140, 70, 2093, 2093, steady},
          {210, 70, 1661, 1661, steady}}},
    }};
    return table;
}

const Definition& definition(Earcon earcon) { return definitions()[static_cast<std::size_t>(earcon)]; }

} // namespace

std::string_view name_of(Earcon earcon) { return definition(earcon).name; }

std::span<const float> samples_of(Earcon earcon) {
    static const auto rendered = [] {
        std::array<std::vector<float>, every_earcon.size()> sounds;
        std::ranges::transform(definitions(), sounds.begin(),
                               [](const Definition& each) { return render_tones(each.tones); });
        return sounds;
    }();
    return rendered[static_cast<std::size_t>(earcon)];
}

} // namespace tp
