// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <string>

namespace tp {

/// A sentence of a room without languages, such as "The file "a.jpg" cannot be read.", in the person's language; of a
/// sentence within it ("…: the disk is full.") and of several one after the other, each. Names in it stay as they are, and
/// so does what is no sentence of ours. Without a catalogue it is the English text. In any thread; its work grows with the
/// text's length and no faster, whatever is in it.
QString in_persons_language(const QString& english);
QString in_persons_language(const std::string& english);

} // namespace tp
