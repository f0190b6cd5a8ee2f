// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <QThreadPool>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace tp {

/// A photograph as a screen shows it whole.
struct ShownPicture {
    std::filesystem::path photo;
    QImage image;        ///< upright; null where the photograph cannot be read
    std::string problem; ///< the sentence that says why
    std::string stamp;   ///< of the file when it was read: another one, and it is read again
};

/// Has photographs ready for the screen before a person goes on to them: the one that is wanted is read first, then those
/// that may be wanted next, and those that were shown stay as long as there is room. Reads on threads of its own; all
/// else belongs to the thread that made it, which needs an event loop.
class PictureAhead final : public QObject {
    Q_OBJECT
public:
    using Read = std::function<ShownPicture(const std::filesystem::path&, QSize screen)>;

    /// `screen` in pixels; at most `most_bytes` of pixels are held, besides the one that is wanted. `read` is for tests.
    explicit PictureAhead(QSize screen, std::size_t most_bytes = std::size_t{96} << 20, Read read = {},
                          QObject* parent = nullptr);
    ~PictureAhead() override;

    /// Asks for `photo`. `ready` follows: before this returns where it is held, later otherwise; only for the newest one
    /// asked for. `next` are those that a person may want after it, the likeliest first.
    void show(const std::filesystem::path& photo, std::vector<std::filesystem::path> next = {});

    /// Pixels of the photographs that are held besides the one that is wanted, bytes.
    std::size_t held_bytes() const;

signals:
    void ready(std::shared_ptr<const tp::ShownPicture> picture);
    /// Nothing is being read, and all of `next` is held that there is room for.
    void idle();

private:
    using Held = std::list<std::shared_ptr<const ShownPicture>>; ///< last shown or read first

    Held::iterator find(const std::filesystem::path& photo);
    void go_on();
    void start(const std::filesystem::path& photo);
    void take(std::shared_ptr<const ShownPicture> picture);
    void make_room();

    QSize screen_;
    std::size_t most_bytes_;
    Read read_;
    Held held_;
    std::filesystem::path wanted_;
    bool answered_ = true; ///< `wanted_` was
    std::vector<std::filesystem::path> next_;
    std::set<std::filesystem::path> reading_;
    QThreadPool pool_; ///< last: it ends before what its work is for
};

} // namespace tp
