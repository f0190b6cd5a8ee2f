// SPDX-License-Identifier: Apache-2.0
#include "app/figures/study/own_experiments.hpp"

#include <QFile>
#include <QString>

namespace tp {

std::optional<std::string> own_experiment(std::string_view name) {
    for (std::size_t i = 0; i < own_experiments.size(); ++i) {
        if (name != own_experiments[i] && name != std::to_string(i + 1))
            continue;
        QFile file(":/studies/" + QString::fromUtf8(own_experiments[i]) + ".study");
        if (file.open(QIODevice::ReadOnly))
            return file.readAll().toStdString();
    }
    return std::nullopt;
}

} // namespace tp
