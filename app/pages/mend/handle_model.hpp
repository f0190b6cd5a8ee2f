// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>
#include <QByteArray>
#include <QHash>
#include <QModelIndex>
#include <QPointF>
#include <QString>
#include <QVariant>

#include <vector>

namespace tp {

/// The points of the contour in hand, for the page's items. Rows stay what they are while points only move, so
/// that an item that is focused or pressed stays.
class HandleModel final : public QAbstractListModel {
    Q_OBJECT
public:
    struct Row {
        QPointF place; ///< px of the photograph
        QString name;
        bool operator==(const Row&) const = default;
    };
    enum Role { place_role = Qt::UserRole, name_role };

    using QAbstractListModel::QAbstractListModel;
    void set(std::vector<Row> rows);
    const std::vector<Row>& rows() const { return rows_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

private:
    std::vector<Row> rows_;
};

} // namespace tp
