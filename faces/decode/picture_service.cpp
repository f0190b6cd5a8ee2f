// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture_service.hpp"

#include "core/files/open_file.hpp"
#include "faces/decode/libavcodec.hpp"
#include "faces/decode/libheif.hpp"
#include "faces/decode/other_formats.hpp"
#include "faces/decode/picture_messages.hpp"
#include "faces/decode/quiet_opencv.hpp"
#include "faces/decode/upright_picture.hpp"

#include <new>
#include <span>
#include <utility>

namespace tp {
namespace {

/// From its beginning, wherever whoever opened it has read.
Result<Bytes> bytes_of(const PictureFile& file) {
    Bytes bytes(static_cast<std::size_t>(file.size));
    const std::span<char> all(reinterpret_cast<char*>(bytes.data()), bytes.size());
    if (read_at(file.descriptor.number(), 0, all) < bytes.size())
        return Error{"The file cannot be read."};
    return bytes;
}

Result<PictureAnswer> answer_of(Result<cv::Mat> picture) {
    return picture ? Result<PictureAnswer>(PictureAnswer{*picture, picture->size(), 1, false})
                   : Error{picture.error()};
}

Result<PictureAnswer> to_fit(const PictureQuestion& question) {
    const Result<Bytes> bytes = bytes_of(question.file);
    return bytes ? answer_of(decoded_to_fit(*bytes, question.box)) : Error{bytes.error()};
}

} // namespace

void load_heif_decoders() {
    quiet_opencv();
    load_libheif();
    load_libavcodec();
}

void load_picture_decoders() {
    quiet_opencv();
    load_other_decoders();
}

std::optional<Message> PictureService::answer(MessageReader& message) {
    const std::optional<PictureQuestion> question = picture_question(message);
    if (!question)
        return std::nullopt;
    if (question->what != PictureQuestion::What::whole)
        whole_ = nullptr;
    try {
        switch (question->what) {
        case PictureQuestion::What::to_fit:
            return message_of(to_fit(*question), tray_);
        case PictureQuestion::What::shrunk: {
            const Result<Bytes> bytes = bytes_of(question->file);
            Result<ShrunkPicture> picture =
                bytes ? decoded_shrunk(*bytes, question->longest_px) : Error{bytes.error()};
            if (!picture)
                return message_of(Error{picture.error()}, tray_);
            whole_ = std::move(picture->whole);
            return message_of(
                PictureAnswer{picture->pixels, picture->size, picture->shrink, whole_ != nullptr}, tray_);
        }
        case PictureQuestion::What::whole:
            return message_of(whole_ ? answer_of(whole_()) : no_memory(), tray_);
        case PictureQuestion::What::forget:
            break;
        }
    } catch (const std::bad_alloc&) {
        return message_of(no_memory(), tray_);
    }
    return std::nullopt;
}

} // namespace tp
