// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_file.hpp"

#include "app/photo/scene/corrections.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/free_name.hpp"
#include "core/files/whole_file.hpp"

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_bytes = 64u << 20;

/// The file's bytes; none where there is no file.
Result<std::optional<std::string>> bytes_of(const fs::path& file) {
    if (is_gone(file))
        return std::optional<std::string>();
    const Result<std::string> bytes = read_whole(file, most_bytes);
    return bytes ? Result<std::optional<std::string>>(std::optional(*bytes)) : Error{bytes.error()};
}

} // namespace

Result<MendFile> MendFile::open(const fs::path& photo, const MendWork& opened) {
    MendFile file;
    file.path_ = correction_file(photo);
    Result<std::optional<std::string>> bytes = bytes_of(file.path_);
    if (!bytes)
        return Error{bytes.error()};
    file.opened_ = file.there_ = std::move(bytes).value();
    file.opened_text_ = sheet_to_svg(sheet_of(opened));
    return file;
}

MendFile::Bytes MendFile::bytes_for(const MendWork& work) const {
    const ContourSheet sheet = sheet_of(work);
    std::string text = sheet_to_svg(sheet);
    if (text == opened_text_)
        return opened_;
    return sheet.contours.empty() ? Bytes() : Bytes(std::move(text));
}

std::string MendFile::keep_what_others_wrote() {
    const Result<Bytes> now = bytes_of(path_);
    if (!now)
        return now.error();
    if (*now == there_ || !*now)
        return {};
    const auto aside = free_name([this](int number) {
        return std::vector{path_.parent_path() /
                           (path_.stem().string() + "-" + std::to_string(number) + ".svg")};
    });
    const std::string reason = aside ? replace_file(*aside, **now, Readers::owner_only) : aside.error();
    if (!reason.empty())
        return "What another program wrote cannot be saved: " + reason;
    kept_aside_ = *aside;
    return {};
}

std::string MendFile::save(const MendWork& work) {
    kept_aside_.clear();
    const Bytes wanted = bytes_for(work);
    if (wanted == there_)
        return {};
    if (std::string problem = keep_what_others_wrote(); !problem.empty())
        return problem;
    if (wanted) {
        if (const std::string reason = replace_file(path_, *wanted, Readers::owner_only); !reason.empty())
            return "The mended contours cannot be saved as " + quoted(path_) + ": " + reason;
    } else {
        const std::string reason = remove_file(path_);
        if (!reason.empty())
            return "The mended contours " + quoted(path_) + " cannot be removed: " + reason;
    }
    there_ = wanted;
    return {};
}

} // namespace tp
