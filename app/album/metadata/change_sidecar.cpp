// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/change_sidecar.hpp"

#include "app/album/metadata/merge.hpp"
#include "app/album/metadata/photo_metadata.hpp"
#include "app/album/metadata/sidecar_names.hpp"
#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_record.hpp"
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/folder_lock.hpp"
#include "core/files/new_file.hpp"
#include "core/files/whole_file.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

/// A second program that writes that often while we try is not going to stop.
constexpr int most_tries = 20;
/// As long as another program may take to write a sidecar in place.
constexpr auto pause_for_writer = std::chrono::milliseconds(20);

/// A sidecar without any content holds nothing to lose and is begun anew.
bool is_blank(std::string_view bytes) {
    return bytes.find_first_not_of(std::string_view(" \t\r\n\0", 5)) == std::string_view::npos;
}

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

/// Whether a sidecar `IMG_1.xmp` was made for this very file and not for `IMG_1.nef` beside it.
bool is_for(const XmpPacket& shared, const fs::path& photo) {
    const auto extension = shared.value(xmp::sidecar_extension);
    return !extension ||
           lower_case(photo.extension().string()) == std::string(".").append(lower_case(extension->text));
}

/// One write of one sidecar.
class SidecarWrite {
public:
    SidecarWrite(const fs::path& photo, const SidecarEditor& change, PhotoMetadata metadata)
        : photo_(photo), change_(change), sidecar_(sidecar_of(photo)), own_(std::move(metadata)) {
        read_shared();
        if (shared_)
            behind_.packets.push_back(&*shared_);
        if (own_.xmp)
            behind_.packets.push_back(&*own_.xmp);
        behind_.shape = own_.shape;
        if (shared_)
            behind_.parts = parts_from_xmp(*shared_, own_.shape);
        complete(behind_.parts, own_.parts);
    }

    std::string run() {
        if (name_taken(sidecar_))
            if (std::string failed = look(); !failed.empty())
                return failed;
        for (int tries = 0; tries < most_tries; ++tries) {
            bool done = false;
            std::string failed = attempt(done);
            if (!failed.empty())
                give_back();
            if (done || !failed.empty())
                return failed;
        }
        give_back();
        return failure("another program keeps writing to it.");
    }

private:
    void read_shared() {
        for (const fs::path& other : sidecars_of(photo_)) {
            if (other == sidecar_)
                continue;
            const auto bytes = read_whole(other, XmpPacket::most_bytes);
            auto packet = bytes ? XmpPacket::from(*bytes) : Result<XmpPacket>(Error{});
            if (!packet)
                continue;
            if (is_for(*packet, photo_))
                start_ = *bytes;
            shared_ = std::move(*packet);
        }
    }

    /// Takes what is there now as what is to be changed.
    std::string look() {
        auto bytes = read_whole(sidecar_, XmpPacket::most_bytes);
        if (!bytes)
            return failure(bytes.error());
        leave_base();
        expected_ = base_ = *std::move(bytes);
        return {};
    }

    /// Writes the changed sidecar unless somebody else wrote since it was read; then what they wrote is the
    /// new base. Not done and no sentence: try again.
    std::string attempt(bool& done) {
        std::string_view start = base_ && !is_blank(*base_) ? std::string_view(*base_) : start_;
        auto packet = start.empty() ? Result<XmpPacket>(XmpPacket{}) : XmpPacket::from(start);
        if (!packet)
            return failure(packet.error() + " It was left as it is.");
        for (const std::string& bytes : missed_)
            if (const auto other = XmpPacket::from(bytes))
                bring_in(*packet, *other, added_meanwhile(parts_from_xmp(*other, own_.shape)), false,
                         behind_);
        if (std::string refused = change_(*packet, behind_); !refused.empty())
            return refused;
        std::string bytes = packet->bytes();
        if (XmpPacket::most_bytes < bytes.size())
            return failure("it would become larger than any program reads.");
        done = expected_ == bytes;
        if (done)
            return {};

        auto file = NewFile::beside(sidecar_, Readers::owner_only);
        if (!file)
            return failure(file.error());
        file->no_more_open_than(photo_);
        if (std::string reason = file->write(bytes); !reason.empty())
            return failure(reason);
        if (somebody_wrote())
            return look_again();
        std::string reason = file->take_place(expected_ ? Existing::swapped : Existing::kept);
        if (!reason.empty() && expected_ &&
            lies_there(bytes)) { // and nobody knows for how long: theirs comes back
            file->take_place(Existing::swapped);
            return failure(reason);
        }
        if (!reason.empty())
            return somebody_wrote() ? look_again() : failure(reason);
        done = !expected_ || file->temporary().empty();
        return done ? std::string{} : check_displaced(*file, std::move(bytes), done);
    }

