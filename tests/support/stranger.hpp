// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace tp::mock {

/// Makes this process one that may use only those nodes of a umockdev test bed that are not forbidden; for a
/// while.
class Stranger {
public:
    /// `root` is the bed's folder, `nodes` all of its nodes that this is about.
    Stranger(const std::string& root, const std::vector<std::string>& nodes,
             const std::vector<std::string>& forbidden) {
        for (const std::string& node : nodes)
            ::chmod((root + node).c_str(), 0666);
        for (const std::string& node : forbidden)
            good_ = good_ && ::chmod((root + node).c_str(), 0) == 0;
        if (!root_)
            return;
        // umockdev's own ways to the test bed stay open to all.
        good_ = good_ && ::chmod(root.c_str(), 0777) == 0;
        for (const std::string& node : nodes)
            ::chmod((root + "/ioctl" + node).c_str(), 0777);
        good_ = good_ && ::seteuid(65534) == 0;
    }
    ~Stranger() {
        if (root_ && ::seteuid(0) != 0) {
            std::fputs("this process cannot be root again\n", stderr);
            std::abort();
        }
    }
    Stranger(const Stranger&) = delete;
    Stranger& operator=(const Stranger&) = delete;
    bool good() const { return good_; }

private:
    bool root_ = ::geteuid() == 0; // whom no permission keeps out
    bool good_ = true;
};

} // namespace tp::mock
