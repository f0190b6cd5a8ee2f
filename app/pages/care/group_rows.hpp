// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/grouping/people.hpp"
#include "app/pages/care/thumbnails.hpp"

#include <QAbstractListModel>
#include <QHash>
#include <QModelIndex>
#include <QtQml/qqmlregistration.h>

#include <memory>
#include <optional>
#include <vector>

namespace tp {

/// The people of the album as rows. While somebody looks at them a row stays where it is, whatever comes.
class GroupRows final : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")
public:
    enum Role { TextRole = Qt::UserRole + 1, DetailRole, FirstRole, SecondRole, ThirdRole };
    static constexpr std::size_t pictures_shown = 3; ///< of the newest faces

    /// The pictures must outlive it.
    explicit GroupRows(Thumbnails& pictures);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    const Person* person(int row) const;
    /// −1: no row has it.
    int row_of(GroupId group) const;
    /// Rows stay where they are; who is gone goes, who is new comes last.
    void take(const std::shared_ptr<const People>& people);
    /// In the order of the people that come next.
    void begin_anew();

private:
    Thumbnails& pictures_;
    std::vector<Person> rows_;
};

/// A face as the pictures know it.
PicturePart part_of(const PersonFace& face);

} // namespace tp
