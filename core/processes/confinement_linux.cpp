// SPDX-License-Identifier: Apache-2.0
#include "core/processes/confinement.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <memory>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TP_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TP_SANITIZED 1
#endif
#endif

namespace tp {
namespace {

// What computing, memory, threads, and the descriptors that are open need.
constexpr std::array allowed{
    SCMP_SYS(brk),          SCMP_SYS(mremap),      SCMP_SYS(munmap),          SCMP_SYS(madvise),
    SCMP_SYS(futex),        SCMP_SYS(rseq),        SCMP_SYS(set_robust_list), SCMP_SYS(sched_yield),
    SCMP_SYS(exit),         SCMP_SYS(exit_group),  SCMP_SYS(membarrier),      SCMP_SYS(sched_getaffinity),
    SCMP_SYS(gettid),       SCMP_SYS(getpid),      SCMP_SYS(rt_sigaction),    SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack), SCMP_SYS(clock_gettime),   SCMP_SYS(clock_getres),
    SCMP_SYS(gettimeofday), SCMP_SYS(nanosleep),   SCMP_SYS(clock_nanosleep), SCMP_SYS(restart_syscall),
    SCMP_SYS(getrandom),    SCMP_SYS(uname),       SCMP_SYS(sysinfo),         SCMP_SYS(read),
    SCMP_SYS(readv),        SCMP_SYS(pread64),     SCMP_SYS(write),           SCMP_SYS(writev),
    SCMP_SYS(lseek),        SCMP_SYS(fstat),       SCMP_SYS(close),           SCMP_SYS(poll),
    SCMP_SYS(ppoll),        SCMP_SYS(sendmsg),     SCMP_SYS(memfd_create),    SCMP_SYS(ftruncate),
    SCMP_SYS(recvmsg)};

// Of fcntl(2). The commands that have a descriptor send signals are not among them: by F_SETOWN and F_SETSIG any process of
// the person could be ended.
constexpr std::array allowed_of_descriptors{F_GETFD,         F_SETFD,     F_GETFL,
                                            F_DUPFD_CLOEXEC, F_ADD_SEALS, F_GET_SEALS};

class Filter {
public:
    /// What no rule allows fails as what is not permitted does.
    Filter() : context_(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release) {
        if (!context_)
            errno = ENOMEM;
    }

    bool add(std::uint32_t action, int call) {
        return context_ && noted(seccomp_rule_add(context_.get(), action, call, 0));
    }
    bool add(std::uint32_t action, int call, scmp_arg_cmp where) {
        return context_ && noted(seccomp_rule_add_array(context_.get(), action, call, 1, &where));
    }
    bool load() { return context_ && noted(seccomp_load(context_.get())); }

private:
    /// libseccomp returns what the system says, negated, and leaves errno as it was.
    static bool noted(int result) {
        if (result < 0)
            errno = -result;
        return result >= 0;
    }
    std::unique_ptr<void, decltype(&seccomp_release)> context_;
};

#if defined(TP_SANITIZED)
constexpr std::array for_sanitizers{SCMP_SYS(pipe2)}; ///< by which they ask whether memory is there
#else
constexpr std::array<int, 0> for_sanitizers{};
#endif

constexpr scmp_datum_t thread_flags = CLONE_THREAD | CLONE_VM;

/// Of a call's argument, counted from 0. As functions, because libseccomp's macros are C.
scmp_arg_cmp equal(unsigned argument, scmp_datum_t value) { return {argument, SCMP_CMP_EQ, value, 0}; }
scmp_arg_cmp masked(unsigned argument, scmp_datum_t mask, scmp_datum_t value) {
    return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

bool filter_calls() {
    Filter filter;
    const auto allow = [&](int call) { return filter.add(SCMP_ACT_ALLOW, call); };
    const auto self = static_cast<scmp_datum_t>(getpid());
    return std::all_of(allowed.begin(), allowed.end(), allow) &&
           std::all_of(for_sanitizers.begin(), for_sanitizers.end(), allow) &&
           // memory that cannot be executed
           filter.add(SCMP_ACT_ALLOW, SCMP_SYS(mmap), masked(2, PROT_EXEC, 0)) &&
           filter.add(SCMP_ACT_ALLOW, SCMP_SYS(mprotect), masked(2, PROT_EXEC, 0)) &&
           std::all_of(allowed_of_descriptors.begin(), allowed_of_descriptors.end(),
                       [&](int command) {
                           return filter.add(SCMP_ACT_ALLOW, SCMP_SYS(fcntl),
                                             equal(1, static_cast<scmp_datum_t>(command)));
                       }) &&
           // threads, and no processes; of clone3, whose flags a filter cannot see, glibc does without
           filter.add(SCMP_ACT_ALLOW, SCMP_SYS(clone), masked(0, thread_flags, thread_flags)) &&
           filter.add(SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3)) &&
           // itself: its threads' names, its end, its limits
           filter.add(SCMP_ACT_ALLOW, SCMP_SYS(prctl), equal(0, PR_SET_NAME)) &&
           filter.add(SCMP_ACT_ALLOW, SCMP_SYS(tgkill), equal(0, self)) &&
           filter.add(SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), equal(0, 0)) && filter.load();
}

bool limit(int what, std::uint64_t to) {
    const rlimit limits{to, to};
    return setrlimit(static_cast<__rlimit_resource>(what), &limits) == 0;
}

/// Where memory is short, this process goes before the program that a person uses.
void be_ended_first() {
    const int score = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
    if (score < 0)
        return;
    static_cast<void>(!::write(score, "1000", 4)); // a wish; without it the system chooses
    ::close(score);
}

std::string reason(const char* what) { return std::string(what) + ": " + std::strerror(errno); }

std::string problem_in_confining(const Limits& limits) {
    be_ended_first();
    if (!limit(RLIMIT_CORE, 0) || !limit(RLIMIT_FSIZE, limits.memory_bytes) ||
        !limit(RLIMIT_NOFILE, static_cast<std::uint64_t>(limits.descriptors)))
        return reason("limits");
#if !defined(TP_SANITIZED) // which take terabytes of addresses for themselves
    if (!limit(RLIMIT_AS, limits.memory_bytes))
        return reason("memory");
#endif
    if (prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) != 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        return reason("privileges");
    return filter_calls() ? std::string() : reason("seccomp");
}

} // namespace

Confinement confine(const Limits& limits) { return {problem_in_confining(limits), Descriptor()}; }

void compute_no_longer_than(int seconds) {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    rlimit limits{};
    getrlimit(RLIMIT_CPU, &limits);
    limits.rlim_cur = std::min<rlim_t>(limits.rlim_max, static_cast<rlim_t>(now.tv_sec + 1 + seconds));
    setrlimit(RLIMIT_CPU, &limits);
}

} // namespace tp
