// SPDX-License-Identifier: Apache-2.0
// Somebody who takes photographs, in one process: a burst of which two are kept, the sound of the moment, one taken back. Says TRY
// before and ACK after each step on stdout, so that whoever kills it knows what was acknowledged.
//
//     shutter_worker ALBUM SOUND
#include "app/album/keeper/album_keeper.hpp"
#include "app/capture/shutter/photograph_store.hpp"

#include <QDate>
#include <QDateTime>
#include <QTime>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <unistd.h>

using namespace tp;
namespace fs = std::filesystem;

namespace {

void tell(const std::string& line) {
    const std::string text = line + "\n";
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0)
        std::_Exit(3);
}

cv::Mat picture(std::uint64_t seed) {
    cv::RNG random(seed);
    cv::Mat shapes(30, 40, CV_8UC3), large;
    random.fill(shapes, cv::RNG::UNIFORM, 30, 220);
    cv::resize(shapes, large, {800, 600}, 0.0, 0.0, cv::INTER_LINEAR);
    return large;
}

/// Where it lies; empty where it was not kept.
fs::path take(PhotographStore& store, std::uint64_t seed) {
    tell("TRY take");
    PhotographFacts facts;
    facts.taken = QDateTime(QDate(2026, 11, 26), QTime(14, 3, 22));
    const auto kept = store.keep(picture(seed), facts, {{0.5, 0.5, 0.2, 0.2, "Anna"}});
    if (!kept) {
        tell("SAID take: " + kept.error());
        return {};
    }
    tell((kept->warning.empty() ? "ACK photo " : "ACK bare ") + kept->photo.filename().string());
    return kept->photo;
}

} // namespace

int main(int, char** words) {
    const fs::path album = words[1], sound = words[2];
    AlbumKeeper keeper(album);
    PhotographStore store(keeper, album / "taken");
    const fs::path first = take(store, 1);
    if (!first.empty()) {
        tell("TRY moment");
        const auto added = store.add_moment(first, sound, {});
        tell(added ? "ACK moment " + added->tag.file : "SAID moment: " + added.error());
    }
    take(store, 2);
    const fs::path third = take(store, 3);
    if (!third.empty()) {
        tell("TRY undo " + third.filename().string());
        const std::string problem = keeper.history().undo();
        tell(problem.empty() ? "ACK undo " + third.filename().string() : "SAID undo: " + problem);
    }
    take(store, 4);
    tell("END");
    return 0;
}
