// SPDX-License-Identifier: Apache-2.0
#include "app/devices/device_words.hpp"

#include "audio/sentences/sentences.hpp"

namespace tp {

QString fault_words(Fault fault) { return in_persons_language(std::string(sentence(fault))); }

QString device_words(const std::string& words) { return in_persons_language(words); }

} // namespace tp
