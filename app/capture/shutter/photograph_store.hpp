// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/keeper/album_keeper.hpp"
#include "app/album/metadata/photo_record.hpp"
#include "app/capture/shutter/photograph_file.hpp"
#include "core/base/result.hpp"

#include <QDateTime>

#include <opencv2/core/mat.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// Where photographs that were just taken are kept: in a folder of an album, as any other photograph of it. Each step is on the disk
/// when it returns; then "taken" may be said. The one thread of its keeper.
class PhotographStore {
public:
    /// The keeper must outlive it. `folder`: absolute, the album's own or one in it; made where it is missing.
    PhotographStore(AlbumKeeper& keeper, std::filesystem::path folder)
        : keeper_(keeper), folder_(std::move(folder)) {}

    /// Keeps an upright picture, 8-bit BGR, under its time ("2026-11-26 14.03.22.jpg"), with a sidecar; one undo deletes it again.
    /// `faces`: of whom it is known who they are. Another frame of a burst is another call.
    Result<AlbumKeeper::AddedPhoto> keep(const cv::Mat& picture, const PhotographFacts& facts,
                                         const std::vector<FaceRegion>& faces = {});
    /// The same of a picture that is coded already.
    Result<AlbumKeeper::AddedPhoto> keep(const Result<CodedPicture>& picture, const PhotographFacts& facts,
                                         const std::vector<FaceRegion>& faces = {});
    /// The sound of the moment becomes an ambient recording of it; where nothing was done since, the same undo takes both. A
    /// sound that lies among the photograph's recordings, as `MomentRecorder` leaves it, is listed with what it says of itself; any
    /// other file is taken in as one that begins at `begun`, and stays.
    Result<AlbumKeeper::Added> add_moment(const std::filesystem::path& photo,
                                          const std::filesystem::path& sound, const QDateTime& begun = {});

private:
    Result<AlbumKeeper::Added> listed(const std::filesystem::path& photo, const std::filesystem::path& sound);
    Result<AlbumKeeper::Added> taken_in(const std::filesystem::path& photo,
                                        const std::filesystem::path& sound, const QDateTime& begun);

    AlbumKeeper& keeper_;
    std::filesystem::path folder_;
};

} // namespace tp
