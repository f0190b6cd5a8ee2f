// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

namespace tp {

/// Small pictures of photographs, read on a thread of its own when they are asked for and kept in memory.
class Thumbnails final : public QObject {
    Q_OBJECT
public:
    using Read = std::function<QImage(const std::filesystem::path&)>;
    static constexpr int side_px = 160;
    static constexpr std::size_t most = 600; ///< kept; 60 MB

    /// `read` is for tests; called on the thread.
    explicit Thumbnails(Read read = {}, QObject* parent = nullptr);
    ~Thumbnails() override;

    /// The picture where it is known; else `came` follows, also for a photograph that cannot be read, whose picture stays
    /// null.
    QImage picture(const std::filesystem::path& photo);

signals:
    void came(const std::filesystem::path& photo);

private:
    Read read_;
    std::map<std::filesystem::path, QImage> known_;
    std::set<std::filesystem::path> asked_;
    int next_ = 0;     ///< the newest wish is read first: it is what a person sees now
    QThreadPool pool_; ///< last: it ends before what its work is for
};

} // namespace tp