    bool lies_there(const std::string& bytes) const {
        const auto there = read_whole(sidecar_, XmpPacket::most_bytes);
        return there && *there == bytes;
    }
    bool somebody_wrote() const {
        if (!name_taken(sidecar_))
            return expected_.has_value();
        return !expected_ || !lies_there(*expected_);
    }

    /// A program that writes in place leaves half a file for a moment.
    std::string look_again() {
        if (!name_taken(sidecar_)) {
            leave_base();
            expected_.reset();
            base_.reset();
            return {};
        }
        for (int tries = 0; tries < most_tries; ++tries) {
            if (is_whole(read_whole(sidecar_, XmpPacket::most_bytes)))
                break;
            std::this_thread::sleep_for(pause_for_writer);
        }
        return look();
    }

    /// What our sidecar took the place of is what we read, or somebody wrote at that very moment: then theirs
    /// is the new base, and ours is what lies there now.
    std::string check_displaced(NewFile& file, std::string bytes, bool& done) {
        auto displaced = read_whole(file.temporary(), XmpPacket::most_bytes);
        if (displaced && *displaced == *expected_) {
            done = true;
            return {};
        }
        for (int tries = 0; tries < most_tries && !is_whole(displaced); ++tries) {
            std::this_thread::sleep_for(pause_for_writer);
            displaced = read_whole(file.temporary(), XmpPacket::most_bytes);
        }
        if (!is_whole(displaced)) { // give it back its place
            const std::string reason = file.take_place(Existing::swapped);
            return failure("another program is writing to it." + (reason.empty() ? "" : " " + reason));
        }
        leave_base();
        expected_ = std::move(bytes);
        base_ = *std::move(displaced);
        base_is_displaced_ = true;
        displaced_.push_back(std::move(file));
        return {};
    }

    /// Another program wrote over ours of before, which holds nothing of what that displaced.
    void leave_base() {
        if (std::exchange(base_is_displaced_, false))
            missed_.push_back(*std::move(base_));
    }

    /// What ours displaced was not changed in the end: it gets its place again, unless somebody has written there since.
    void give_back() {
        if (!displaced_.empty() && !somebody_wrote())
            displaced_.back().take_place(Existing::swapped);
    }

    static bool is_whole(const Result<std::string>& bytes) { return bytes && XmpPacket::from(*bytes).ok(); }

    std::string failure(const std::string& reason) const {
        return "The sidecar " + quoted(sidecar_) + " could not be written: " + reason;
    }

    const fs::path& photo_;
    const SidecarEditor& change_;
    fs::path sidecar_;
    PhotoMetadata own_;
    std::optional<XmpPacket> shared_; ///< of IMG_1.xmp
    std::string start_;               ///< what a new sidecar begins with; empty: nothing
    Behind behind_;
    std::optional<std::string> base_;     ///< what is to be changed; none: nothing is there
    std::optional<std::string> expected_; ///< what should lie at the sidecar's place
    std::vector<NewFile> displaced_;      ///< by ours, until what they say is in the sidecar too
    bool base_is_displaced_ = false;
    std::vector<std::string> missed_; ///< displaced sidecars of which the base knows nothing
};

} // namespace

std::string change_sidecar(const fs::path& photo, const SidecarEditor& change) {
    const FolderLock lock(photo.parent_path());
    if (!lock.held())
        return "The sidecar of " + quoted(photo) + " could not be written: another program is busy there.";
    auto metadata = photo_metadata(photo);
    if (!metadata)
        return metadata.error();
    return SidecarWrite(photo, change, std::move(*metadata)).run();
}

} // namespace tp
