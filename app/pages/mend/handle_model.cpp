// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/handle_model.hpp"

#include <QHash>
#include <QModelIndex>
#include <QVariant>

#include <utility>

namespace tp {

void HandleModel::set(std::vector<Row> rows) {
    if (rows.size() != rows_.size()) {
        beginResetModel();
        rows_ = std::move(rows);
        endResetModel();
        return;
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!(rows[i] == rows_[i])) {
            rows_[i] = std::move(rows[i]);
            const QModelIndex changed = index(static_cast<int>(i));
            emit dataChanged(changed, changed);
        }
}

int HandleModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant HandleModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    return role == place_role ? QVariant(row.place) : role == name_role ? QVariant(row.name) : QVariant();
}

QHash<int, QByteArray> HandleModel::roleNames() const { return {{place_role, "place"}, {name_role, "name"}}; }

} // namespace tp
