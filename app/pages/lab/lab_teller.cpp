// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_teller.hpp"

namespace tp {

LabTeller::LabTeller(Narrator& narrator) : narrator_(narrator), status_(tr("Nothing is running.")) {}

void LabTeller::keep(const QString& sentence, Priority priority) {
    status_ = sentence;
    emit changed();
    narrator_.tell(sentence, priority);
}

} // namespace tp
