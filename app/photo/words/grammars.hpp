// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/words/description.hpp"

namespace tp {

const DescriptionGrammar& english_grammar();
const DescriptionGrammar& german_grammar();
const DescriptionGrammar& korean_grammar();

} // namespace tp
