// SPDX-License-Identifier: Apache-2.0
#include "audio/video/film_of_video.hpp"

#include "audio/recordings/byte_source.hpp"
#include "audio/video/film_messages.hpp"
#include "audio/video/video_film.hpp"
#include "core/files/file_words.hpp"
#include "core/files/open_file.hpp"
#include "core/processes/foreign_decoder.hpp"
#include "core/processes/helper.hpp"

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

namespace tp {
namespace {

Result<std::optional<FilmPicture>> asked(Helper& helper, FilmQuestion question) {
    auto answer = helper.ask(message_of(std::move(question)));
    if (auto* const message = std::get_if<Message>(&answer))
        return film_answer(*message, helper.tray());
    return Error{std::get<NoAnswer>(answer) == NoAnswer::too_long
                     ? "its pictures take too long to decode."
                     : "its pictures cannot be decoded: decoding them broke off. It may be damaged."};
}

/// A film that a helper decodes, whose first picture has been asked for.
class HelpersFilm final : public FilmStream {
public:
    HelpersFilm(HelperLease helper, FilmPicture first)
        : helper_(std::move(helper)), first_(std::move(first)) {}
    HelpersFilm(const HelpersFilm&) = delete;
    HelpersFilm& operator=(const HelpersFilm&) = delete;
    ~HelpersFilm() override { helper_->tell(message_of(FilmQuestion{})); }

    std::optional<FilmPicture> next(double from_s) override {
        if (auto first = std::exchange(first_, {}); first && first->time_s >= from_s)
            return first;
        FilmQuestion question;
        question.what = FilmQuestion::What::next;
        question.from_us = static_cast<std::int64_t>(std::llround(1e6 * from_s));
        auto picture = asked(*helper_.operator->(), std::move(question));
        return picture ? std::move(picture).value() : std::nullopt;
    }

private:
    HelperLease helper_;
    std::optional<FilmPicture> first_;
};

Result<std::unique_ptr<FilmStream>> by_helper(HelperPool& helpers, FilmQuestion question) {
    Result<HelperLease> helper = helpers.lease();
    if (!helper)
        return Error{helper.error()};
    auto first = asked(*helper->operator->(), std::move(question));
    if (!first)
        return Error{first.error()};
    if (!*first)
        return Error{"nothing of its pictures can be decoded."};
    return std::unique_ptr<FilmStream>(
        std::make_unique<HelpersFilm>(std::move(helper).value(), std::move(**first)));
}

} // namespace

Result<std::unique_ptr<FilmStream>> film_of_video(const std::filesystem::path& file) {
    auto bytes = FileBytes::open(file);
    if (!bytes)
        return Error{bytes.error()};
    if (ForeignDecoders* const decoders = foreign_decoders()) {
        FilmQuestion question;
        question.what = FilmQuestion::What::open;
        question.size = static_cast<std::int64_t>((*bytes)->size());
        question.file = OpenFile(file, {}).handed_over();
        if (!question.file.ok())
            return Error{"it cannot be read: " + reason_of(errno)};
        return by_helper(decoders->films, std::move(question));
    }
    auto film = VideoFilm::open(std::move(*bytes));
    if (!film)
        return Error{film.error()};
    return std::unique_ptr<FilmStream>(std::make_unique<VideoFilm>(std::move(film).value()));
}

} // namespace tp
