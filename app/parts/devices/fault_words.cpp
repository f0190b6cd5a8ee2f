// SPDX-License-Identifier: Apache-2.0
#include "app/parts/devices/fault_words.hpp"

#include "audio/sentences/sentences.hpp"

#include <string>

namespace tp {

QString fault_words(Fault fault) { return in_persons_language(std::string(sentence(fault))); }

} // namespace tp
