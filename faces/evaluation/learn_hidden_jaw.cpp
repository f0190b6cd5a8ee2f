// SPDX-License-Identifier: Apache-2.0
// learn_hidden_jaw WILD LABELS: prints faces/judge/hidden_jaw_weights.inc, learned from the photographs in
// the wild that no test takes and what somebody saw in them. Of faces without beard (or hair before the jaw)
// one in thirty is told to have one.
#include "faces/decode/picture.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/evaluation/cover_lessons.hpp"
#include "faces/evaluation/training_half.hpp"
#include "faces/evaluation/wild_labels.hpp"
#include "faces/judge/hidden_jaw.hpp"

#include <cstdio>

using namespace tp;
namespace fs = std::filesystem;

namespace {

constexpr double prior = 1.0;         ///< hidden jaws to free ones, as they are weighed
constexpr double told_wrongly = 0.03; ///< of free ones

void print(const char* name, const cv::Mat1d& signs, const cv::Mat1d& hidden) {
    cv::Mat1d weights = fitted_cover(signs, hidden, prior);
    weights(0) -= threshold_for(signs, hidden, weights, told_wrongly);
    int told = 0;
    for (int r = 0; r < signs.rows; ++r)
        told += hidden(r) > 0.5 && signs.row(r).dot(weights.t()) > 0.0;
    std::printf("/// Of jaw_signs: %d faces, %d of them with such a jaw, of which %d are told.\n", signs.rows,
                static_cast<int>(cv::sum(hidden)[0]), told);
    std::printf("constexpr std::array<double, jaw_sign_count> %s", name);
    print_row(weights);
    std::puts(";");
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("learn_hidden_jaw ../shared/faces/photos/wild tests/faces/wild_labels.txt > "
                   "faces/judge/hidden_jaw_weights.inc\n",
                   stderr);
        return 2;
    }
    quiet_opencv();
    const auto held_out = held_out_people(fs::path(TP_TRAINING) / "holdout_wild.txt");
    const auto labels = read_wild_labels(argv[2]);
    if (!held_out || !labels) {
        std::fprintf(stderr, "%s\n", (held_out ? labels.error() : held_out.error()).c_str());
        return 1;
    }
    Eyewitness eyewitness;
    cv::Mat1d signs, beards, hairs;
    for (const auto& [name, words] : labels->words()) {
        if (held_out->contains(name) || !labels->is_plain(name))
            continue;
        const auto photo = read_picture(fs::path(argv[1]) / name);
        const auto sight = photo ? sight_of(eyewitness, *photo) : std::nullopt;
        if (!sight)
            continue;
        signs.push_back(row_of(jaw_signs(*photo, sight->opinions.settled)));
        beards.push_back(words.contains(wild_label::jaw_beard) ? 1.0 : 0.0);
        hairs.push_back(words.contains(wild_label::jaw_hair) ? 1.0 : 0.0);
    }
    std::puts("// SPDX-License-Identifier: Apache-2.0");
    print("beard_weights", signs, beards);
    print("hair_weights", signs, hairs);
    return 0;
}
