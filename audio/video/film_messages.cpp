// SPDX-License-Identifier: Apache-2.0
#include "audio/video/film_messages.hpp"

#include "core/files/file_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace tp {
namespace {

constexpr std::size_t longest_film_sentence = 1000; ///< bytes
constexpr double us_per_s = 1e6;
constexpr double longest_film_s = 1e6;

bool is_side(std::int64_t px) { return px >= 2 && px <= longest_film_side && px % 2 == 0; }

} // namespace

Message message_of(FilmQuestion question) {
    MessageWriter message;
    message.add(static_cast<std::int64_t>(question.what)).add(question.size).add(question.from_us);
    if (question.file.ok())
        message.hand_over(std::move(question.file));
    return message.take();
}

std::optional<FilmQuestion> film_question(MessageReader& message) {
    FilmQuestion question;
    const std::int64_t what = message.number();
    if (what < 0 || what > static_cast<std::int64_t>(FilmQuestion::What::forget))
        return std::nullopt;
    question.what = static_cast<FilmQuestion::What>(what);
    question.size = message.number();
    question.from_us = message.number();
    if (question.what == FilmQuestion::What::open)
        question.file = message.descriptor();
    return message.whole() ? std::optional(std::move(question)) : std::nullopt;
}

Message FilmTray::message_of(const Result<std::optional<FilmPicture>>& picture) {
    MessageWriter message;
    std::string sentence = picture.error();
    bool fresh = false;
    if (picture && *picture) {
        const std::size_t bytes = (*picture)->planes.size();
        if (!memory_ || memory_->size() < bytes) {
            memory_ = SharedMemory::make(bytes);
            fresh = true;
        }
        if (memory_)
            std::memcpy(memory_->data(), (*picture)->planes.data(), bytes);
        else
            sentence = "there is not enough memory.";
    }
    message.add(std::string_view(sentence).substr(0, longest_film_sentence));
    if (!sentence.empty() || !*picture)
        return message.take();
    message.add(static_cast<std::int64_t>((*picture)->time_s * us_per_s))
        .add(std::int64_t{(*picture)->width})
        .add(std::int64_t{(*picture)->height})
        .add(std::int64_t{(*picture)->turn_deg});
    if (fresh)
        message.hand_over(memory_->another());
    return message.take();
}

Result<std::optional<FilmPicture>> film_answer(Message& message, std::optional<Mapping>& tray) {
    MessageReader reader(message);
    const std::string sentence = reader.text();
    if (!sentence.empty())
        return Error{readable(std::string_view(sentence).substr(0, longest_film_sentence))};
    if (reader.whole())
        return std::optional<FilmPicture>();
    FilmPicture picture;
    picture.time_s = static_cast<double>(reader.number()) / us_per_s;
    const std::int64_t width = reader.number(), height = reader.number(), turn = reader.number();
    if (reader.has_descriptor())
        tray = received(reader.descriptor());
    if (!reader.whole() || std::abs(picture.time_s) > longest_film_s || !is_side(width) || !is_side(height) ||
        width * height > most_film_px || turn < 0 || turn > 270 || turn % 90 != 0)
        return Error{"its pictures cannot be decoded."};
    picture.width = static_cast<int>(width);
    picture.height = static_cast<int>(height);
    picture.turn_deg = static_cast<int>(turn);
    const std::size_t bytes = film_bytes(picture.width, picture.height);
    if (!tray || tray->size() < bytes)
        return Error{"its pictures cannot be decoded."};
    const auto* const from = static_cast<const std::uint8_t*>(tray->data());
    picture.planes.assign(from, from + bytes);
    return std::optional(std::move(picture));
}

} // namespace tp
