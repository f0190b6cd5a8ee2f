// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_settings.hpp"
#include "app/pages/explore/explore_view.hpp"
#include "app/pages/explore/explore_words.hpp"
#include "app/pages/explore/photo_loader.hpp"

#include <QObject>
#include <QSet>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <memory>

namespace tp {

/// The way through the album from face to face: photographs on which nothing can be felt are passed over.
///
/// It is on the way while the view looks into photographs for it: until one can be felt, the album ends, the person gives
/// up or opens another. At the album's end what was open is open again.
class ExploreWalk final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")
public:
    /// All must outlive this.
    ExploreWalk(const ExploreSettings& settings, ExploreView& view, ExploreWords& words);

    /// On to the next photograph of the album with a face, or back to the one before. Returns at once.
    Q_INVOKABLE void next() { set_out(Way::forward); }
    Q_INVOKABLE void previous() { set_out(Way::backward); }
    /// To the newest with a face. In an album that has no photograph yet it sets out when one has come.
    void newest();
    /// The album has other photographs than before.
    void album_changed();

signals:
    /// What sounds or moves is to end.
    void setting_out();

private:
    enum class Way { forward, backward, newest };
    void set_out(Way way);
    void look_into(const QString& file);
    void judge(const std::shared_ptr<const LoadedPhoto>& photo);
    void end_of_album();
    QString beside(const QString& file) const;
    int passed() const { return static_cast<int>(passed_.size()); }

    ExploreSettings::Beside beside_;
    ExploreView& view_;
    ExploreWords& words_;
    Way way_ = Way::forward;
    QString at_;           ///< the photograph that is looked into
    QSet<QString> passed_; ///< without a face; the album may change on the way, and none comes twice
    bool waiting_ = false; ///< for the album's first photograph
};

} // namespace tp
