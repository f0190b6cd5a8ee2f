// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/foreign_picture.hpp"

#include "faces/decode/picture_messages.hpp"

#include <memory>
#include <utility>
#include <variant>

namespace tp {
namespace {

Error sentence_for(NoAnswer reason) {
    return {reason == NoAnswer::too_long
                ? "The picture takes too long to decode; it was not read."
                : "The picture cannot be decoded: decoding it broke off. The file may be damaged."};
}

Result<PictureAnswer> asked(Helper& helper, PictureQuestion question) {
    auto answer = helper.ask(message_of(std::move(question)));
    if (auto* const message = std::get_if<Message>(&answer))
        return picture_answer(*message, helper.tray());
    return sentence_for(std::get<NoAnswer>(answer));
}

Result<PictureAnswer> asked_about(Helper& helper, const std::filesystem::path& file,
                                  PictureQuestion question) {
    Result<PictureFile> opened = open_picture_file(file);
    if (!opened)
        return Error{opened.error()};
    question.file = std::move(*opened);
    return asked(helper, std::move(question));
}

/// A helper that keeps what it decoded of one picture.
class KeptPicture {
public:
    explicit KeptPicture(HelperLease helper) : helper_(std::move(helper)) {}
    KeptPicture(const KeptPicture&) = delete;
    KeptPicture& operator=(const KeptPicture&) = delete;
    ~KeptPicture() { helper_->tell(message_of(PictureQuestion{})); }

    Result<cv::Mat> whole() {
        PictureQuestion question;
        question.what = PictureQuestion::What::whole;
        const Result<PictureAnswer> answer = asked(*helper_.operator->(), std::move(question));
        return answer ? Result<cv::Mat>(answer->pixels) : Error{answer.error()};
    }

private:
    HelperLease helper_;
};

} // namespace

Result<cv::Mat> foreign_to_fit(HelperPool& helpers, const std::filesystem::path& file, cv::Size box) {
    const Result<HelperLease> helper = helpers.lease();
    if (!helper)
        return Error{helper.error()};
    PictureQuestion question;
    question.what = PictureQuestion::What::to_fit;
    question.box = box;
    const Result<PictureAnswer> answer = asked_about(*helper->operator->(), file, std::move(question));
    return answer ? Result<cv::Mat>(answer->pixels) : Error{answer.error()};
}

Result<ShrunkPicture> foreign_shrunk(HelperPool& helpers, const std::filesystem::path& file, int longest_px) {
    Result<HelperLease> helper = helpers.lease();
    if (!helper)
        return Error{helper.error()};
    PictureQuestion question;
    question.what = PictureQuestion::What::shrunk;
    question.longest_px = longest_px;
    const Result<PictureAnswer> answer = asked_about(*helper->operator->(), file, std::move(question));
    if (!answer)
        return Error{answer.error()};
    ShrunkPicture picture{answer->pixels, answer->size, answer->shrink, {}};
    if (answer->whole_is_kept)
        picture.whole = [kept = std::make_shared<KeptPicture>(std::move(helper).value())] {
            return kept->whole();
        };
    return picture;
}

} // namespace tp
