// SPDX-License-Identifier: Apache-2.0
#include "audio/video/film_service.hpp"

#include "audio/video/handed_bytes.hpp"
#include "audio/video/video_film.hpp"

#include <cstdint>
#include <utility>

namespace tp {

std::optional<Message> FilmService::answer(MessageReader& message) {
    std::optional<FilmQuestion> question = film_question(message);
    if (!question)
        return std::nullopt;
    const double from_s = 1e-6 * static_cast<double>(question->from_us);
    switch (question->what) {
    case FilmQuestion::What::open: {
        film_.reset();
        Result<VideoFilm> opened = VideoFilm::open(
            std::make_unique<HandedBytes>(std::move(question->file), std::int64_t{0}, question->size));
        if (!opened)
            return tray_.message_of(Error{opened.error()});
        film_ = std::make_unique<VideoFilm>(std::move(opened).value());
        return tray_.message_of(film_->next(from_s));
    }
    case FilmQuestion::What::next:
        return tray_.message_of(film_ ? film_->next(from_s) : std::nullopt);
    case FilmQuestion::What::forget:
        break;
    }
    film_.reset();
    return std::nullopt;
}

} // namespace tp
