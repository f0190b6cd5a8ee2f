// SPDX-License-Identifier: Apache-2.0
#include "places.hpp"

#include <mutex>
#include <set>
#include <string>

namespace tp::test {

namespace {

const char* kept(const char* root, const char* path) {
    static std::mutex mutex;
    static std::set<std::string> paths;
    const std::lock_guard lock(mutex);
    return paths.insert(std::string(root) + "/" + path).first->c_str();
}

} // namespace

const char* in_source(const char* path) { return kept(TP_SOURCE_DIR, path); }
const char* in_shared(const char* path) { return kept(TP_SHARED_DIR, path); }
const char* in_build(const char* path) { return kept(TP_BUILD_DIR, path); }

} // namespace tp::test
