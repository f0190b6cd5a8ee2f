// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture_messages.hpp"

#include "core/files/file_words.hpp"
#include "faces/decode/upright_picture.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace tp {
namespace {

constexpr std::size_t longest_sentence = 1000; ///< bytes
constexpr int largest_shrink = 8;
constexpr double most_decoded_px =
    1.05 * largest_picture_px; ///< with what some encoders fill up to whole blocks

/// A decoder of JPEG rounds up, shrinking planes down.
bool is_shrunk(int pixels, int whole, int shrink) {
    return pixels == whole / shrink || pixels == whole / shrink + (whole % shrink != 0 ? 1 : 0);
}

Error no_answer_of_a_decoder() { return {"The picture cannot be decoded."}; }

/// Zero where it is no number of an int.
int as_int(std::int64_t number) {
    return number < 0 || number > std::numeric_limits<int>::max() ? 0 : static_cast<int>(number);
}

} // namespace

Message message_of(PictureQuestion question) {
    MessageWriter message;
    message.add(static_cast<std::int64_t>(question.what));
    message.add(std::int64_t{question.box.width}).add(std::int64_t{question.box.height});
    message.add(std::int64_t{question.longest_px}).add(static_cast<std::int64_t>(question.file.size));
    if (question.file.descriptor.ok())
        message.hand_over(std::move(question.file.descriptor));
    return message.take();
}

std::optional<PictureQuestion> picture_question(MessageReader& message) {
    PictureQuestion question;
    const std::int64_t what = message.number();
    if (what < 0 || what > static_cast<std::int64_t>(PictureQuestion::What::forget))
        return std::nullopt;
    question.what = static_cast<PictureQuestion::What>(what);
    question.box.width = as_int(message.number());
    question.box.height = as_int(message.number());
    question.longest_px = as_int(message.number());
    question.file.size = static_cast<std::uintmax_t>(message.number());
    if (question.what == PictureQuestion::What::to_fit || question.what == PictureQuestion::What::shrunk)
        question.file.descriptor = message.descriptor();
    return message.whole() ? std::optional(std::move(question)) : std::nullopt;
}

Message message_of(const Result<PictureAnswer>& answer, PixelTray& tray) {
    const bool there = answer && tray.put(answer->pixels);
    MessageWriter message;
    const std::string sentence = there ? std::string() : answer ? no_memory().sentence : answer.error();
    message.add(std::string_view(sentence).substr(0, longest_sentence));
    if (!there)
        return message.take();
    for (const int number : {answer->pixels.cols, answer->pixels.rows, answer->size.width,
                             answer->size.height, answer->shrink, answer->whole_is_kept ? 1 : 0})
        message.add(std::int64_t{number});
    if (Descriptor memory = tray.handed_over(); memory.ok())
        message.hand_over(std::move(memory));
    return message.take();
}

Result<PictureAnswer> picture_answer(Message& message, std::optional<Mapping>& tray) {
    MessageReader reader(message);
    if (const std::string sentence = reader.text(); !sentence.empty())
        return Error{readable(std::string_view(sentence).substr(0, longest_sentence))};
    PictureAnswer answer;
    cv::Size pixels;
    for (int* const side : {&pixels.width, &pixels.height, &answer.size.width, &answer.size.height})
        *side = as_int(reader.number());
    answer.shrink = as_int(reader.number());
    answer.whole_is_kept = reader.number() != 0;
    if (reader.has_descriptor())
        tray = received(reader.descriptor());
    const bool can_be = reader.whole() && answer.shrink >= 1 && answer.shrink <= largest_shrink &&
                        is_shrunk(pixels.width, answer.size.width, answer.shrink) &&
                        is_shrunk(pixels.height, answer.size.height, answer.shrink) &&
                        static_cast<double>(answer.size.width) * answer.size.height <= most_decoded_px;
    if (can_be)
        answer.pixels = pixels_in(tray, pixels);
    return answer.pixels.empty() ? Result<PictureAnswer>(no_answer_of_a_decoder()) : answer;
}

} // namespace tp
