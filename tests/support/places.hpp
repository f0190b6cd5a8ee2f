// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp::test {

/// The full path of a file or folder of the sources, named from the project's root. It stays valid until the
/// program ends. Where the sources lie is compiled into this one file only: all other objects of the tests are
/// the same in every clone.
const char* in_source(const char* path);

/// The same below ../shared, which not every clone has beside it.
const char* in_shared(const char* path);

/// The same below the folder of the build that the test is part of.
const char* in_build(const char* path);

} // namespace tp::test
