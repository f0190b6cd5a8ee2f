// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// While it is there, the disk is full for each file that is to get a name with `part` in its path.
class FullDisk {
public:
    explicit FullDisk(const std::string& part);
    ~FullDisk();
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
};

/// While it is there, each file that is to get a name with `part` in its path waits until it is let.
class SlowDisk {
public:
    explicit SlowDisk(const std::string& part);
    /// Lets all of them.
    ~SlowDisk();
    SlowDisk(const SlowDisk&) = delete;
    SlowDisk& operator=(const SlowDisk&) = delete;

    /// One waits.
    bool waits() const;
    /// So many, those that come later included.
    void let(int files);
};
