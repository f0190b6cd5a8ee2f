// SPDX-License-Identifier: Apache-2.0
// touchphoto-decoder: started by TouchPhoto at the first photograph or video that is for it. It decodes what it
// is handed, or reads its metadata, in a process that can do nothing else, so that what a hostile file brings
// about in a library ends here. Its word says which libraries it loads.
//
//     touchphoto-decoder heif|jpegs|pictures|metadata|videos|films
//     touchphoto-decoder --version
//
// Descriptor 3 is the program that asks.
#include "audio/video/film_service.hpp"
#include "audio/video/sound_service.hpp"
#include "core/processes/answering.hpp"
#include "core/processes/message.hpp"
#include "core/version/version.hpp"
#include "faces/decode/picture_service.hpp"
#include "faces/exiv2/metadata_messages.hpp"
#include "faces/exiv2/prepare_exiv2.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string_view>

namespace {

constexpr tp::Limits limits{std::uint64_t{6} << 30,
                            64}; ///< a picture of 200 megapixel with ten bits takes half of it
constexpr int longest_s = 150;   ///< of processor time, for one answer

void answer_by(const std::function<std::optional<tp::Message>(tp::MessageReader&)>& service) {
    tp::answer_messages(limits, longest_s, [&](tp::Message& message) {
        tp::MessageReader question(message);
        return service(question);
    });
}

void decode_pictures(void (*load)()) {
    load();
    tp::PictureService pictures;
    answer_by([&](tp::MessageReader& question) { return pictures.answer(question); });
}

void read_metadata() {
    tp::prepare_exiv2();
    answer_by(tp::metadata_answer);
}

template <typename Service>
void decode_videos() {
    tp::load_video_decoders();
    Service service;
    answer_by([&](tp::MessageReader& question) { return service.answer(question); });
}

} // namespace

int main(int count, char** words) {
    const std::string_view what = count == 2 ? words[1] : "";
    if (what == "heif")
        decode_pictures(tp::load_heif_decoders);
    else if (what == "jpegs")
        decode_pictures([] {}); // its library is linked
    else if (what == "pictures")
        decode_pictures(tp::load_picture_decoders);
    else if (what == "metadata")
        read_metadata();
    else if (what == "videos")
        decode_videos<tp::SoundService>();
    else if (what == "films")
        decode_videos<tp::FilmService>();
    else if (what == "--version")
        return std::puts(tp::version_line("touchphoto-decoder").c_str()) < 0;
    std::_Exit(0); // there is nothing to be put in order, and nothing that might still be done
}
