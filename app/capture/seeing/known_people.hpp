// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/identity/named_faces.hpp"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace tp {

/// By what people of the album are known before the camera: told on the page's thread, asked on any.
class KnownPeople {
public:
    using List = std::shared_ptr<const std::vector<NamedFaces>>;

    void know(std::vector<NamedFaces> people) {
        auto list = std::make_shared<const std::vector<NamedFaces>>(std::move(people));
        const std::lock_guard lock(mutex_);
        list_ = std::move(list);
    }
    /// Never null.
    List list() const {
        const std::lock_guard lock(mutex_);
        return list_;
    }

private:
    mutable std::mutex mutex_;
    List list_ = std::make_shared<const std::vector<NamedFaces>>();
};

} // namespace tp
