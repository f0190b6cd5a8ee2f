// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/grouping/people.hpp"
#include "app/pages/care/thumbnails.hpp"

#include <QAbstractListModel>
#include <QHash>
#include <QModelIndex>
#include <QtQml/qqmlregistration.h>

#include <vector>

namespace tp {

/// The faces of one person as rows: those first of which nobody has said yet who they are.
class GroupFaces final : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")
public:
    enum Role { TextRole = Qt::UserRole + 1, DetailRole, PictureRole };

    /// The pictures must outlive it.
    explicit GroupFaces(Thumbnails& pictures);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    const PersonFace* face(int row) const;
    /// Where this face stands now; -1: no more.
    int row_of(const PersonFace& face) const;
    /// Those of this person, or none.
    void take(const Person* person);

private:
    Thumbnails& pictures_;
    std::vector<PersonFace> rows_;
    bool named_ = false; ///< the person has a name
};

} // namespace tp
