// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/grouping/people.hpp"
#include "app/album/index/album_index.hpp"
#include "app/album/index/known_faces.hpp"
#include "core/base/result.hpp"
#include "faces/identity/face_groups.hpp"

#include <QObject>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace tp {

/// Groups the faces of an index as they come, follows what the sidecars say of them, and keeps all that in the index:
/// whenever a call returns, a program that is ended goes on from there. All on one thread.
class GroupWorker final : public QObject {
    Q_OBJECT
public:
    /// Opens `index`, which must outlive this, once more at the first call.
    explicit GroupWorker(const AlbumIndex& index) : shared_(index) {}

    struct Report {
        bool changed = false; ///< groups may be others than before
        bool more = false;    ///< there is more to group
    };
    /// Groups the faces of so many photographs.
    Report group(std::size_t photos);

    People people();
    /// For the faces of a photograph of which nobody has said who they are.
    std::vector<FaceOffer> offers(const std::filesystem::path& photo);

    /// By what people who have names are known in a picture of today.
    std::vector<NamedFaces> named();

    /// What a person says of groups alone; the sentence that says why not, where it cannot be kept.
    using Word = std::function<std::optional<GroupsChange>(FaceGroups&)>;
    Result<GroupsChange> say(const Word& word);
    std::string undo(const GroupsChange& change);

    /// Nothing is kept of faces any more; false where nothing was.
    bool forget();

private:
    bool ready();
    void load();
    void follow(const FacesToGroup& next, GroupsKept& kept);
    void follow_word(const StoredFace& face, const std::string& said);
    bool says(GroupId group, const std::string& name) const;
    std::string keep(GroupsKept kept);

    const AlbumIndex& shared_;
    std::unique_ptr<AlbumIndex> index_;
    FaceGroups groups_;
    GroupsState stored_; ///< as the index has it
    std::unordered_map<FaceId, std::string> said_;
};

} // namespace tp
