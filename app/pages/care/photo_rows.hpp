// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/open/open_album.hpp"
#include "app/pages/care/face_finder.hpp"
#include "app/pages/care/thumbnails.hpp"

#include <QAbstractListModel>
#include <QHash>
#include <QModelIndex>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace tp {

/// The photographs of the album as rows: by time, newest first, or those first whose faces look wrong. Rows by time come
/// from the index as the list is scrolled. To rank them all are gathered, a part at each turn of the event loop, and until then
/// the rows stay as they were. What a row says is asked when it is shown.
class PhotoRows final : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(Order order READ order WRITE setOrder NOTIFY orderChanged)
    Q_PROPERTY(int total READ total NOTIFY totalChanged) ///< photographs in the album
    Q_PROPERTY(int leftToJudge READ leftToJudge NOTIFY totalChanged)
public:
    enum class Order { NewestFirst, LooksWrong };
    Q_ENUM(Order)
    enum Role { NameRole = Qt::UserRole + 1, DetailRole, PictureRole };
    static constexpr std::size_t page_size = 50;

    /// All must outlive it. `language` is that of descriptions.
    PhotoRows(OpenAlbum& album, FaceFinder& finder, Thumbnails& thumbnails,
              std::function<QString()> language);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;
    bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;

    Order order() const { return order_; }
    void setOrder(Order order);
    int total() const { return total_; }
    int leftToJudge() const { return static_cast<int>(finder_.left_to_judge()); }

    std::filesystem::path photo(int row) const;
    /// −1: not among the rows that are there.
    int row_of(const std::filesystem::path& photo) const;
    /// Rows stay where they are; what is new, gone or changed is taken over.
    void refresh();

signals:
    void orderChanged();
    void totalChanged();

private:
    struct Row {
        PhotoEntry entry;
        std::size_t nth = 0; ///< by time, from the newest
        double wrong = 0.0;  ///< when it was ranked; 0 by time
    };
    using Rows = std::vector<std::unique_ptr<Row>>;

    std::vector<PhotoEntry> newest(std::size_t count, const std::optional<PlaceInList>& from);
    static bool stands_before(const Row& a, const Row& b);
    static void append(Rows& rows, std::vector<PhotoEntry> entries);
    void take_over(Rows rows);
    double wrongness(const std::filesystem::path& photo) const;
    void gather();
    void gather_some();
    void rank_gathered();
    void move_to_its_rank(const std::filesystem::path& photo);
    QString detail(const PhotoEntry& entry) const;

    OpenAlbum& album_;
    FaceFinder& finder_;
    Thumbnails& thumbnails_;
    std::function<QString()> language_;
    Order order_ = Order::NewestFirst;
    Rows rows_; ///< in the order of `stands_before`
    std::unordered_map<std::string, const Row*> by_path_;
    bool more_ = false;
    Rows gathered_;
    QTimer gathering_;
    bool gather_again_ = false; ///< the album changed meanwhile
    int total_ = 0;
};

} // namespace tp
