// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/vec.hpp"

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <tuple>

namespace tp {

/// A photograph, or a part of it.
struct PicturePart {
    std::filesystem::path photo;
    Rect part{Vec2(0.0), Vec2(1.0)}; ///< 0 … 1 of the picture, turned
    int turned_degrees = 0;          ///< as Extraction::turned_degrees

    auto order() const {
        return std::tie(photo, part.min.x, part.min.y, part.max.x, part.max.y, turned_degrees);
    }
    bool operator<(const PicturePart& other) const { return order() < other.order(); }
};

/// Small pictures of photographs and of parts of them, read on a thread of its own when they are asked for and kept in memory.
class Thumbnails final : public QObject {
    Q_OBJECT
public:
    using Read = std::function<QImage(const PicturePart&)>;
    static constexpr int side_px = 160;
    static constexpr std::size_t most = 600; ///< kept; 60 MB

    /// `read` is for tests; called on the thread.
    explicit Thumbnails(Read read = {}, QObject* parent = nullptr);
    ~Thumbnails() override;

    /// The picture where it is known; else `came` follows, also for a photograph that cannot be read, whose picture stays
    /// null.
    QImage picture(const PicturePart& part);

signals:
    void came(const std::filesystem::path& photo);

private:
    Read read_;
    std::map<PicturePart, QImage> known_;
    std::set<PicturePart> asked_;
    int next_ = 0;     ///< the newest wish is read first: it is what a person sees now
    QThreadPool pool_; ///< last: it ends before what its work is for
};

} // namespace tp
