// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/overlapped_io.hpp"
#include "core/processes/confinement.hpp"

#include <utility>
#include <vector>

namespace tp {
namespace {

using windows::Handle;

constexpr DWORD whole_desktop = JOB_OBJECT_UILIMIT_DESKTOP | JOB_OBJECT_UILIMIT_DISPLAYSETTINGS |
                                JOB_OBJECT_UILIMIT_EXITWINDOWS | JOB_OBJECT_UILIMIT_GLOBALATOMS |
                                JOB_OBJECT_UILIMIT_HANDLES | JOB_OBJECT_UILIMIT_READCLIPBOARD |
                                JOB_OBJECT_UILIMIT_SYSTEMPARAMETERS | JOB_OBJECT_UILIMIT_WRITECLIPBOARD;

/// A job that this process is in from now on; it ends when the last handle of that is closed.
Handle joined_job(const Limits& limits, DWORD not_of_desktop) {
    Handle job(CreateJobObjectW(nullptr, nullptr));
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION held{};
    held.BasicLimitInformation.LimitFlags =
        JOB_OBJECT_LIMIT_PROCESS_MEMORY | JOB_OBJECT_LIMIT_ACTIVE_PROCESS |
        JOB_OBJECT_LIMIT_DIE_ON_UNHANDLED_EXCEPTION | JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
    held.BasicLimitInformation.ActiveProcessLimit = 1;
    held.ProcessMemoryLimit = limits.memory_bytes;
    JOBOBJECT_BASIC_UI_RESTRICTIONS desktop{not_of_desktop};
    const bool joined =
        job &&
        SetInformationJobObject(job.get(), JobObjectExtendedLimitInformation, &held, sizeof held) != 0 &&
        (not_of_desktop == 0 ||
         SetInformationJobObject(job.get(), JobObjectBasicUIRestrictions, &desktop, sizeof desktop) != 0) &&
        AssignProcessToJobObject(job.get(), GetCurrentProcess()) != 0;
    return joined ? std::move(job) : Handle();
}

/// Whether it holds for good from now on.
template <typename Policy>
bool held(PROCESS_MITIGATION_POLICY which, Policy policy) {
    return SetProcessMitigationPolicy(which, &policy, sizeof policy) != 0;
}

bool starts_no_process() {
    PROCESS_MITIGATION_CHILD_PROCESS_POLICY policy{};
    policy.NoChildProcessCreation = 1;
    return held(ProcessChildProcessPolicy, policy);
}

bool makes_no_code() {
    PROCESS_MITIGATION_DYNAMIC_CODE_POLICY policy{};
    policy.ProhibitDynamicCode = 1;
    return held(ProcessDynamicCodePolicy, policy);
}

bool loads_nobody_s_code() {
    PROCESS_MITIGATION_BINARY_SIGNATURE_POLICY signatures{};
    signatures.MicrosoftSignedOnly = 1;
    PROCESS_MITIGATION_EXTENSION_POINT_DISABLE_POLICY extensions{};
    extensions.DisableExtensionPoints = 1;
    return held(ProcessSignaturePolicy, signatures) && held(ProcessExtensionPointDisablePolicy, extensions);
}

/// A wish: not where a library has called that part of the kernel already.
void without_win32k() {
    PROCESS_MITIGATION_SYSTEM_CALL_DISABLE_POLICY policy{};
    policy.DisallowWin32kSystemCalls = 1;
    static_cast<void>(held(ProcessSystemCallDisablePolicy, policy));
}

bool without_privileges(HANDLE token) {
    DWORD size = 0;
    GetTokenInformation(token, TokenPrivileges, nullptr, 0, &size);
    std::vector<unsigned char> room(size);
    auto* const all = reinterpret_cast<TOKEN_PRIVILEGES*>(room.data());
    if (size == 0 || GetTokenInformation(token, TokenPrivileges, all, size, &size) == 0)
        return false;
    for (DWORD i = 0; i < all->PrivilegeCount; ++i)
        all->Privileges[i].Attributes = SE_PRIVILEGE_REMOVED;
    return AdjustTokenPrivileges(token, FALSE, all, 0, nullptr, nullptr) != 0 &&
           GetLastError() == ERROR_SUCCESS;
}

bool trusted_by_nobody(HANDLE token) {
    SID nobody{SID_REVISION, 1, SECURITY_MANDATORY_LABEL_AUTHORITY, {SECURITY_MANDATORY_UNTRUSTED_RID}};
    TOKEN_MANDATORY_LABEL label{{&nobody, SE_GROUP_INTEGRITY}};
    return SetTokenInformation(token, TokenIntegrityLevel, &label, sizeof label + sizeof nobody) != 0;
}

std::string reason(const char* what) { return std::string(what) + ": " + std::to_string(GetLastError()); }

std::string problem_in_giving_up() {
    HANDLE own = nullptr;
    OpenProcessToken(GetCurrentProcess(), TOKEN_QUERY | TOKEN_ADJUST_PRIVILEGES | TOKEN_ADJUST_DEFAULT, &own);
    const Handle token(own);
    if (!token || !without_privileges(token.get()))
        return reason("privileges");
    if (!trusted_by_nobody(token.get()))
        return reason("integrity");
    without_win32k();
    if (!starts_no_process())
        return reason("processes");
    if (!loads_nobody_s_code())
        return reason("libraries");
    return makes_no_code() ? std::string() : reason("code");
}

} // namespace

Confinement confine(const Limits& limits) {
    Handle job = joined_job(limits, whole_desktop);
    if (!job)
        job =
            joined_job(limits, 0); // where the program that asks is in a job of its own, as some shells do it
    if (!job)
        return {reason("job"), Descriptor()};
    return {problem_in_giving_up(), Descriptor(reinterpret_cast<DescriptorNumber>(job.release()))};
}

void compute_no_longer_than(int) {}

} // namespace tp
